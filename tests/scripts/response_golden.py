"""Writes tests/data/responses.json: motions of linear aircraft models, by python-control.

    python3 -m venv venv && venv/bin/pip install numpy scipy control==0.10.2
    venv/bin/python tests/scripts/response_golden.py

The matrices are those of tests/data/models.json. Every motion is put together from pieces, between which inputs have
their edges; within a piece python-control is exact (matrix exponential), as inputs are constant or straight there, or
come from an oscillator that is part of the system. Only sine sweeps are integrated numerically. Everything is compared
with a Runge-Kutta integration of order 8 (SciPy's DOP853), sweeps with python-control on fine grids.
"""

import json
import math
import pathlib
import platform

import control
import numpy as np
import scipy
from scipy.integrate import solve_ivp

DATA = pathlib.Path(__file__).parent.parent / "data"

# Z_wdot [1] and M_wdot [1/ft] as printed in the reports that models.json names: what ẇ of the gust acts on. Where the
# aircraft is not trimmed level they also stand in A, which main() uses for a check.
W_DOT = {
    "navion_teper_sl": (0.0, -0.005165),
    "b747_cr2144_fc09": (0.00556, -0.000116),
    "a4d_fc1": (0.0, -0.000763),
    "bristol_f2b": (0.0, -0.00768),
    "x15_m05_sl": (0.0, -0.00025),
}
STEPS = 600
DURATION = {"longitudinal": 30.0, "lateral": 24.0}
SAMPLES = [0, 12, 20, 21, 24, 28, 33, 40, 49, 58, 75, 100, 131, 170, 226, 300, 401, 600]
ABOUT = {
    "versions": "what the numbers were made with",
    "disagreement": "by kind, the largest difference from a second method, of the largest value of that state in its run",
    "models": "one aircraft in one plane: x' = a x + b u(t) + b_rate u'(t), x(0) = x0 or zero",
    "a": "rows of A, states [u, w, q, theta] or [v, p, r, phi]; SI and radians, axes as in models.json",
    "columns": "b by name: elevator, aileron, rudder [rad]; gusts [m/s], u_g along the flight path, w_g normal to it, downward, "
    "v_g to the right: -A[:, state] of the states that the air moves with",
    "rate_columns": "b_rate by name, for the rate of the gust [m/s2]: what the gradient of a frozen field turns, q_g = -w_g'/V "
    "and r_g = v_g'/V about the normal to the path, on the aerodynamic part of the q or p and r columns, and -Z_wdot, -M_wdot "
    "on the w' of the air",
    "grid": "samples are wanted at k duration / steps [s]; `samples` has the k that are given",
    "speed": "V of the penetration [m/s]",
    "runs": "`input`, with the name of its column; `rate`: whether rate_columns acts too; `x0` where not zero; `states` at the samples",
    "input": {
        "all": "zero before `start`; amplitude in the column's unit; times in s, omega in rad/s; [ , ) includes its left end",
        "step": "amplitude from start on",
        "pulse": "amplitude on [start, start + duration), then zero",
        "doublet": "amplitude for duration, -amplitude for duration, then zero",
        "3-2-1-1": "amplitude for 3 duration, minus for 2, plus for 1, minus for 1, then zero",
        "sine": "amplitude sin(omega (t - start)) on [start, start + duration), then zero; without end if duration is null",
        "sweep": "amplitude sin(omega s + (omega_end - omega) s^2 / (2 duration)), s = t - start, on [start, start + duration)",
        "one_minus_cosine": "amplitude (1 - cos(2 pi (t - start)/duration))/2 on [start, start + duration], then zero",
        "samples": "straight lines between values at 0, dt, 2 dt, ..., which cover the whole time",
        "release": "no input, from x0",
        "mode": "no input, from x0 = Re(v), v the eigenvector of `eigenvalue` [re, im]",
    },
}


def edges(kind):
    """Times at which the input or its rate jumps, with `inf` last."""
    start, duration = kind.get("start", 0.0), kind.get("duration")
    if kind["kind"] in ("step", "release", "mode"):
        ends = []
    elif kind["kind"] == "samples":
        return [k * kind["dt"] for k in range(len(kind["values"]))] + [math.inf]
    elif kind["kind"] == "doublet":
        ends = [1, 2]
    elif kind["kind"] == "3-2-1-1":
        ends = [3, 5, 6, 7]
    else:
        ends = [1] if duration is not None else []
    return [start] + [start + n * duration for n in ends] + [math.inf]


