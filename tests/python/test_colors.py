"""Colours of the command `glanz`, against colour-science as an independent oracle.

`cargo xtask test` runs this; by hand: `GLANZ=target/debug/glanz python -m unittest tests/python/test_colors.py`
in an environment with tests/python/requirements.txt.
"""

import json
import os
import random
import subprocess
import tempfile
import unittest
import warnings
from concurrent.futures import ThreadPoolExecutor

warnings.filterwarnings("ignore")
import colour  # noqa: E402
import numpy as np  # noqa: E402

GLANZ = os.environ.get("GLANZ", "target/debug/glanz")
GRID = np.arange(300.0, 781.0, 5.0)
FINE = np.arange(300.0, 831.0)

# Names in glanz and in colour-science.
OBSERVERS = {
    "cie1931": "CIE 1931 2 Degree Standard Observer",
    "cie1964": "CIE 1964 10 Degree Standard Observer",
    "cie2015-2": "CIE 2015 2 Degree Standard Observer",
    "cie2015-10": "CIE 2015 10 Degree Standard Observer",
}
LIGHTS = ["A", "C", "D50", "D55", "D65", "E", "FL2", "FL11", "HP1", "LED-B3"]

# Tables are rounded to five or six digits, some of them twice.
RELATIVE = 1e-4
# Matrices of colour-science are given with four to seven digits.
MODELS = 2e-4


