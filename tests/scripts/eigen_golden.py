"""Writes tests/data/hard_matrices.json: hard real 4x4 matrices with LAPACK's eigenvalues.

    python3 -m venv venv && venv/bin/pip install numpy scipy
    venv/bin/python tests/scripts/eigen_golden.py
"""

import json
import pathlib
import platform

import numpy as np
import scipy
from scipy.linalg import companion, eig, hilbert, matrix_balance

rng = np.random.default_rng(1903)
AIRCRAFT = np.array(
    [[-0.045, 0.036, 0, -9.81], [-0.369, -2.02, 53.6, 0], [0.00627, -0.13, -2.98, 0], [0, 0, 1, 0]]
)


def jordan(value, links):
    return value * np.eye(4) + np.diag(np.asarray(links, float), 1)


def matrices():
    for i in range(14):
        yield f"random {i}", rng.uniform(-1, 1, (4, 4))
    for i in range(10):
        d = 10.0 ** rng.uniform(-6, 6, 4)
        yield f"badly scaled similarity {i}", rng.uniform(-1, 1, (4, 4)) * d[:, None] / d[None, :]
    for i in range(6):
        yield f"graded rows {i}", rng.uniform(-1, 1, (4, 4)) * (10.0 ** np.array([0, -3, -6, -9]))[:, None]
    for i in range(4):
        d = 10.0 ** rng.uniform(-8, 8, 4)
        yield f"aircraft in odd units {i}", AIRCRAFT * d[:, None] / d[None, :]
    for k, (i, j) in enumerate([(2, 1), (0, 3), (1, 0), (1, 2), (2, 0)]):
        a = AIRCRAFT.copy()
        a[i, j] = 0
        yield f"aircraft without entry {i},{j}", a
    for links in [(1, 1, 1), (1, 1, 0), (1, 0, 1), (0, 1, 0)]:
        yield f"Jordan {links}", jordan(-0.5, links)
        yield f"Jordan {links}, transposed", jordan(-0.5, links).T
        mix = rng.uniform(-1, 1, (4, 4)) + 2 * np.eye(4)
        yield f"Jordan {links}, mixed", mix @ jordan(-0.5, links) @ np.linalg.inv(mix)
    for name, p in [
        ("s^4 + 1", [1, 0, 0, 0, 1]),
        ("s^4 - 1", [1, 0, 0, 0, -1]),
        ("s^4", [1, 0, 0, 0, 0]),
        ("(s + 1)^4", [1, 4, 6, 4, 1]),
        ("(s^2 + 1)^2", [1, 0, 2, 0, 1]),
        ("roots 1, 2, 3, 4", np.poly([1, 2, 3, 4])),
        ("roots 1e-4, 1e-2, 1, 100", np.poly([1e-4, 1e-2, 1, 100])),
    ]:
        yield f"companion of {name}", companion(np.asarray(p, float))
    for order in [(1, 2, 3, 0), (1, 0, 3, 2), (1, 2, 0, 3)]:
        yield f"permutation {order}", np.eye(4)[list(order)]
    for i in range(4):
        yield f"sparse {i}", rng.choice([0.0, 0.0, 1.0, -1.0], (4, 4))
    yield "zero", np.zeros((4, 4))
    yield "Hilbert", hilbert(4)
    yield "rank one", np.outer([1.0, 2, 3, 4], [4.0, -3, 2, 1])
    yield "huge", 1e150 * rng.uniform(-1, 1, (4, 4))
    yield "tiny", 1e-150 * rng.uniform(-1, 1, (4, 4))


def entry(name, a):
    # By a power of two, which rounds nothing: for entries of 1e150 or 1e-150 SciPy 1.17.1 returns eigenvalues that are not
    # scaled back (1e132 for 1e149), NumPy's are right.
    size = 2.0 ** np.floor(np.log2(np.abs(a).max() or 1.0))
    unit = a / size
    balanced, _ = matrix_balance(unit)
    # geev balances by itself; its vectors are wanted for the balanced matrix, where they bound both solvers' error.
    values = eig(unit, right=False)
    own, left, right = eig(balanced, left=True, right=True)
    condition = 1 / np.maximum(abs(np.sum(left.conj() * right, axis=0)), 1e-300)
    eigenvalues = []
    for value in values:
        # The sensitivity of the nearest; of equally near ones the largest.
        near = abs(own - value)
        kappa = condition[near <= near.min() * (1 + 1e-6) + 1e-300].max()
        known = {"re": float(value.real * size), "im": float(value.imag * size)}
        eigenvalues.append(known | {"condition": float(kappa) if kappa < 1e15 else None})
    norm = float(size * np.linalg.norm(balanced))
    return {"name": name, "a": a.tolist(), "balanced_norm": norm, "eigenvalues": eigenvalues}


def main():
    rows = [json.dumps(entry(name, a)) for name, a in matrices()]
    versions = f"Python {platform.python_version()}, NumPy {np.__version__}, SciPy {scipy.__version__}"
    source = json.dumps(f"tests/scripts/eigen_golden.py: LAPACK geev by scipy.linalg.eig; {versions}")
    text = f'{{\n"source": {source},\n"matrices": [\n' + ",\n".join(rows) + "\n]\n}\n"
    (pathlib.Path(__file__).parent.parent / "data" / "hard_matrices.json").write_text(text)
    print(len(rows), "matrices")


main()