def source(kind, piece, t):
    """(F, C, D, z): z' = F z, u = C z, u' = D z, with z at time t within the piece counted from 1; None for a sweep."""
    nothing = (np.zeros((1, 1)), np.zeros((1, 1)), np.zeros((1, 1)), np.zeros(1))
    name, amplitude, start = kind["kind"], kind.get("amplitude"), kind.get("start")
    ends = name not in ("step", "samples") and kind.get("duration") is not None
    if name in ("release", "mode") or piece == 0 or (ends and piece == len(edges(kind)) - 1):
        return nothing
    if name in ("step", "pulse", "doublet", "3-2-1-1"):
        sign = (-1) ** (piece - 1)
        return np.zeros((1, 1)), np.ones((1, 1)), np.zeros((1, 1)), np.array([sign * amplitude])
    if name == "samples":
        dt, values = kind["dt"], kind["values"]
        slope = (values[piece] - values[piece - 1]) / dt
        z = np.array([values[piece - 1] + slope * (t - (piece - 1) * dt), slope])
        return np.array([[0.0, 1], [0, 0]]), np.array([[1.0, 0]]), np.array([[0.0, 1]]), z
    if name == "sine":
        omega = kind["omega"]
        z = amplitude * np.array([math.sin(omega * (t - start)), math.cos(omega * (t - start))])
        return np.array([[0, omega], [-omega, 0]]), np.array([[1.0, 0]]), np.array([[0, omega]]), z
    if name == "one_minus_cosine":
        omega = 2 * math.pi / kind["duration"]
        sine, cosine = math.sin(omega * (t - start)), math.cos(omega * (t - start))
        z = amplitude / 2 * np.array([1.0, sine, cosine])
        f = np.array([[0, 0, 0], [0, 0, omega], [0, -omega, 0]])
        return f, np.array([[1.0, 0, -1]]), np.array([[0, omega, 0]]), z
    assert name == "sweep"
    return None


def value(kind, piece, t):
    """u(t) and u'(t) by the definition, within a piece."""
    if kind["kind"] == "sweep" and piece == 1:
        s = t - kind["start"]
        rise = (kind["omega_end"] - kind["omega"]) / kind["duration"]
        phase = kind["omega"] * s + rise * s * s / 2
        return kind["amplitude"] * math.sin(phase), None
    start, duration, amplitude = kind.get("start"), kind.get("duration"), kind.get("amplitude")
    after = piece == len(edges(kind)) - 1
    match kind["kind"]:
        case "release" | "mode":
            return 0.0, 0.0
        case "samples":
            times = np.arange(len(kind["values"])) * kind["dt"]
            return np.interp(t, times, kind["values"]), np.diff(kind["values"])[piece - 1] / kind["dt"]
        case _ if piece == 0:
            return 0.0, 0.0
        case "step":
            return amplitude, 0.0
        case _ if after and duration is not None:
            return 0.0, 0.0
        case "pulse":
            return amplitude, 0.0
        case "doublet":
            return [amplitude, -amplitude][piece - 1], 0.0
        case "3-2-1-1":
            return [amplitude, -amplitude, amplitude, -amplitude][piece - 1], 0.0
        case "sine":
            omega = kind["omega"]
            return amplitude * math.sin(omega * (t - start)), amplitude * omega * math.cos(omega * (t - start))
        case "one_minus_cosine":
            omega = 2 * math.pi / duration
            u = amplitude * 0.5 * (1 - math.cos(omega * (t - start)))
            return u, amplitude * 0.5 * omega * math.sin(omega * (t - start))
    raise ValueError(kind)


def advance(a, b, b_rate, kind, piece, t, h, x):
    """State after a time h within one piece, by python-control."""
    exosystem = source(kind, piece, t)
    if exosystem is None:
        return None
    f, c, d, z = exosystem
    n = len(a)
    whole = np.block([[a, np.outer(b, c) + np.outer(b_rate, d)], [np.zeros((len(f), n)), f]])
    system = control.ss(whole, np.zeros((len(whole), 1)), np.eye(len(whole)), 0)
    reply = control.initial_response(system, [0, h], np.concatenate([x, z]))
    return reply.outputs[:n, -1]


def forced(a, b, kind, piece, t, h, x, points):
    """The same for an input that is taken to be straight between points."""
    times = np.linspace(0, h, points + 1)
    u = [value(kind, piece, t + s)[0] for s in times]
    system = control.ss(a, b[:, None], np.eye(len(a)), 0)
    return control.forced_response(system, times, u, x).outputs[:, -1]


def integrate(a, b, b_rate, kind, piece, t, h, x, scale):
    def slope(s, x):
        u, rate = value(kind, piece, t + s)
        return a @ x + b * u + (b_rate * rate if rate is not None else 0)

    done = solve_ivp(slope, (0, h), x, method="DOP853", rtol=2.3e-14, atol=1e-15 * scale)
    assert done.success
    return done.y[:, -1]