def glanz(*arguments):
    run = subprocess.run([GLANZ, *arguments, "--format", "json"], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise AssertionError(f"glanz {' '.join(arguments)}: {run.stderr}")
    return json.loads(run.stdout)


def on_grid(distribution, hold, grid=GRID):
    """Values at every 5 nm; beyond the table the value at its end, or 0."""
    nm, values = distribution.domain, distribution.range
    ends = {} if hold else {"left": 0.0, "right": 0.0}
    return np.interp(grid, nm, values, **ends)


def by_1_nm(distribution, hold):
    """Values at every nm, between those of a table by Sprague's polynomials (CIE 167:2005). Daylight is linear between
    its wavelengths by definition (CIE 15:2018)."""
    fine = distribution.copy()
    is_daylight = distribution.name.startswith("D") and distribution.name[1:].isdigit()
    if fine.shape.interval > 1.0 and not is_daylight:
        shape = colour.SpectralShape(fine.shape.start, fine.shape.end, 1.0)
        fine.interpolate(shape, interpolator=colour.SpragueInterpolator)
    return on_grid(fine, hold, FINE)


def curves(name, grid=FINE):
    table = colour.MSDS_CMFS[OBSERVERS[name]]
    return np.array([np.interp(grid, table.domain, column, left=0.0, right=0.0) for column in table.values.T])


class Surfaces(unittest.TestCase):
    def test_24_patches_under_10_lights_have_the_xyz_of_4_observers(self):
        patches = colour.SDS_COLOURCHECKERS["ISO 17321-1"]
        jobs = [(p, l, o) for p in patches for l in LIGHTS for o in OBSERVERS]

        def compute(job):
            patch, light, observer = job
            # "white 9.5 (.05 D)" is white-9.5 here: the density is left out.
            name = patch.split(" (")[0].replace(" ", "-")
            return glanz("color", "spectrum", name, "--light", light, "--observer", observer)["xyz"]

        with ThreadPoolExecutor(4) as pool:
            found = list(pool.map(compute, jobs))
        worst = 0.0
        for (patch, light, observer), xyz in zip(jobs, found):
            power = by_1_nm(colour.SDS_ILLUMINANTS[light], hold=False)
            share = by_1_nm(patches[patch], hold=True)
            bars = curves(observer)
            expected = 100.0 * (bars @ (power * share)) / (bars[1] @ power)
            error = np.max(np.abs(np.array(xyz) / expected - 1.0))
            worst = max(worst, error)
            self.assertLess(error, RELATIVE, f"{patch} under {light} for {observer}: {xyz}, not {expected}")
        print(f"{len(jobs)} tristimulus values, worst relative error {worst:.1e}")


class Models(unittest.TestCase):
    """One random colour after the other through every model that colour-science has too."""

    @classmethod
    def setUpClass(cls):
        generator = random.Random(1)
        cls.colors = [[generator.uniform(0.02, 0.98) for _ in range(3)] for _ in range(12)]
        cls.white = np.array([0.3127, 0.3290])
        cls.srgb = colour.RGB_COLOURSPACES["sRGB"].copy()
        cls.srgb.use_derived_transformation_matrices(True)

    def xyz(self, rgb):
        return colour.RGB_to_XYZ(rgb, self.srgb, apply_cctf_decoding=True)

    def check(self, model, expected, within=MODELS, source="srgb"):
        for rgb in self.colors:
            values = ",".join(map(repr, rgb))
            found = np.array(glanz("color", "convert", "--from", source, "--to", model, values)["values"])
            wanted = np.array(expected(np.array(rgb)))
            scale = np.maximum(np.abs(wanted), 0.05 * max(1.0, np.max(np.abs(wanted))))
            error = np.max(np.abs(found - wanted) / scale)
            self.assertLess(error, within, f"{model} of {rgb}: {found}, not {wanted}")
            back = glanz("color", "convert", "--from", model, "--to", source, ",".join(map(repr, found.tolist())))
            np.testing.assert_allclose(back["values"], rgb, atol=1e-9, err_msg=f"{model} and back")

    def space(self, name):
        space = colour.RGB_COLOURSPACES[name].copy()
        space.use_derived_transformation_matrices(True)
        return space

    def test_linear_srgb(self):
        self.check("srgb-linear", lambda rgb: colour.cctf_decoding(rgb, "sRGB"))

    def test_display_p3(self):
        space = self.space("Display P3")
        self.check("display-p3", lambda rgb: colour.XYZ_to_RGB(self.xyz(rgb), space, apply_cctf_encoding=True))

    def test_rec2020(self):
        space = self.space("ITU-R BT.2020")
        self.check("rec2020", lambda rgb: colour.XYZ_to_RGB(self.xyz(rgb), space, apply_cctf_encoding=True), 2e-3)

    def test_adobe_rgb(self):
        space = self.space("Adobe RGB (1998)")
        self.check("adobe-rgb", lambda rgb: colour.XYZ_to_RGB(self.xyz(rgb), space, apply_cctf_encoding=True))

    def test_acescg(self):
        space = self.space("ACEScg")
        self.check(
            "acescg",
            lambda rgb: colour.XYZ_to_RGB(
                self.xyz(rgb), space, illuminant=self.white, chromatic_adaptation_transform="Bradford"
            ),
        )

    def test_cmy(self):
        self.check("cmy", colour.RGB_to_CMY)

    def test_cmyk(self):
        self.check("cmyk", lambda rgb: colour.CMY_to_CMYK(colour.RGB_to_CMY(rgb)))

    def test_hls(self):
        def hls(rgb):
            hue, saturation, lightness = colour.RGB_to_HSL(rgb)
            return [360.0 * hue, lightness, saturation]

        self.check("hls", hls)

    def test_hsv(self):
        self.check("hsv", lambda rgb: colour.RGB_to_HSV(rgb) * [360.0, 1.0, 1.0])

    def test_xyz(self):
        self.check("xyz", self.xyz)

    def test_xyy(self):
        self.check("xyy", lambda rgb: colour.XYZ_to_xyY(self.xyz(rgb)))

    def test_lab(self):
        self.check("lab", lambda rgb: colour.XYZ_to_Lab(self.xyz(rgb), self.white))

    def test_lch(self):
        self.check("lch", lambda rgb: colour.Lab_to_LCHab(colour.XYZ_to_Lab(self.xyz(rgb), self.white)))

    def test_luv(self):
        self.check("luv", lambda rgb: colour.XYZ_to_Luv(self.xyz(rgb), self.white))

    def test_oklab(self):
        self.check("oklab", lambda rgb: colour.XYZ_to_Oklab(self.xyz(rgb)), 2e-3)

    def test_lms(self):
        matrix = colour.CHROMATIC_ADAPTATION_TRANSFORMS["Von Kries"]
        self.check("lms", lambda rgb: matrix @ self.xyz(rgb))

    def test_ac1c2(self):
        matrix = np.array([[-0.0177, 1.0090, 0.0073], [-1.5370, 1.0821, 0.3209], [0.1946, -0.2045, 0.5264]])
        self.check("ac1c2", lambda rgb: matrix @ self.xyz(rgb))


class Lights(unittest.TestCase):
    def test_lamps_render_colours_as_computed(self):
        for name in ["A", "D50", "D65", "FL2", "FL7", "FL11"]:
            found = glanz("color", "spectrum", name)
            power = colour.SDS_ILLUMINANTS[name]
            rendering = colour.colour_rendering_index(power)
            self.assertLess(abs(found["ra"] - rendering), 0.2, name)


class Whites(unittest.TestCase):
    """Whiteness and yellowness of materials, from the XYZ that are told beside them."""

    MATERIALS = ["paper-white", "newsprint", "paper-brightened", "glaze-celadon"]
    NAMES = {"cie1931": OBSERVERS["cie1931"], "cie1964": OBSERVERS["cie1964"]}

    def test_whiteness_and_tint(self):
        for material in self.MATERIALS:
            for light, observer in [("D65", "cie1931"), ("D65", "cie1964"), ("FL2", "cie1964")]:
                found = glanz("measure", "appearance", material, "--light", light, "--observer", observer)
                xyz = next(color["xyz"] for color in found["colors"] if color["geometry"] == "45/0")
                expected = colour.colorimetry.whiteness_CIE2004(
                    colour.XYZ_to_xy(xyz), xyz[1], colour.XYZ_to_xy(found["white"]), self.NAMES[observer]
                )
                told = [found["whiteness"]["whiteness"], found["whiteness"]["tint"]]
                np.testing.assert_allclose(told, expected, atol=1e-9, err_msg=f"{material} {light} {observer}")

    def test_yellowness_under_the_four_pairs(self):
        for material in self.MATERIALS:
            told = glanz("measure", "appearance", material)["yellowness"]
            self.assertEqual(len(told), 5, material)
            for entry in told:
                light, observer = entry["light"], entry["observer"]
                seen = glanz("measure", "appearance", material, "--light", light, "--observer", observer)
                xyz = next(color["xyz"] for color in seen["colors"] if color["geometry"] == "45/0")
                if entry["standard"] == "astm-d1925":
                    expected = colour.colorimetry.yellowness_ASTMD1925(xyz)
                else:
                    pair = colour.colorimetry.YELLOWNESS_COEFFICIENTS_ASTME313[self.NAMES[observer]][light]
                    expected = colour.colorimetry.yellowness_ASTME313(xyz, C_XZ=pair)
                self.assertAlmostEqual(entry["yellowness"], expected, delta=1e-9, msg=f"{material} {entry}")


class Pictures(unittest.TestCase):
    def test_a_spectral_picture_holds_light_times_reflectance(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "spectra.exr")
            scene = os.path.join(os.path.dirname(__file__), "../../examples/colorchecker.toml")
            # Linear light of a black background, so that a patch is nothing but light times reflectance.
            options = ["--spectral-exr", "--size", "96x66", "--samples", "1", "--mode", "spectral"]
            glanz("render", scene, "-o", path, *options)
            nm, pixels = colour.read_spectral_image_Fichet2021(path)["S0"]
        np.testing.assert_array_equal(nm, GRID)
        daylight = on_grid(colour.SDS_ILLUMINANTS["D65"], hold=False)
        bars = curves("cie1931", GRID)
        unit = daylight / (5.0 * (bars[1] @ daylight))
        patches = colour.SDS_COLOURCHECKERS["ISO 17321-1"]
        for number, name in enumerate(patches):
            row, column = divmod(number, 6)
            pixel = pixels[8 + 16 * row, 8 + 16 * column]
            expected = unit * on_grid(patches[name], hold=True)
            np.testing.assert_allclose(pixel, expected, rtol=2e-4, atol=1e-9, err_msg=name)


if __name__ == "__main__":
    unittest.main()
