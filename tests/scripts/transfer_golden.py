"""Writes tests/data/transfer_functions.json: gain and zeros of transfer functions, by python-control and SciPy.

    python3 -m venv venv && venv/bin/pip install numpy scipy control==0.10.2
    venv/bin/python tests/scripts/transfer_golden.py

The aircraft are those of tests/data/models.json. Zeros are the finite generalised eigenvalues of Rosenbrock's pencil
(scipy.linalg.eigvals, LAPACK's QZ); how many are finite follows from the relative degree, by the first Markov parameter that is not zero.
The gain is that with which the product of the factors is the value of python-control's state space at a complex s.
"""

import json
import math
import pathlib

import control
import numpy as np
import scipy

ROOT = pathlib.Path(__file__).resolve().parent.parent / "data"
MODELS = json.loads((ROOT / "models.json").read_text())["models"]
CHOSEN = ["navion_teper_sl", "b747_etkin_cruise", "b747_cr2144_fc10", "cherokee180_mccormick", "nt33a_fc1", "x15_m05_sl"]
SIGNALS = {
    "longitudinal": ["u", "alpha", "q", "theta", "h", "nz"],
    "lateral": ["beta", "p", "r", "phi", "psi", "ny"],
}
INPUTS = {"longitudinal": ["elevator", "throttle"], "lateral": ["aileron", "rudder"]}


def rows(model, plane):
    """A, B, C, D with height or heading as a fifth state."""
    trim = model["trim"]
    v, alpha0, gamma0, g = trim["speed"], trim["alpha0"], trim["gamma0"], trim["gravity"]
    theta0 = alpha0 + gamma0
    u0, w0 = v * math.cos(alpha0), v * math.sin(alpha0)
    a4, b4 = np.array(model[plane]["a"]), np.array(model[plane]["b"])
    a, b, c, d = np.zeros((5, 5)), np.zeros((5, 2)), np.zeros((6, 5)), np.zeros((6, 2))
    a[:4, :4], b[:4] = a4, b4
    if plane == "longitudinal":
        a[4, :4] = [math.sin(theta0), -math.cos(theta0), 0, v * math.cos(gamma0)]
        c[0, 0] = c[2, 2] = c[3, 3] = c[4, 4] = 1
        c[1, :2] = [-math.sin(alpha0) / v, math.cos(alpha0) / v]
        fx = a4[0] + [0, 0, w0, g * math.cos(theta0)]
        fz = a4[1] + [0, 0, -u0, g * math.sin(theta0)]
        c[5, :4] = (fx * math.sin(alpha0) - fz * math.cos(alpha0)) / g
        d[5] = (b4[0] * math.sin(alpha0) - b4[1] * math.cos(alpha0)) / g
    else:
        a[4, 2] = 1 / math.cos(theta0)
        c[0, 0] = 1 / v
        c[1, 1] = c[2, 2] = c[3, 3] = c[4, 4] = 1
        c[5, :4] = (a4[0] + [0, -w0, u0, -g * math.cos(theta0)]) / g
        d[5] = b4[0] / g
    return a, b, c, d


def degree(a, b, c, d):
    """How many more poles than zeros; None where the digits that are printed don't tell."""
    if d != 0:
        return 0
    power = b
    for r in range(1, len(a) + 1):
        size = abs(c @ power) / (np.linalg.norm(c) * np.linalg.norm(power))
        if size > 1e-12:
            return r if size > 1e-6 else None
        power = a @ power
    return None


cases = []
for model in (model for model in MODELS if model["id"] in CHOSEN):
    for plane, inputs in INPUTS.items():
        a5, b5, c5, d5 = rows(model, plane)
        for i, name in enumerate(inputs):
            for k, output in enumerate(SIGNALS[plane]):
                n = 5 if output in ("h", "psi") else 4
                a, b, c, d = a5[:n, :n], b5[:n, i], c5[k, :n], d5[k, i]
                r = degree(a, b, c, d) if np.any(b) else None
                if r is None:
                    continue
                pencil = np.block([[a, b[:, None]], [c[None, :], np.array([[d]])]])
                right = np.zeros((n + 1, n + 1))
                right[:n, :n] = np.eye(n)
                finite = scipy.linalg.eigvals(pencil, right)
                zeros = sorted(finite[np.isfinite(finite)], key=abs)[: n - r]
                s = 1 + 2j
                value = complex(control.ss(a, b[:, None], c[None, :], [[d]])(s))
                gain = value * np.prod(s - np.linalg.eigvals(a)) / np.prod(s - np.array(zeros))
                if abs(gain) < 1e-6:
                    continue  # What the rounding of printed digits has left of a zero.
                assert abs(gain.imag) < 1e-7 * abs(gain), (model["id"], name, output, gain)
                case = {"aircraft": model["id"], "plane": plane, "input": name, "output": output}
                case |= {"gain": gain.real, "zeros": [[float(z.real), float(z.imag)] for z in zeros]}
                cases.append(case)

source = f"python-control {control.__version__}, SciPy {scipy.__version__}: scripts/transfer_golden.py"
lines = ",\n".join(json.dumps(case) for case in cases)
(ROOT / "transfer_functions.json").write_text(f'{{"source": {json.dumps(source)}, "cases": [\n{lines}\n]}}\n')
print(len(cases))