def motion(a, b, b_rate, kind, x0, times, step):
    """States at the times, piece by piece."""
    x, t, piece = np.array(x0), 0.0, 0
    limits = edges(kind)
    states = []
    for wanted in times:
        while True:
            while limits[piece] <= t:
                piece += 1
            to = min(wanted, limits[piece])
            if to > t:
                x = step(a, b, b_rate, kind, piece, t, to - t, x)
            t = to
            if t == wanted:
                break
        states.append(x)
    return np.array(states)


def run(a, b, b_rate, kind, x0, times):
    """States at the times, and how far a second method is off, of the largest value of each state."""
    scale = max(np.abs(x0).max(), abs(kind.get("amplitude", 0)), *np.abs(kind.get("values", [0])))
    by_runge_kutta = motion(
        a, b, b_rate, kind, x0, times, lambda *piece: integrate(*piece, scale=scale)
    )
    peak = np.abs(by_runge_kutta).max(axis=0)
    if kind["kind"] != "sweep":
        states = motion(a, b, b_rate, kind, x0, times, advance)
        return states, np.abs((states - by_runge_kutta) / peak).max()

    def straight(points):  # a millisecond
        def step(a, b, b_rate, kind, piece, t, h, x):
            y = advance(a, b, b_rate, kind, piece, t, h, x)
            return forced(a, b, kind, piece, t, h, x, points * math.ceil(1000 * h)) if y is None else y

        return motion(a, b, b_rate, kind, x0, times, step)

    # The error of straight pieces goes with the square of their length.
    fine = (4 * straight(2) - straight(1)) / 3
    return by_runge_kutta, np.abs((by_runge_kutta - fine) / peak).max()


def modes(a):
    """(eigenvalue, eigenvector) with 1 as the largest entry, one of each conjugate pair."""
    values, vectors = np.linalg.eig(a)
    return [(e, v / v[np.abs(v).argmax()]) for e, v in zip(values, vectors.T) if e.imag >= 0]


def columns(entry, plane):
    matrices, trim = entry[plane], entry["trim"]
    a, b = np.array(matrices["a"], float), np.array(matrices["b"], float)
    v, alpha0, theta0 = trim["speed"], trim["alpha0"], trim["gamma0"] + trim["alpha0"]
    u0, w0 = v * math.cos(alpha0), v * math.sin(alpha0)
    if plane == "lateral":
        # Y_p, L_p, N_p without W0 and 1, Y_r, L_r, N_r without U0 and tan theta0.
        p = a[:, 1] - np.array([w0, 0, 0, 1])
        r = a[:, 2] + np.array([u0, 0, 0, -math.tan(theta0)])
        # The air turns with v_g'/V about the normal to the path, [-sin alpha0, 0, cos alpha0] in body axes.
        turning = np.array([-math.sin(alpha0), math.cos(alpha0)]) / v
        return a, {"aileron": b[:, 0], "rudder": b[:, 1], "v_g": -a[:, 0]}, {"v_g": -np.column_stack([p, r]) @ turning}
    z_wdot, m_wdot = W_DOT[entry["id"]][0], W_DOT[entry["id"]][1] / 0.3048
    inertia = np.array([[1, 0, 0, 0], [0, 1 - z_wdot, 0, 0], [0, -m_wdot, 1, 0], [0, 0, 0, 1.0]])
    gravity = inertia @ a[:, 3]
    weight = trim["gravity"] * np.array([-math.cos(theta0), -math.sin(theta0), 0, 0])
    assert np.abs(gravity - weight).max() < 1e-6, (entry["id"], gravity, weight)
    # X_q, Z_q, M_q without W0, U0 and 1; the aerodynamics see q + w_g'/V and w' less that of the air.
    q = inertia @ a[:, 2] - np.array([-w0, u0, 0, 1])
    lag = np.array([0, z_wdot, m_wdot, 0])
    # Rows: the path and its normal, downward, in body axes [x, z].
    path, normal = [math.cos(alpha0), math.sin(alpha0)], [-math.sin(alpha0), math.cos(alpha0)]
    u_rate = np.linalg.solve(inertia, -lag * path[1])
    w_rate = np.linalg.solve(inertia, q / v - lag * normal[1])
    gusts = {"u_g": -a[:, :2] @ path, "w_g": -a[:, :2] @ normal}
    return a, {"elevator": b[:, 0], **gusts}, {"u_g": u_rate, "w_g": w_rate}


