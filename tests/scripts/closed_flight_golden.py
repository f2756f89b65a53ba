"""Writes tests/data/feedback/flights.json: nonlinear flights of the Navion under laws of feedback by SciPy, with limits of deflection and
rate, from an implementation of their own.

    python3 -m venv venv && venv/bin/pip install numpy scipy
    venv/bin/python tests/scripts/closed_flight_golden.py

Attitude by the whole rotation matrix, inertia as a matrix, feet, slugs and pounds, as in flight_golden.py; a control without a lag by
events of solve_ivp. Nothing in common with the code under test but the aircraft's numbers, the textbook and what a law says.
"""

import json
import pathlib
import platform

import numpy as np
import scipy
from scipy.integrate import solve_ivp

EXACT = {"method": "DOP853", "rtol": 1e-11, "atol": 1e-12, "max_step": 0.02}
FT = 0.3048
DEG = np.pi / 180
G, RHO, V0 = 32.174, 0.002378, 176.0
WEIGHT, S, B, C = 2750.0, 184.0, 33.4, 5.7
MASS = WEIGHT / G
INERTIA = np.diag([1048.0, 3000.0, 3530.0])
CL0, CD0, CLA, CDA = 0.41, 0.05, 4.44, 0.33
Q0S = 0.5 * RHO * V0**2 * S
SPARE = MASS * G - Q0S * CL0
CONTROLS = ["elevator", "throttle", "aileron", "rudder"]
MEASURED = ["u", "alpha", "q", "theta", "h", "beta", "p", "r", "phi", "psi"]


def cross_matrix(w):
    return np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])


def body_rate(y, controls):
    """The rate of velocity, rates, attitude and position, in feet."""
    velocity, w, turn = y[:3], y[3:6], y[6:15].reshape(3, 3)
    de, dt, da, dr = controls
    speed = np.linalg.norm(velocity)
    alpha = np.arctan2(velocity[2], velocity[0])
    beta = np.arcsin(velocity[1] / speed)
    qs = 0.5 * RHO * speed**2 * S
    p, q, r = w * np.array([B, C, B]) / (2 * speed)
    lift_alpha = CLA * alpha
    thrust = Q0S * CD0 + dt * WEIGHT
    cl = CL0 + lift_alpha + 0.355 * de
    cd = CD0 + CDA / (2 * CL0 * CLA) * ((CL0 + lift_alpha) ** 2 - CL0**2)
    side = -0.564 * beta + 0.157 * dr
    roll = -0.074 * beta - 0.41 * p + (0.107 + lift_alpha / 4) * r + 0.1342 * da + 0.0118 * dr
    yaw = 0.0701 * beta + (-0.0575 - lift_alpha / 8) * p - 0.125 * r - 0.00346 * da - 0.0717 * dr
    ca, sa = np.cos(alpha), np.sin(alpha)
    force = qs * np.array([-cd * ca + cl * sa, side, -cd * sa - cl * ca]) + [thrust, 0, -SPARE]
    acceleration = force / MASS + turn.T @ [0, 0, G] - np.cross(w, velocity)
    alphadot = (velocity[0] * acceleration[2] - velocity[2] * acceleration[0]) / (velocity[0] ** 2 + velocity[2] ** 2)
    pitch = -0.683 * alpha - 9.96 * q - 4.36 * alphadot * C / (2 * speed) - 0.87 * de
    turning = np.linalg.solve(INERTIA, qs * np.array([B * roll, C * pitch, B * yaw]) - np.cross(w, INERTIA @ w))
    return np.concatenate([acceleration, turning, (turn @ cross_matrix(w)).ravel(), turn @ velocity])


def measured(y):
    """In metres, seconds and radians."""
    velocity, w, turn = y[:3], y[3:6], y[6:15].reshape(3, 3)
    return np.array([
        (velocity[0] - V0) * FT, np.arctan2(velocity[2], velocity[0]), w[1], np.arcsin(-turn[2, 0]), -y[17] * FT,
        np.arcsin(velocity[1] / np.linalg.norm(velocity)), w[0], w[2], np.arctan2(turn[2, 1], turn[2, 2]),
        np.arctan2(turn[1, 0], turn[0, 0]),
    ])


