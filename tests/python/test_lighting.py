"""Exact light from rectangles, spheres and environments, as Mitsuba's integrator `direct` finds it. `GLANZ_PROGRAM` is the
command `glanz`. Means over a ball and over blocks of 8 × 8 pixels are compared: single pixels of Mitsuba are noisy."""

import os
import pathlib
import subprocess
import tempfile
import unittest

import mitsuba as mi
import numpy as np

PROGRAM = os.environ["GLANZ_PROGRAM"]
SIZE = 64
BLOCK = 8

SCENE = """[image]
width = {size}
height = {size}
samples = 8
supersample = true
background = "transparent"
[camera]
eye = [0.0, 0.0, 5.0]
projection = "orthographic"
height = 2.2
[render]
lighting = "exact"
light_samples = 1024
shadows = {shadows}
[materials.m]
two_sided = true
lobes = [{{ {lobe} }}]
[[lights]]
{light}
color = [1.0, 1.0, 1.0]
"""
BALL = '[[objects]]\nmesh = { sphere = { slices = 256, stacks = 128 } }\nmaterial = "m"\n'
# A floor and a sheet above it.
SHEETS = """[[objects]]
mesh = "quad"
material = "m"
scale = [3.0, 3.0, 1.0]
[[objects]]
mesh = "quad"
material = "m"
scale = [0.3, 0.4, 1.0]
translate = [0.2, 0.1, 1.0]
"""

LIGHTS = {
    "rectangle": 'kind = "rectangle"\nposition = [2.0, 1.5, 2.5]\ntarget = [0.0, 0.0, 0.0]\nwidth = 1.4\nheight = 0.8',
    "sphere": 'kind = "sphere"\nposition = [-1.5, 1.0, 2.5]\nradius = 0.6',
    "environment": 'kind = "environment"\nfile = "room.exr"',
}
LAMBERT = 'shape = "lambert", tint = 1.0'


def rough(shape, alpha, tint="1.0"):
    return f'shape = "{shape}", alpha = {alpha}, multiscatter = 0.0, tint = {tint}'


def conductor(distribution, alpha):
    return {"type": "roughconductor", "material": "none", "distribution": distribution, "alpha": alpha}


def white():
    return {"type": "diffuse", "reflectance": {"type": "rgb", "value": 1.0}}