def inputs(amplitude):
    start = {"amplitude": amplitude, "start": 1.013}
    yield {"kind": "step", "amplitude": amplitude, "start": 1.0}
    yield {"kind": "pulse", **start, "duration": 0.371}
    yield {"kind": "doublet", **start, "duration": 0.871}
    yield {"kind": "3-2-1-1", **start, "duration": 0.613}
    yield {"kind": "sine", **start, "duration": 4.71, "omega": 2.3}
    yield {"kind": "sine", **start, "duration": None, "omega": 0.7}
    yield {"kind": "sweep", **start, "duration": 8.3, "omega": 0.5, "omega_end": 6.0}
    yield {"kind": "one_minus_cosine", **start, "duration": 1.57}


def runs(a, b, b_rate, plane):
    none = np.zeros(4)
    for name, column in b.items():
        for kind in inputs(3.0 if name.endswith("_g") else 0.02):
            yield kind | {"column": name}, column, None, none
    # The rate of a jump is no function: only what has no jumps.
    name, rate = list(b_rate.items())[-1]
    values = np.round(np.random.default_rng(8785).normal(0, 1.5, 25), 2).tolist()
    samples = {"kind": "samples", "dt": 1.3, "values": values}
    yield samples | {"column": name}, b[name], None, none
    for kind in [*inputs(3.0), samples]:
        if kind["kind"] in ("samples", "one_minus_cosine") or kind.get("duration", 0) is None:
            yield kind | {"column": name}, b[name], rate, none
    x0 = [2.0, 1.0, 0.05, 0.02] if plane == "longitudinal" else [1.5, 0.1, -0.05, 0.1]
    yield {"kind": "release"}, none, None, np.array(x0)
    for value, vector in modes(a):
        yield {"kind": "mode", "eigenvalue": [value.real, value.imag]}, none, None, vector.real


def rounded(states):
    """Without the digits below 1e-12 of the largest value of a state."""
    decimals = [12 - math.floor(math.log10(max(peak, 1e-30))) for peak in np.abs(states).max(axis=0)]
    return [[round(float(x), d) + 0.0 for x, d in zip(row, decimals)] for row in states]


def compact(value):
    return json.dumps(value, separators=(",", ":"))


def main():
    entries = {entry["id"]: entry for entry in json.loads((DATA / "models.json").read_text())["models"]}
    worst, models, count = {}, [], 0
    for ident in W_DOT:
        for plane in ("longitudinal", "lateral"):
            a, b, b_rate = columns(entries[ident], plane)
            duration = DURATION[plane]
            times = [k * duration / STEPS for k in SAMPLES]
            lines = []
            for kind, column, rate, x0 in runs(a, b, b_rate, plane):
                states, off = run(a, column, np.zeros(4) if rate is None else rate, kind, x0, times)
                for value, vector in modes(a):
                    if kind.get("eigenvalue") == [value.real, value.imag]:
                        # x = Re(v e^(λt))
                        alone = np.array([(vector * np.exp(value * t)).real for t in times])
                        off = max(off, np.abs((states - alone) / np.abs(alone).max(axis=0)).max())
                worst[kind["kind"]] = max(worst.get(kind["kind"], 0.0), off)
                line = {"input": kind} | ({"rate": True} if rate is not None else {})
                line |= {"x0": x0.tolist()} if x0.any() else {}
                lines.append(compact(line | {"states": rounded(states)}))
            head = {
                "id": ident,
                "plane": plane,
                "source": entries[ident]["source"],
                "speed": entries[ident]["trim"]["speed"],
                "a": a.tolist(),
                "columns": {name: (column + 0.0).tolist() for name, column in b.items()},
                "rate_columns": {name: (column + 0.0).tolist() for name, column in b_rate.items()},
                "grid": {"duration": duration, "steps": STEPS},
                "samples": SAMPLES,
            }
            count += len(lines)
            models.append(compact(head)[:-1] + ',"runs":[\n' + ",\n".join(lines) + "\n]}")
            print(ident, plane, len(lines), "runs,", {k: f"{v:.1e}" for k, v in worst.items()}, flush=True)
    versions = f"Python {platform.python_version()}, python-control {control.__version__}, "
    versions += f"NumPy {np.__version__}, SciPy {scipy.__version__}"
    head = {
        "source": "tests/scripts/response_golden.py, matrices of tests/data/models.json",
        "versions": versions,
        "about": ABOUT,
        "disagreement": {name: float(f"{off:.1e}") for name, off in worst.items()},
    }
    text = compact(head)[:-1] + ',\n"models":[\n' + ",\n".join(models) + "\n]}\n"
    (DATA / "responses.json").write_text(text)
    assert max(worst.values()) < 1e-10, worst
    print(count, "runs,", len(text) // 1000, "kB")


main()
