"""Writes tests/data/feedback: aircraft under laws of feedback, by python-control, and eigenvalues of larger matrices, by LAPACK.

    python3 -m venv venv && venv/bin/pip install numpy scipy control==0.10.2
    venv/bin/python tests/scripts/feedback_golden.py

The aircraft are those of tests/data/models.json. Each loop is put together from transfer functions, as on a blackboard: aircraft with
its measured outputs, washout s/(s + 1/T), gains, actuator 1/(tau s + 1), closed by control.feedback. Margins are those of
control.stability_margins, refined on the frequency response of the same system.
"""

import json
import math
import pathlib

import control
import numpy as np
import scipy
from scipy.linalg import companion, eigvals
from scipy.optimize import brentq, minimize_scalar

ROOT = pathlib.Path(__file__).resolve().parent.parent / "data"
MODELS = {model["id"]: model for model in json.loads((ROOT / "models.json").read_text())["models"]}
SIGNALS = {"longitudinal": ["u", "alpha", "q", "theta", "h"], "lateral": ["beta", "p", "r", "phi", "psi"]}
INPUTS = {"longitudinal": ["de", "dt"], "lateral": ["da", "dr"]}


def aircraft(model, plane, path):
    """The four states, with one more for height or heading; outputs: what is measured, in the order of SIGNALS."""
    trim = model["trim"]
    v, alpha0, gamma0 = trim["speed"], trim["alpha0"], trim["gamma0"]
    theta0 = alpha0 + gamma0
    a4, b4 = np.array(model[plane]["a"]), np.array(model[plane]["b"])
    a, b = np.zeros((5, 5)), np.zeros((5, 2))
    a[:4, :4], b[:4] = a4, b4
    c = np.zeros((5, 5))
    if plane == "longitudinal":
        a[4, :4] = [math.sin(theta0), -math.cos(theta0), 0, v * math.cos(gamma0)]
        c[0, 0] = c[2, 2] = c[3, 3] = c[4, 4] = 1
        c[1, :2] = [-math.sin(alpha0) / v, math.cos(alpha0) / v]
    else:
        a[4, 2] = 1 / math.cos(theta0)
        c[0, 0] = 1 / v
        c[1, 1] = c[2, 2] = c[3, 3] = c[4, 4] = 1
    n = 5 if path else 4
    return control.ss(a[:n, :n], b[:n], c[:, :n], np.zeros((5, 2)))


def law(case, plane):
    """From what is measured to what the law moves: washout, gains, and the actuators apart."""
    gains = np.array([[case["gains"].get(f"{s}_{i}", 0.0) for s in SIGNALS[plane]] for i in INPUTS[plane]])
    through = control.tf([1], [1])
    washout = control.tf([1, 0], [1, 1 / case["washout"]]) if case["washout"] else through
    paths = [through, through, washout, through, through]
    filters = control.append(*[control.ss(path) for path in paths])
    if not any(key.startswith(("q_", "r_")) for key in case["gains"]):
        filters = control.append(*[control.ss(through)] * 5)
    lags = [case["actuator"], case["engine"] if plane == "longitudinal" else case["actuator"]]
    lags = [lag if np.any(of) else 0 for lag, of in zip(lags, gains)]
    actuators = control.append(*[control.ss(control.tf([1], [lag, 1]) if lag else through) for lag in lags])
    return control.ss([], [], [], gains) * filters, actuators


def pairs(values):
    return [[float(x.real), float(x.imag)] for x in values]


def loop(measured, controller, actuators, i):
    """L of input i, cut before its actuator, with the other loop closed."""
    other = 1 - i
    # From what enters both actuators to what is asked of both.
    asked = controller * measured * actuators
    k = np.zeros((2, 2))
    k[other, other] = 1
    partly = control.feedback(asked, control.ss([], [], [], k), sign=1)
    return -1 * control.ss(partly[i, i])


def margins(transfer):
    value = lambda w: complex(transfer(1j * w))
    gm, pm, sm, wpc, wgc, ws = control.stability_margins(transfer, returnall=True)
    found = {"factors": [], "phases": []}
    for w in np.atleast_1d(wpc):
        if 1e-9 < w < 1e4:
            imaginary = lambda w: value(w).imag
            near = [w * (1 - 1e-5), w * (1 + 1e-5)]
            assert imaginary(near[0]) * imaginary(near[1]) < 0, (w, value(w))
            w = brentq(imaginary, *near, xtol=1e-16, rtol=1e-15)
            found["factors"].append([-1 / value(w).real, w])
    for w in np.atleast_1d(wgc):
        assert 1e-9 < w < 1e4
        beyond = lambda w: abs(value(w)) - 1
        w = brentq(beyond, w * (1 - 1e-5), w * (1 + 1e-5), xtol=1e-16, rtol=1e-15)
        found["phases"].append([float(np.angle(-value(w))), w])
    distance = lambda x: abs(1 + value(math.exp(x)))
    nearest = min((float(w) for w in np.atleast_1d(ws)), key=lambda w: abs(1 + value(w)))
    best = minimize_scalar(distance, bounds=[math.log(nearest) - 0.01, math.log(nearest) + 0.01], method="bounded", options={"xatol": 1e-13})
    found["sensitivity"] = [1 / best.fun, math.exp(best.x)]
    return found


