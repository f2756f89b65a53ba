"""Times one slider tick here and in python-control with SciPy, in one run on one machine.

    python3 -m venv venv && venv/bin/pip install numpy scipy control
    venv/bin/python benches/compare_with_python_control.py

A tick: eigenvalues with left and right eigenvectors, participation, damping, and a step response of 1,201 points, all four
states. The model and the times are those of benches/analysis.rs, which also names the modes and gives the verdicts.
"""

import json
import os
import pathlib
import platform
import statistics
import subprocess
import time

import control
import numpy as np
import scipy
from scipy.linalg import eig

ROOT = pathlib.Path(__file__).resolve().parent.parent
A = [[-0.045, 0.036, 0, -0.322], [-0.369, -2.02, 1.76, 0], [0.191, -3.96, -2.98, 0], [0, 0, 1, 0]]
B = [[0], [-0.282], [-9.72], [0]]
TIMES = np.linspace(0, 60, 1201)


def slider_tick():
    system = control.ss(A, B, np.eye(4), np.zeros((4, 1)))
    _, left, right = eig(system.A, left=True, right=True)
    participation = np.abs(left * right)
    participation /= participation.sum(axis=0)
    damping = control.damp(system, doprint=False)
    step = control.step_response(system * 0.0175, TIMES)
    return participation, damping, step


def python_seconds():
    slider_tick()
    samples = []
    for _ in range(30):
        begin = time.perf_counter()
        slider_tick()
        samples.append(time.perf_counter() - begin)
    return statistics.median(samples)


def rust_seconds():
    command = ["cargo", "bench", "--no-default-features", "--bench", "analysis", "--", "slider_tick"]
    begin = time.time()
    subprocess.run(command, cwd=ROOT, check=True)
    target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    found = (ROOT / target / "criterion").glob("**/slider_tick/new/estimates.json")
    fresh = [path for path in found if path.stat().st_mtime >= begin]
    if len(fresh) != 1:
        raise SystemExit(f"expected one new estimate of slider_tick, found {fresh}")
    return json.loads(fresh[0].read_text())["median"]["point_estimate"] * 1e-9


def main():
    rust, python = rust_seconds(), python_seconds()
    print(f"Python {platform.python_version()}, python-control {control.__version__}, SciPy {scipy.__version__}")
    print(f"python-control  {python * 1e6:10.1f} µs a tick (median)")
    print(f"eigenwing       {rust * 1e6:10.1f} µs a tick (median)")
    print(f"ratio           {python / rust:10.0f}")


main()
