"""Files of measured reflectance that Glanz writes, as Mitsuba reads them: `GLANZ_MEASURED` is a folder with the example
`eval_measured` of glanz-measure and the files `*.bsdf`."""

import math
import os
import pathlib
import subprocess
import unittest

import mitsuba

FOLDER = pathlib.Path(os.environ["GLANZ_MEASURED"])
# Theta and phi of the light, theta and phi of the detector, in degrees; not within a degree of the horizon.
PAIRS = [
    (ti, pi, to, po)
    for ti in (2.0, 20.0, 41.5, 63.0, 80.0)
    for pi in (0.0, 130.0)
    for to in (5.0, 33.0, 52.0, 77.0)
    for po in (-170.0, -35.0, 60.0, 180.0)
]


def direction(theta, phi):
    theta, phi = math.radians(theta), math.radians(phi)
    return [math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta)]


class Measured(unittest.TestCase):
    def test_tables_are_read_with_the_same_values(self):
        mitsuba.set_variant("scalar_rgb")
        files = sorted(FOLDER.glob("*.bsdf"))
        self.assertGreaterEqual(len(files), 2)
        lines = "".join(" ".join(map(str, pair)) + "\n" for pair in PAIRS)
        for file in files:
            ours = subprocess.run(
                [FOLDER / "eval_measured", file], input=lines, capture_output=True, text=True, check=True
            ).stdout.splitlines()
            bsdf = mitsuba.load_dict({"type": "measured", "filename": str(file)})
            for pair, line in zip(PAIRS, ours, strict=True):
                point = mitsuba.SurfaceInteraction3f()
                point.wi = direction(*pair[:2])
                theirs = bsdf.eval(mitsuba.BSDFContext(), point, direction(*pair[2:]))
                for channel, value in enumerate(line.split()):
                    expected = theirs[channel]
                    self.assertAlmostEqual(
                        float(value), expected, delta=5e-5 * max(abs(expected), 1e-3), msg=f"{file.name} {pair}"
                    )


if __name__ == "__main__":
    unittest.main()