def golden(name, identifier, plane, gains, washout=0.0, actuator=0.0, engine=0.0, pilot=0):
    case = {"gains": gains, "washout": washout, "actuator": actuator, "engine": engine}
    system = aircraft(MODELS[identifier], plane, True)
    measured = aircraft(MODELS[identifier], plane, any(key.startswith(("h_", "psi_")) for key in gains))
    controller, actuators = law(case, plane)
    # The pilot's input goes to the surface, beside the actuator.
    closed = control.feedback(system, actuators * controller, sign=1)
    poles = eigvals(control.feedback(measured, actuators * controller, sign=1).A)
    times = np.linspace(0, 20, 21)
    step = control.forced_response(closed, times, np.outer(np.eye(2)[pilot], np.ones(21)) * 0.01)
    at = [0.05, 0.5, 2.0, 9.0]
    driven = [i for i, name in enumerate(INPUTS[plane]) if any(key.endswith(f"_{name}") for key in gains)]
    return {
        "name": name,
        "aircraft": identifier,
        "plane": plane,
        **case,
        "eigenvalues": pairs(poles),
        "pilot": pilot,
        "times": times.tolist(),
        "outputs": step.outputs.T.tolist(),
        "frequencies": at,
        "answers": [[[float(x.real), float(x.imag)] for x in closed(1j * w)[:, pilot]] for w in at],
        "loops": {
            INPUTS[plane][i]: {
                "poles": pairs(eigvals(loop(measured, controller, actuators, i).A)),
                "values": [pairs([complex(loop(measured, controller, actuators, i)(1j * w))])[0] for w in at],
                **margins(loop(measured, controller, actuators, i)),
            }
            for i in driven
        },
    }


def loops():
    rng = np.random.default_rng(747)
    yield golden("yaw damper", "b747_etkin_cruise", "lateral", {"r_dr": 2.32}, 3.0, 0.1, pilot=1)
    yield golden("yaw damper without washout", "b747_cr2144_fc09", "lateral", {"r_dr": 2.65}, 0.0, 0.1, pilot=1)
    yield golden("all to both", "b747_etkin_cruise", "lateral", {"beta_dr": -0.4, "r_dr": 1.5, "phi_da": -0.6, "p_da": -0.8, "psi_da": -0.3, "phi_dr": 0.1}, 4.0, 0.05)
    yield golden("pitch damper", "navion_teper_sl", "longitudinal", {"q_de": 0.3, "alpha_de": 0.5, "theta_de": 0.2}, 2.0, 0.1)
    yield golden("height and speed held", "a4d_fc1", "longitudinal", {"theta_de": 0.8, "q_de": 0.4, "h_de": 0.002, "u_de": -0.001}, 0.0, 0.05)
    yield golden("pitch damper without lag", "nt33a_fc1", "longitudinal", {"q_de": 0.34}, 0.0, 0.0)
    yield golden("wing leveller", "c47_4701", "lateral", {"phi_da": -0.4, "p_da": -0.3}, 0.0, 0.0)
    yield golden("dive", "bristol_f2b", "lateral", {"r_dr": 0.5, "psi_dr": 0.3, "phi_da": -0.5}, 5.0, 0.2)
    for i, identifier in enumerate(["citation_ce500_delft", "x15_m05_sl", "cherokee180_mccormick"]):
        for plane, sizes in [("longitudinal", [0.002, 0.3, 0.3, 0.3, 0.001]), ("lateral", [0.3, 0.3, 0.3, 0.3, 0.1])]:
            inputs = INPUTS[plane][:1] if plane == "longitudinal" else INPUTS[plane]
            gains = {
                f"{s}_{d}": float(np.round(rng.uniform(-1, 1) * size, 5))
                for d in inputs
                for s, size in zip(SIGNALS[plane], sizes)
            }
            yield golden(f"anything {i}", identifier, plane, gains, 1.5, 0.08, 2.0, pilot=0)


def matrices():
    rng = np.random.default_rng(12)
    for n in range(5, 13):
        yield f"random {n}", rng.uniform(-1, 1, (n, n))
        d = 10.0 ** rng.uniform(-4, 4, n)
        yield f"badly scaled {n}", rng.uniform(-1, 1, (n, n)) * d[:, None] / d[None, :]
        sparse = rng.integers(-1, 2, (n, n)) * (rng.uniform(0, 1, (n, n)) < 0.3)
        values = eigvals(sparse.astype(float))
        if np.min(np.abs(values[:, None] - values[None, :]) + np.eye(n)) > 1e-3:
            yield f"sparse {n}", sparse.astype(float)
        yield f"permutation {n}", np.eye(n)[np.roll(np.arange(n), 1)]
        yield f"s^{n} + 1", companion([1] + [0] * (n - 1) + [1])
        yield f"lags in a row {n}", np.diag(-np.arange(1.0, n + 1)) + np.diag(np.ones(n - 1) * 3, -1)


def main():
    head = {
        "source": f"python-control {control.__version__}, SciPy {scipy.__version__}, NumPy {np.__version__}; tests/scripts/feedback_golden.py",
    }
    cases = list(loops())
    (ROOT / "feedback" / "loops.json").write_text(json.dumps({**head, "cases": cases}, indent=1))
    found = [{"name": name, "a": a.tolist(), "eigenvalues": pairs(eigvals(a))} for name, a in matrices()]
    (ROOT / "feedback" / "eigenvalues.json").write_text(json.dumps({**head, "matrices": found}, indent=1))


main()