def flight(name, gains, washouts, lags, limits, rates, pilot, command, duration=8.0):
    """gains: {(signal, control): k}; washouts of q and r; lags, limits (low, high) and rates of each control, SI; pilot: (control,
    deflection, from, to); command: (signal, value, from)."""
    matrix = np.zeros((4, 10))
    for (signal, control), k in gains.items():
        matrix[CONTROLS.index(control), MEASURED.index(signal)] = k
    driven = np.abs(matrix).max(axis=1) > 0
    direct = driven & (np.array(lags) == 0)
    low, high = np.array(limits).T
    rates = np.array(rates)

    # y: body 18, slow parts of q and r, the four controls
    def by_hand(t):
        hand = np.zeros(4)
        if pilot and pilot[2] <= t < pilot[3]:
            hand[CONTROLS.index(pilot[0])] = pilot[1]
        return hand

    def asked(t, y):
        signals = measured(y)
        if command and t >= command[2]:
            signals[MEASURED.index(command[0])] -= command[1]
        filled = np.array([signals[2] - y[18], signals[7] - y[19]])
        for k, j in [(0, 2), (1, 7)]:
            if washouts[k]:
                signals[j] -= y[18 + k]
        hand = np.clip(by_hand(t), low, high)
        wanted = matrix @ signals
        return hand, wanted, np.clip(wanted, low - hand, high - hand), filled

    def parts(t, y, ways):
        hand, wanted, within, filled = asked(t, y)
        moved = np.where(direct & (ways == 0), within, np.where(driven, y[20:24], 0.0))
        return hand, wanted, within, filled, np.clip(hand + moved, low, high)

    def rate(t, y, ways):
        _, _, within, filled, controls = parts(t, y, ways)
        slow = [filled[k] / washouts[k] if washouts[k] else 0.0 for k in (0, 1)]
        moving = np.zeros(4)
        for i in range(4):
            if ways[i]:
                moving[i] = ways[i] * rates[i]
            elif driven[i] and not direct[i]:
                moving[i] = np.clip((within[i] - y[20 + i]) / lags[i], -rates[i], rates[i])
        return np.concatenate([body_rate(y[:18], controls), slow, moving])

    def bites(t, y, ways):
        hand, wanted, within, _, _ = parts(t, y, ways)
        total = hand + np.where(driven, wanted, 0.0)
        slow = (ways != 0) | (driven & ~direct & (np.abs(within - y[20:24]) > rates * np.where(direct | ~driven, 1, np.maximum(lags, 1e-9))))
        # The reach holds the pilot back, or the law in what the pilot leaves of it.
        return np.stack([(total < low) | (total > high) | (by_hand(t) != hand), slow], axis=1)

    def runs_away(i):
        def event(t, y, ways):
            h = 1e-5
            f = rate(t, y, ways)
            ahead, behind = asked(t, y + h * f)[2][i], asked(t, y - h * f)[2][i]
            return rates[i] - abs(ahead - behind) / (2 * h)
        event.terminal, event.direction = True, -1
        return event

    def meets(i, sense):
        def event(t, y, ways):
            return sense * (asked(t, y)[2][i] - y[20 + i])
        event.terminal, event.direction = True, -1
        return event

    y = np.concatenate([[V0, 0, 0], np.zeros(3), np.eye(3).ravel(), np.zeros(3), np.zeros(6)])
    edges = sorted({0.0, duration, *(pilot[2:4] if pilot else []), *([command[2]] if command else [])})
    ways = np.zeros(4)
    times, states, all_controls, spans, since = [], [], [], [], {}
    dense = 2e-4

    def note(t, flags):
        for i in range(4):
            for j in range(2):
                if flags[i, j] and (i, j) not in since:
                    since[i, j] = t
                elif not flags[i, j] and (i, j) in since:
                    spans.append([CONTROLS[i], ["deflection", "rate"][j], since.pop((i, j)), t])

    for start, end in zip(edges, edges[1:]):
        t = start
        within = asked(t, y)[2]
        ways = np.where(direct & (np.abs(within - y[20:24]) > 1e-9) & (t > 0), np.sign(within - y[20:24]), 0.0)
        while t < end - 1e-12:
            events = [meets(i, ways[i]) if ways[i] else runs_away(i) for i in range(4) if direct[i]]
            index = [i for i in range(4) if direct[i]]
            # what holds at the end belongs to the next piece
            held = lambda t, y, ways: rate(min(t, end - 1e-12), y, ways)
            held_events = []
            for event in events:
                def wrapped(t, y, ways, event=event):
                    return event(min(t, end - 1e-12), y, ways)
                wrapped.terminal, wrapped.direction = True, -1
                held_events.append(wrapped)
            solved = solve_ivp(held, (t, end), y, args=(ways,), dense_output=True, events=held_events or None, **EXACT)
            last = solved.t[-1]
            wanted = np.arange(np.ceil((t - 1e-9) / 0.25), np.floor((last - 1e-9) / 0.25) + 1) * 0.25
            for at in wanted:
                if times and at <= times[-1] + 1e-9:
                    continue
                row = solved.sol(min(max(at, t), last))
                times.append(at)
                states.append(row)
                all_controls.append(parts(at, row, ways)[4])
            for at in np.arange(t, last, dense):
                note(at, bites(min(at, end - 1e-12), solved.sol(at), ways))
            y, t = solved.y[:, -1].copy(), last
            here = asked(min(t, end - 1e-12), y)[2]
            for k, i in enumerate(index):
                if t < end - 1e-12 and solved.t_events[k].size:
                    if ways[i]:
                        ways[i] = 0.0
                    else:
                        f = rate(t, y, ways)
                        h = 1e-5
                        ways[i] = np.sign(asked(t, y + h * f)[2][i] - asked(t, y - h * f)[2][i])
                        y[20 + i] = here[i]
            for i in index:
                if not ways[i]:
                    y[20 + i] = here[i]
    times.append(duration)
    states.append(y)
    all_controls.append(parts(duration, y, ways)[4])
    for (i, j), t in since.items():
        spans.append([CONTROLS[i], ["deflection", "rate"][j], t, duration])
    rows = np.array(states)
    scale = np.array([FT] * 3 + [1.0] * 12 + [FT, FT, -FT])
    body = rows[:, :18] * scale
    print(name, len(times), sorted(spans, key=lambda span: span[2]))
    return {
        "name": name,
        "gains": {f"{signal}.{control}": k for (signal, control), k in gains.items()},
        "washouts": washouts,
        "lags": lags,
        "limits": limits,
        "rates": [r if np.isfinite(r) else None for r in rates],
        "pilot": pilot,
        "command": command,
        "times": times,
        "velocity": body[:, :3].tolist(),
        "rates_of_turn": body[:, 3:6].tolist(),
        "nose": body[:, [6, 9, 12]].tolist(),
        "position": body[:, 15:].tolist(),
        "controls": np.array(all_controls).tolist(),
        "bites": sorted(spans, key=lambda span: span[2]),
    }


