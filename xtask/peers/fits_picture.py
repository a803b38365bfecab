"""Balls of measured files, above, and of their fits, by cube roots and by rendered colours, below, in one picture.

    python fits_picture.py GLANZ PICTURE.png FILE...

For each file `glanz measure fit` writes its best fit by either metric as a material; one scene has all of them, the data as
they are drawn.
"""

import math
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

# One of these is the best of docs/MEASURED.md's candidates for each of its files.
MODELS = "cook-torrance+lambert,ggx:schlick+diffuse"
METRICS = ["cube-root", "rendered"]

# Two lamps; the camera is far away, so that all balls are seen alike.
STAGE = """
[image]
width = {width}
height = {height}
samples = 8
background = [0.05, 0.05, 0.055]

[render]
mode = "spectral"
tone_map = "khronos-neutral"

[camera]
eye = [0.0, 0.0, 60.0]
target = [0.0, 0.0, 0.0]
fov_deg = {fov}

[[lights]]
kind = "directional"
direction = [0.7, -0.8, -1.0]
color = 1.1

[[lights]]
kind = "directional"
direction = [-1.3, -0.2, 0.4]
color = 0.7
"""

BALL = """
[[objects]]
mesh = {{ sphere = {{ slices = 96, stacks = 48 }} }}
material = "{material}"
scale = 0.94
translate = [{x}, {y}, 0.0]
"""


def fitted(glanz, file, folder, name, metric):
    """The material of the best fit, under a name of its own."""
    path = folder / f"{name}.toml"
    subprocess.run([glanz, "measure", "fit", file, "--models", MODELS, "--metric", metric, "-o", path], check=True)
    return path.read_text().replace("[materials.fitted]", f"[materials.{name}]")


def main():
    glanz, picture, *files = sys.argv[1:]
    cell, count = 78, len(files)
    # Three rows of height 2 fill the picture from top to bottom at a distance of 60.
    text = STAGE.format(width=cell * count, height=3 * cell, fov=2 * math.degrees(math.atan(3 / 60)))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for number, file in enumerate(files):
            # A scene names files of its own folder only.
            shutil.copyfile(file, folder / Path(file).name)
            text += f'\n[materials.data-{number}]\nmeasured = {{ file = "{Path(file).name}" }}\n'
            x = 2 * number - count + 1
            text += BALL.format(material=f"data-{number}", x=x, y=2.0)
            for row, metric in enumerate(METRICS):
                material = f"{metric}-{number}"
                text += fitted(glanz, file, folder, material, metric)
                text += BALL.format(material=material, x=x, y=-2.0 * row)
        scene = folder / "scene.toml"
        scene.write_text(text)
        subprocess.run([glanz, "render", scene, "--force", "-o", picture], check=True)


if __name__ == "__main__":
    main()
