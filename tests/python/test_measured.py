"""Files of measured reflectance that Glanz writes, as others read them: Mitsuba RGL's `*.bsdf`, Radiance's library Klems'
matrices `*.xml`. `GLANZ_MEASURED` is a folder with these and the example `eval_measured` of glanz-measure."""

import math
import os
import pathlib
import subprocess
import unittest

import mitsuba
import pyradiance.bsdf as radiance

FOLDER = pathlib.Path(os.environ["GLANZ_MEASURED"])
# Theta and phi of the light, theta and phi of the detector, in degrees; not within a degree of the horizon.
PAIRS = [
    (ti, pi, to, po)
    for ti in (2.0, 20.0, 41.5, 63.0, 80.0)
    for pi in (0.0, 130.0)
    for to in (5.0, 33.0, 52.0, 77.0)
    for po in (-170.0, -35.0, 60.0, 180.0)
]


# The same, away from the bounds of Klems' patches.
PATCHES = [(ti, pi, to + 1.5, po + 4.0) for ti, pi, to, po in PAIRS]


def ours(file, pairs):
    """The BRDF times the cosine of the detector's angle, a list of channels for each pair."""
    lines = "".join(" ".join(map(str, pair)) + "\n" for pair in pairs)
    printed = subprocess.run(
        [FOLDER / "eval_measured", file], input=lines, capture_output=True, text=True, check=True
    ).stdout
    return [[float(word) for word in line.split()] for line in printed.splitlines()]


def direction(theta, phi):
    theta, phi = math.radians(theta), math.radians(phi)
    return [math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta)]


class Measured(unittest.TestCase):
    def test_tables_are_read_with_the_same_values(self):
        mitsuba.set_variant("scalar_rgb")
        files = sorted(FOLDER.glob("*.bsdf"))
        self.assertGreaterEqual(len(files), 4)
        for file in files:
            bsdf = mitsuba.load_dict({"type": "measured", "filename": str(file)})
            for pair, values in zip(PAIRS, ours(file, PAIRS), strict=True):
                point = mitsuba.SurfaceInteraction3f()
                point.wi = direction(*pair[:2])
                theirs = bsdf.eval(mitsuba.BSDFContext(), point, direction(*pair[2:]))
                for channel, value in enumerate(values):
                    expected = theirs[channel]
                    self.assertAlmostEqual(
                        value, expected, delta=5e-5 * max(abs(expected), 1e-3), msg=f"{file.name} {pair}"
                    )

    def test_matrices_are_read_with_the_same_values(self):
        files = sorted(FOLDER.glob("*.xml"))
        self.assertGreaterEqual(len(files), 1)
        for file in files:
            bsdf = radiance.load_file(str(file))
            for pair, values in zip(PATCHES, ours(file, PATCHES), strict=True):
                # Radiance's library gives each pair of patches a factor of its own, from 1 - 3e-4 to 1 + 3e-4, whatever the
                # number is; what it takes apart as matte has none.
                expected = radiance.query(bsdf, *pair)[1]
                value = values[len(values) // 2] / math.cos(math.radians(pair[2]))
                self.assertAlmostEqual(value, expected, delta=3e-4 * expected, msg=f"{file.name} {pair}")


if __name__ == "__main__":
    unittest.main()
