"""Fits by scipy's least_squares on all parameters, beside those of Glanz: widths and tints by Levenberg and Marquardt's or the
trust-region way, cube roots, the same readings. The models are written again in numpy here.

Prints one JSON line per case: the seconds of both, median and spread, and the optimum of both.

    python fits.py PROGRAM [TURNS]    PROGRAM is the example `bench_fit` of glanz-measure
"""

import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares


class Readings:
    """Directions of the light and the detector, and f cosθi: channels × readings."""

    def __init__(self, path, channels):
        rows = np.fromfile(path, "<f8").reshape(-1, 6 + channels)
        # Those that the example counts.
        rows = rows[np.minimum(rows[:, 2], rows[:, 5]) >= np.cos(np.radians(89.9))]
        wi, wo = rows[:, :3], rows[:, 3:6]
        self.cos_i, self.cos_o = wi[:, 2], wo[:, 2]
        half = wi + wo
        half /= np.linalg.norm(half, axis=1)[:, None]
        self.cos_h, self.cos_oh = half[:, 2], (half * wo).sum(1)
        self.u5 = (1 - self.cos_oh) ** 5
        self.root = np.cbrt(rows[:, 6:].T * self.cos_i)


def cook_torrance(r, m):
    tan2 = 1 / r.cos_h**2 - 1
    d = np.exp(-tan2 / m**2) / (np.pi * m**2 * r.cos_h**4)
    g = np.minimum(1, 2 * r.cos_h / r.cos_oh * np.minimum(r.cos_o, r.cos_i))
    return d * g / (4 * r.cos_o)


def columns(r, widths, schlick):
    """f cosθi of all lobes for a tint of 1."""
    out = []
    for m in widths:
        s = cook_torrance(r, m)
        out += [s * (1 - r.u5), s * r.u5] if schlick else [s]
    return np.array(out + [r.cos_i / np.pi])


def residuals(x, r, lobes, schlick):
    tints = x[lobes:].reshape(r.root.shape[0], -1)
    return (np.cbrt(tints @ columns(r, np.exp(x[:lobes]), schlick)) - r.root).ravel()


def fit(r, lobes, schlick):
    channels = r.root.shape[0]
    count = lobes * (2 if schlick else 1) + 1
    x = np.concatenate([np.log([0.1, 0.3][:lobes]), np.full(channels * count, 0.2)])
    low = np.concatenate([np.full(lobes, np.log(0.005)), np.zeros(channels * count)])
    high = np.concatenate([np.zeros(lobes), np.full(channels * count, np.inf)])
    start = time.perf_counter()
    found = least_squares(residuals, x, bounds=(low, high), args=(r, lobes, schlick), xtol=1e-10, ftol=1e-12)
    return time.perf_counter() - start, found


def main():
    program, turns = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 5
    with tempfile.TemporaryDirectory() as folder:
        lines = subprocess.run([program, folder], check=True, capture_output=True, text=True).stdout
        for ours in map(json.loads, lines.splitlines()):
            r = Readings(Path(folder) / f"{ours['number']}.bin", ours["channels"])
            schlick = "Fresnel" in ours["case"]
            runs = [fit(r, len(ours["widths"]), schlick) for _ in range(turns if r.cos_i.size < 1e5 else 1)]
            times, found = sorted(seconds for seconds, _ in runs), runs[0][1]
            median = times[len(times) // 2]
            assert r.cos_i.size == ours["readings"]
            result = {
                "case": ours["case"],
                "readings": int(r.cos_i.size),
                "ours": [ours["median"], ours["least"], ours["most"]],
                "scipy": [median, times[0], times[-1]],
                "quotient": median / ours["median"],
                "evaluations": int(found.nfev),
                "error_ours": ours["error"],
                "error_scipy": float(np.sqrt(2 * found.cost / r.root.size)),
                "widths_ours": ours["widths"],
                "widths_scipy": np.exp(found.x[: len(ours["widths"])]).tolist(),
            }
            print(json.dumps(result), flush=True)


if __name__ == "__main__":
    main()
