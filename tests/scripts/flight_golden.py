"""Writes tests/data/flight_golden.json: nonlinear flights by SciPy, from an implementation of their own.

    python3 -m venv venv && venv/bin/pip install numpy scipy
    venv/bin/python tests/scripts/flight_golden.py

Attitude by the whole rotation matrix, inertia as a matrix, feet, slugs and pounds: nothing in common with the code under
test but the aircraft's numbers and the textbook.
"""

import json
import pathlib
import platform

import numpy as np
import scipy
from scipy.integrate import solve_ivp

EXACT = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-13}
FT = 0.3048


def cross_matrix(w):
    return np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])


def torque_free():
    inertia = np.array([[1400.0, 0, -300.0], [0, 2500.0, 0], [-300.0, 0, 3300.0]])

    def rate(_, y):
        w, turn = y[:3], y[3:].reshape(3, 3)
        return np.concatenate(
            [np.linalg.solve(inertia, -np.cross(w, inertia @ w)), (turn @ cross_matrix(w)).ravel()]
        )

    times = np.linspace(0, 30, 31)
    start = np.concatenate([[0.4, 1.1, -0.3], np.eye(3).ravel()])
    y = solve_ivp(rate, (0, 30), start, t_eval=times, **EXACT).y
    return {
        "inertia": {"ix": 1400.0, "iy": 2500.0, "iz": 3300.0, "ixz": 300.0},
        "rates": y[:3].T.tolist(),
        "nose": y[[3, 6, 9]].T.tolist(),
    }


def navion(cl_alphadot=0.0, exponent=0.0, offset=0.0, gamma=0.0):
    """Navion of NASA CR-96008 at sea level: elevator and rudder held from 1 s, aileron from 2 s, air from the left
    and rising from 3 s, along and across the flight path of the trim. With other lift by the rate of alpha, thrust as V to an exponent, on a
    line so many feet below the centre of gravity, climbing at gamma."""
    g, rho, v0 = 32.174, 0.002378, 176.0
    mass, s, b, c = 2750.0 / g, 184.0, 33.4, 5.7
    inertia = np.diag([1048.0, 3000.0, 3530.0])
    cl0, cd0, cla, cda = 0.41, 0.05, 4.44, 0.33
    controls = {"elevator": -0.02, "rudder": 0.03, "aileron": -0.03}
    wind_si = [0.0, 2.0, -1.5]
    q0s = 0.5 * rho * v0**2 * s
    c_t = cd0 + cl0 * np.tan(gamma)
    # the source's C_L carries 1 % more than the weight: the rest is a force fixed in the body, vertical in the trim
    spare = mass * g * np.cos(gamma) - q0s * cl0
    trim = np.array([[np.cos(gamma), 0, np.sin(gamma)], [0, 1, 0], [-np.sin(gamma), 0, np.cos(gamma)]])

    def rate(t, y, on):
        velocity, w, turn = y[:3], y[3:6], y[6:15].reshape(3, 3)
        de, dr = (controls["elevator"], controls["rudder"]) if on[0] else (0.0, 0.0)
        da = controls["aileron"] if on[1] else 0.0
        wind = trim @ wind_si / FT if on[2] else np.zeros(3)
        blowing = turn.T @ wind
        air = velocity - blowing
        speed = np.linalg.norm(air)
        alpha = np.arctan2(air[2], air[0])
        beta = np.arcsin(air[1] / speed)
        qs = 0.5 * rho * speed**2 * s
        p, q, r = w * np.array([b, c, b]) / (2 * speed)
        lift_alpha = cla * alpha
        thrust = q0s * c_t * (speed / v0) ** exponent
        cd = cd0 + cda / (2 * cl0 * cla) * ((cl0 + lift_alpha) ** 2 - cl0**2)
        side = -0.564 * beta + 0.157 * dr
        roll = -0.074 * beta - 0.41 * p + (0.107 + lift_alpha / 4) * r + 0.1342 * da + 0.0118 * dr
        yaw = 0.0701 * beta + (-0.0575 - lift_alpha / 8) * p - 0.125 * r - 0.00346 * da - 0.0717 * dr
        ca, sa = np.cos(alpha), np.sin(alpha)

        def accelerated(alphadot):
            cl = cl0 + lift_alpha + 0.355 * de + cl_alphadot * alphadot * c / (2 * speed)
            force = qs * np.array([-cd * ca + cl * sa, side, -cd * sa - cl * ca])
            force = force + [thrust + spare * np.tan(gamma), 0, -spare]
            return force / mass + turn.T @ [0, 0, g] - np.cross(w, velocity)

        def alphadot_of(acceleration):
            # the wind stands still while the axes turn
            acceleration = acceleration + np.cross(w, blowing)
            return (air[0] * acceleration[2] - air[2] * acceleration[0]) / (air[0] ** 2 + air[2] ** 2)

        # the rate of alpha depends on itself, along a straight line: two points of it say where it meets itself
        zero, one = alphadot_of(accelerated(0.0)), alphadot_of(accelerated(1.0))
        alphadot = zero / (1 - (one - zero))
        acceleration = accelerated(alphadot)
        pitch = -0.683 * alpha - 9.96 * q - 4.36 * alphadot * c / (2 * speed) - 0.87 * de - c_t * offset / c
        moment = qs * np.array([b * roll, c * pitch, b * yaw]) + [0, thrust * offset, 0]
        turning = np.linalg.solve(inertia, moment - np.cross(w, inertia @ w))
        return np.concatenate([acceleration, turning, (turn @ cross_matrix(w)).ravel(), turn @ velocity])

    y = np.concatenate([[v0, 0, 0], np.zeros(3), trim.ravel(), np.zeros(3)])
    samples, on = [], [False, False, False]
    pieces = [(0.0, 1.0), (1.0, 2.0), (2.0, 3.0), (3.0, 8.0)]
    for k, (start, end) in enumerate(pieces):
        on = [k > 0, k > 1, k > 2]
        times = np.arange(start, end + 0.25, 0.5)
        solved = solve_ivp(rate, (start, end), y, t_eval=times, args=(on,), **EXACT)
        samples += [row for row in solved.y.T[(1 if k else 0) :]]
        y = solved.y[:, -1]
    scale = np.array([FT] * 3 + [1.0] * 12 + [FT, FT, -FT])
    rows = np.array(samples) * scale
    return {
        "cl_alphadot": cl_alphadot,
        "thrust_exponent": exponent,
        "thrust_offset": offset * FT,
        "gamma0": gamma,
        "controls": controls,
        "wind": wind_si,
        "step": 0.5,
        "velocity": rows[:, :3].tolist(),
        "rates": rows[:, 3:6].tolist(),
        "nose": rows[:, [6, 9, 12]].tolist(),
        "position": rows[:, 15:].tolist(),
    }


data = {
    "source": "tests/scripts/flight_golden.py: scipy.integrate.solve_ivp, DOP853, rtol 1e-12; "
    f"Python {platform.python_version()}, NumPy {np.__version__}, SciPy {scipy.__version__}",
    "torque_free": torque_free(),
    "navion": navion(),
    "navion_otherwise": navion(cl_alphadot=6.0, exponent=-1.0, offset=1.5, gamma=0.1),
}
path = pathlib.Path(__file__).parent.parent / "data" / "flight_golden.json"
path.write_text(json.dumps(data, indent=1) + "\n")
