"""Writes tests/data/turbulence.json: Dryden samples made once more from the definitions, with 50 digits.

    python3 -m venv venv && venv/bin/pip install mpmath
    venv/bin/python tests/scripts/turbulence_golden.py

ChaCha with 8 rounds (D. J. Bernstein 2008, 64-bit counter, 64-bit stream) keyed by the seed gives 64-bit numbers; their
upper 53 bits are fractions; Box and Muller make normal numbers of them. The filters are stepped by the matrix exponential,
with the covariance of the noise from Van Loan's block matrix, neither of which knows a closed form.
"""

import json
import pathlib
import platform

import mpmath
from mpmath import mp, mpf

mp.dps = 50
MASK = 0xFFFFFFFF


def chacha8(key, stream):
    """The 64-bit numbers of the key stream, low word first."""
    state = [0x61707865, 0x3320646E, 0x79622D32, 0x6B206574]
    state += [int.from_bytes(key[i : i + 4], "little") for i in range(0, 32, 4)]
    counter = 0
    while True:
        start = state + [counter & MASK, counter >> 32, stream & MASK, stream >> 32]
        x = list(start)

        def quarter(a, b, c, d):
            for left, right, out, turn in [(a, b, d, 16), (c, d, b, 12), (a, b, d, 8), (c, d, b, 7)]:
                x[left] = (x[left] + x[right]) & MASK
                x[out] ^= x[left]
                x[out] = (x[out] << turn | x[out] >> (32 - turn)) & MASK

        for _ in range(4):
            for i in range(4):
                quarter(i, 4 + i, 8 + i, 12 + i)
            for i in range(4):
                quarter(i, 4 + (i + 1) % 4, 8 + (i + 2) % 4, 12 + (i + 3) % 4)
        words = [(a + b) & MASK for a, b in zip(x, start)]
        yield from (words[i] | words[i + 1] << 32 for i in range(0, 16, 2))
        counter += 1


def normals(seed, stream):
    numbers = chacha8(seed.to_bytes(8, "little") + bytes(24), stream)
    while True:
        a, b = (mpf(next(numbers) >> 11) / 2**53 for _ in range(2))
        radius = mpmath.sqrt(-2 * mpmath.log(1 - a))
        yield radius * mpmath.cos(2 * mp.pi * b)
        yield radius * mpmath.sin(2 * mp.pi * b)


def cholesky(p):
    c11 = mpmath.sqrt(p[0, 0])
    if p.rows == 1:
        return mpmath.matrix([[c11]])
    c21 = p[1, 0] / c11
    return mpmath.matrix([[c11, 0], [c21, mpmath.sqrt(p[1, 1] - c21**2)]])


def series(a, b, p, c, dt, normal, count):
    """Samples of y = c x, dx = a x dt + b dW, with the stationary covariance p of x."""
    n = a.rows
    # exp([[-a, b b'], [0, a']] dt) = [[., f12], [0, f22]]: transition f22', covariance f22' f12
    block = mpmath.matrix(2 * n)
    block[:n, :n], block[:n, n:], block[n:, n:] = -a * dt, b * b.T * dt, a.T * dt
    block = mpmath.expm(block)
    transition = block[n:, n:].T
    noise = cholesky(transition * block[:n, n:])
    x = cholesky(p) * mpmath.matrix([next(normal) for _ in range(n)])
    for _ in range(count):
        yield (c * x)[0]
        x = transition * x + noise * mpmath.matrix([next(normal) for _ in range(n)])


def samples(case):
    columns = []
    for i in range(3):
        rate = mpf(case["speed"]) / mpf(case["scale"][i])
        sigma, dt = mpf(case["intensity"][i]), mpf(case["dt"])
        if i == 0:
            a, b = mpmath.matrix([[-rate]]), mpmath.matrix([[mpmath.sqrt(2 * rate)]])
            p, c = mpmath.matrix([[1]]), mpmath.matrix([[sigma]])
        else:
            # Two first-order lags in a row; then (1 + sqrt(3) tau s) of the second one's output.
            a = mpmath.matrix([[-rate, 0], [rate, -rate]])
            b = mpmath.matrix([[mpmath.sqrt(2 * rate)], [0]])
            p = mpmath.matrix([[1, mpf(1) / 2], [mpf(1) / 2, mpf(1) / 2]])
            c = mpmath.matrix([[mpmath.sqrt(3), 1 - mpmath.sqrt(3)]]) * sigma / mpmath.sqrt(2)
        residual = a * p + p * a.T + b * b.T
        assert max(abs(v) for v in residual) < 1e-45, "p is the stationary covariance"
        columns.append(series(a, b, p, c, dt, normals(case["seed"], i), case["count"]))
    return [[float(v) for v in row] for row in zip(*columns)]


def main():
    # RFC 8439 has 20 rounds; these are the first bytes of eSTREAM's ChaCha8 for a key of zeros.
    first = next(chacha8(bytes(32), 0)).to_bytes(8, "little").hex()
    assert first == "3e00ef2f895f40d6", first
    cases = [
        {"speed": 50.0, "scale": [500.0, 400.0, 150.0], "intensity": [2.0, 1.5, 1.0], "dt": 0.05},
        {"speed": 235.0, "scale": [533.4, 533.4, 533.4], "intensity": [3.0, 3.0, 3.0], "dt": 1.0},
        {"speed": 1.0, "scale": [1000.0, 1000.0, 1000.0], "intensity": [1.0, 1.0, 1.0], "dt": 1e-3},
    ]
    for case, seed in zip(cases, [1, 1903, 2**64 - 1]):
        case |= {"seed": str(seed), "count": 12}
        case["samples"] = samples(case | {"seed": seed})
    versions = f"Python {platform.python_version()}, mpmath {mpmath.__version__}"
    source = json.dumps(f"tests/scripts/turbulence_golden.py; {versions}")
    rows = ",\n".join(json.dumps(case) for case in cases)
    path = pathlib.Path(__file__).parent.parent / "data" / "turbulence.json"
    path.write_text(f'{{\n"source": {source},\n"cases": [\n{rows}\n]\n}}\n')
    print(len(cases), "cases")


main()