def room(folder):
    """A room with two bright windows, for both programs: Mitsuba's pictures begin half a turn further."""
    height, width = 128, 256
    v, u = np.meshgrid((np.arange(height) + 0.5) / height, (np.arange(width) + 0.5) / width, indexing="ij")
    theta, phi = v * np.pi, (u - 0.5) * 2 * np.pi
    to = np.stack([np.sin(theta) * np.sin(phi), np.cos(theta), -np.sin(theta) * np.cos(phi)], axis=-1)

    def window(direction, sharpness):
        direction = np.array(direction) / np.linalg.norm(direction)
        return np.exp(sharpness * (to @ direction - 1))

    value = 0.3 + 0.2 * to[..., 1] + 8 * window((-0.5, 0.3, 0.8), 30) + 4 * window((0.7, 0.2, 0.6), 60)
    picture = np.repeat(np.maximum(value, 0.05)[..., None], 3, axis=2).astype(np.float32)
    mi.Bitmap(picture).write(str(folder / "room.exr"))
    mi.Bitmap(np.roll(picture, width // 2, axis=1)).write(str(folder / "room-mitsuba.exr"))


def light(kind, folder):
    to = mi.ScalarTransform4f
    area = {"type": "area", "radiance": {"type": "rgb", "value": 1.0}}
    if kind == "rectangle":
        place = to().look_at([2, 1.5, 2.5], [0, 0, 0], [0, 1, 0]) @ to().scale([0.7, 0.4, 1])
        return {"type": "rectangle", "to_world": place, "emitter": area}
    if kind == "sphere":
        return {"type": "sphere", "center": [-1.5, 1, 2.5], "radius": 0.6, "emitter": area}
    return {"type": "envmap", "filename": str(folder / "room-mitsuba.exr")}


def theirs(shapes, kind, folder, samples):
    to = mi.ScalarTransform4f
    camera = to().look_at([0, 0, 5], [0, 0, 0], [0, 1, 0]) @ to().scale([1.1, 1.1, 1])
    film = {
        "type": "hdrfilm",
        "width": SIZE,
        "height": SIZE,
        "rfilter": {"type": "box"},
        "pixel_format": "rgb",
        "component_format": "float32",
    }
    scene = {
        "type": "scene",
        "integrator": {"type": "direct", "hide_emitters": True},
        "sensor": {
            "type": "orthographic",
            "to_world": camera,
            "film": film,
            "sampler": {"type": "independent", "sample_count": samples},
        },
        "light": light(kind, folder),
    }
    return np.array(mi.render(mi.load_dict(scene | shapes)))[..., 0]


def ours(lobe, kind, objects, folder, shadows):
    file = folder / "scene.toml"
    text = SCENE.format(size=SIZE, lobe=lobe, light=LIGHTS[kind], shadows=str(shadows).lower())
    file.write_text(text + objects)
    words = [PROGRAM, "render", str(file), "-o", str(folder / "ours.exr"), "--force"]
    subprocess.run(words, capture_output=True, text=True, check=True)
    picture = mi.Bitmap(str(folder / "ours.exr"))
    red = [field.name for field in picture.struct_()].index("R")
    return np.array(picture)[..., red]


def blocks(values, mask):
    shape = (SIZE // BLOCK, BLOCK, SIZE // BLOCK, BLOCK)
    count = mask.reshape(shape).sum(axis=(1, 3))
    sums = (values * mask).reshape(shape).sum(axis=(1, 3))
    full = count > BLOCK * BLOCK // 2
    return sums[full] / count[full]


class Lighting(unittest.TestCase):
    def setUp(self):
        mi.set_variant("scalar_rgb")
        self.scratch = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.scratch.name)
        room(self.folder)

    def tearDown(self):
        self.scratch.cleanup()

    def compare(self, name, pictures, mask):
        found, expected = pictures
        mean = expected[mask].mean()
        self.assertAlmostEqual(found[mask].mean() / mean, 1.0, delta=0.01, msg=name)
        errors = np.abs(blocks(found, mask) - blocks(expected, mask))
        # In parts of the brightest block: highlights are small, and brighter than the mean by far.
        self.assertLess(errors.max() / blocks(expected, mask).max(), 0.03, name)

    def test_balls(self):
        cases = [
            (LAMBERT, white(), "rectangle"),
            (LAMBERT, white(), "sphere"),
            (LAMBERT, white(), "environment"),
            (rough("ggx", 0.1), conductor("ggx", 0.1), "rectangle"),
            (rough("ggx", 0.2), conductor("ggx", 0.2), "sphere"),
            (rough("ggx", 0.05), conductor("ggx", 0.05), "environment"),
            (rough("ggx", 0.2), conductor("ggx", 0.2), "environment"),
            (rough("beckmann", 0.1), conductor("beckmann", 0.1), "environment"),
            (rough("beckmann", 0.15), conductor("beckmann", 0.15), "rectangle"),
            (
                rough("ggx", 0.2, "{ ior = 1.5 }"),
                {"type": "roughdielectric", "distribution": "ggx", "alpha": 0.2, "int_ior": 1.5, "ext_ior": 1.0},
                "rectangle",
            ),
        ]
        side = (np.arange(SIZE) + 0.5) / SIZE * 2.2 - 1.1
        mask = np.hypot(side[:, None], side[None, :]) < 0.9
        for lobe, bsdf, kind in cases:
            shapes = {"ball": {"type": "sphere", "radius": 1, "bsdf": bsdf}}
            expected = theirs(shapes, kind, self.folder, 256)
            found = ours(lobe, kind, BALL, self.folder, False)
            self.compare(f"{lobe} under {kind}", (found, expected), mask)

    def test_half_shadows(self):
        to = mi.ScalarTransform4f
        sheet = to().translate([0.2, 0.1, 1]) @ to().scale([0.3, 0.4, 1])
        shapes = {
            "floor": {"type": "rectangle", "to_world": to().scale([3, 3, 1]), "bsdf": white()},
            "sheet": {
                "type": "rectangle",
                "to_world": sheet,
                "bsdf": {"type": "twosided", "bsdf": white()},
            },
        }
        for kind in ("rectangle", "environment"):
            expected = theirs(shapes, kind, self.folder, 256)
            found = ours(LAMBERT, kind, SHEETS, self.folder, True)
            self.compare(f"shadows under {kind}", (found, expected), np.ones((SIZE, SIZE), dtype=bool))


if __name__ == "__main__":
    unittest.main()