reach = Q0S * CD0 / WEIGHT
usual = [[-25 * DEG, 25 * DEG], [-reach, reach], [-25 * DEG, 25 * DEG], [-30 * DEG, 30 * DEG]]
fast = [60 * DEG, float("inf"), 60 * DEG, 60 * DEG]
flights = [
    flight(
        "dampers of yaw, roll and pitch with a washout, a lag and little reach",
        {("r", "rudder"): 4.0, ("p", "aileron"): -1.0, ("q", "elevator"): 1.0, ("u", "throttle"): -0.02},
        [0.0, 2.0], [0.1, 0.5, 0.1, 0.1],
        [[-3 * DEG, 3 * DEG], usual[1], [-4 * DEG, 4 * DEG], [-6 * DEG, 6 * DEG]],
        [20 * DEG, float("inf"), 20 * DEG, 15 * DEG],
        ["rudder", 10 * DEG, 1.0, 1.5], None,
    ),
    flight(
        "a bank angle held by an aileron without a lag, which its rate holds back",
        {("phi", "aileron"): -1.0, ("p", "aileron"): -0.3},
        [0.0, 0.0], [0.0] * 4,
        [usual[0], usual[1], [-15 * DEG, 15 * DEG], usual[3]], [fast[0], fast[1], 25 * DEG, fast[3]],
        None, ["phi", 40 * DEG, 1.0],
    ),
    flight(
        "pitch angle and speed commanded far off, with the usual limits",
        {("theta", "elevator"): 3.0, ("q", "elevator"): 0.4, ("u", "throttle"): -0.05},
        [0.0, 0.0], [0.05, 0.5, 0.05, 0.05], usual, fast,
        None, ["theta", 9 * DEG, 1.0],
    ),
]
data = {
    "source": "tests/scripts/closed_flight_golden.py: scipy.integrate.solve_ivp, DOP853, rtol 1e-11; "
    f"Python {platform.python_version()}, NumPy {np.__version__}, SciPy {scipy.__version__}",
    "flights": flights,
}
path = pathlib.Path(__file__).parent.parent / "data" / "feedback" / "flights.json"
path.write_text(json.dumps(data, indent=1) + "\n")
