"""Draws the benchmark's sphere with OpenGL on Mesa's llvmpipe and prints one JSON line per measurement.

The work is that of `cargo xtask bench`: 1920×1080, one sphere whose silhouette is 70 % of the height,
Phong shading, Phong's model of 1975, point lights with attenuation, into RGBA8. OpenGL writes linear
values as they are; Glanz also encodes sRGB.

    python llvmpipe.py [--quick] [--picture FILE.ppm] [--probe] [--serve]
"""

import argparse
import json
import math
import os
import statistics
import sys
import time

# Before Mesa is loaded: as many threads as Glanz gets.
os.environ.setdefault("LP_NUM_THREADS", "2")
os.environ.setdefault("LIBGL_ALWAYS_SOFTWARE", "1")
os.environ.setdefault("GALLIUM_DRIVER", "llvmpipe")

import moderngl
import numpy as np

WIDTH, HEIGHT = 1920, 1080
FOV_Y = math.radians(40.0)
SILHOUETTE = 0.7
# The distance at which a unit sphere's outline covers that part of the height.
DISTANCE = math.hypot(1.0, 1.0 / (SILHOUETTE * math.tan(FOV_Y / 2)))

VERTEX = """
#version 330
uniform mat4 view_projection;
in vec3 position;
in vec3 normal;
out vec3 world;
out vec3 world_normal;
void main() {
    world = position;
    world_normal = normal;
    gl_Position = view_projection * vec4(position, 1.0);
}
"""

FRAGMENT = """
#version 330
const int LIGHTS = %d;
uniform vec3 eye;
uniform vec3 light_position[LIGHTS];
uniform vec3 light_color[LIGHTS];
uniform vec3 attenuation;
uniform vec3 ambient;
uniform vec3 diffuse;
uniform vec3 specular;
uniform float shininess;
in vec3 world;
in vec3 world_normal;
out vec4 color;
void main() {
    vec3 n = normalize(world_normal);
    vec3 v = normalize(eye - world);
    if (dot(n, v) < 0.0) n = -n;
    vec3 sum = ambient;
    for (int i = 0; i < LIGHTS; i++) {
        vec3 to_light = light_position[i] - world;
        float d2 = dot(to_light, to_light);
        float d = sqrt(d2);
        vec3 l = to_light / d;
        float n_l = dot(n, l);
        if (n_l > 0.0) {
            float fade = 1.0 / (attenuation.x + attenuation.y * d + attenuation.z * d2);
            vec3 r = 2.0 * n_l * n - l;
            float highlight = pow(max(dot(r, v), 0.0), shininess);
            sum += fade * light_color[i] * (diffuse * n_l + specular * highlight);
        }
    }
    color = vec4(sum, 1.0);
}
"""


def sphere(slices, stacks):
    """Vertices (position and normal) and triangles of a unit sphere with its poles on Y."""
    theta = np.linspace(0.0, np.pi, stacks + 1)[:, None]
    phi = np.linspace(0.0, 2.0 * np.pi, slices + 1)[None, :]
    points = np.stack(
        [np.sin(theta) * np.sin(phi), np.cos(theta) * np.ones_like(phi), np.sin(theta) * np.cos(phi)], axis=-1
    )
    vertices = np.concatenate([points, points], axis=-1).reshape(-1, 6).astype("f4")
    row, column = np.meshgrid(np.arange(stacks), np.arange(slices), indexing="ij")
    a = row * (slices + 1) + column
    b, c, d = a + slices + 1, a + slices + 2, a + 1
    upper = np.stack([a, b, d], axis=-1)[1:]
    lower = np.stack([b, c, d], axis=-1)[:-1]
    triangles = np.concatenate([upper.reshape(-1, 3), lower.reshape(-1, 3)]).astype("u4")
    return vertices, triangles


def lights(count):
    """Positions on a circle before the sphere; together they are as bright as one white light."""
    angles = 2.0 * np.pi * (np.arange(count) + 0.125) / count
    positions = np.stack([3.0 * np.cos(angles), 3.0 * np.sin(angles), np.full(count, 3.0)], axis=-1)
    return positions.astype("f4"), np.full((count, 3), 1.0 / count, "f4")


def view_projection():
    """The matrix of a camera on +Z, transposed as OpenGL reads it."""
    near, far = 0.1, 100.0
    f = 1.0 / math.tan(FOV_Y / 2)
    projection = np.array(
        [
            [f * HEIGHT / WIDTH, 0, 0, 0],
            [0, f, 0, 0],
            [0, 0, (far + near) / (near - far), 2 * far * near / (near - far)],
            [0, 0, -1, 0],
        ]
    )
    view = np.eye(4)
    view[2, 3] = -DISTANCE
    return (projection @ view).T.astype("f4")


def prepare(context, slices, stacks, count):
    """The program with its uniforms, and the sphere's vertex array."""
    program = context.program(vertex_shader=VERTEX, fragment_shader=FRAGMENT % count)
    positions, colors = lights(count)
    program["view_projection"].write(view_projection().tobytes())
    program["eye"].value = (0.0, 0.0, DISTANCE)
    program["light_position"].write(positions.tobytes())
    program["light_color"].write(colors.tobytes())
    program["attenuation"].value = (1.0, 0.0, 0.0)
    program["ambient"].value = (0.05, 0.01, 0.01)
    program["diffuse"].value = (0.8, 0.1, 0.1)
    program["specular"].value = (0.6, 0.6, 0.6)
    program["shininess"].value = 32.0
    vertices, triangles = sphere(slices, stacks)
    array = context.vertex_array(
        program,
        [(context.buffer(vertices.tobytes()), "3f 3f", "position", "normal")],
        context.buffer(triangles.tobytes()),
    )
    return array, len(triangles)


def measure(context, target, array, frames):
    """Seconds per frame: until all is drawn, and until the picture has been read back."""
    pixels = bytearray(4 * WIDTH * HEIGHT)
    drawn, read = [], []
    for frame in range(frames + frames // 4):
        seconds = draw(context, target, array)
        start = time.perf_counter()
        target.read_into(pixels, components=4)
        if frame >= frames // 4:
            drawn.append(seconds)
            read.append(seconds + time.perf_counter() - start)
    return drawn, read, pixels


def serve(context, target):
    """Answers each line "64x32 1 10" (sphere, lights, frames) with the milliseconds of each frame."""
    kept = {}
    for line in sys.stdin:
        sphere_name, count, frames = line.split()
        slices, stacks = map(int, sphere_name.split("x"))
        key = (slices, stacks, int(count))
        if key not in kept:
            kept[key], _ = prepare(context, *key)
            # A picture that is not the one that everybody draws would be noticed here.
            check(measure(context, target, kept[key], 1)[2], slices)
        times = []
        for _ in range(int(frames)):
            times.append(1e3 * draw(context, target, kept[key]))
        print(json.dumps(times), flush=True)


def draw(context, target, array):
    """Draws a frame; seconds until all of it is there."""
    start = time.perf_counter()
    target.clear(0.05, 0.05, 0.08, 1.0, depth=1.0)
    array.render()
    context.finish()
    target.read(viewport=(WIDTH // 2, HEIGHT // 2, 1, 1), components=4)
    return time.perf_counter() - start


def check(pixels, slices):
    """Stops where the picture is not the one that everybody draws."""
    picture = np.frombuffer(bytes(pixels), "u1").reshape(HEIGHT, WIDTH, 4)
    covered = np.any(picture[:, :, :3] != picture[0, 0, :3], axis=-1)
    share = np.count_nonzero(covered) / (math.pi * (SILHOUETTE * HEIGHT / 2) ** 2)
    # A polygon with this many corners covers less than the circle around it.
    expected = math.sin(2 * math.pi / slices) / (2 * math.pi / slices)
    if not expected - 0.02 < share < 1.01:
        raise SystemExit(f"error: the sphere covers {share:.3f} of its circle; {expected:.3f} was expected")
    return picture


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--quick", action="store_true", help="fewer frames")
    parser.add_argument("--probe", action="store_true", help="only see whether OpenGL works without a screen")
    parser.add_argument("--serve", action="store_true", help="draw what lines on standard input ask for")
    parser.add_argument("--picture", help="write the picture of 8 lights to this PPM file")
    options = parser.parse_args()

    context = moderngl.create_context(standalone=True, backend="egl")
    if options.probe:
        return
    context.enable(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
    target = context.framebuffer(
        [context.renderbuffer((WIDTH, HEIGHT), 4)], context.depth_renderbuffer((WIDTH, HEIGHT))
    )
    target.use()
    if options.serve:
        return serve(context, target)
    for slices, stacks, frames in [(64, 32, 200), (1024, 512, 40)]:
        for count in (1, 4, 8):
            array, triangles = prepare(context, slices, stacks, count)
            drawn, read, pixels = measure(context, target, array, frames // 5 if options.quick else frames)
            picture = check(pixels, slices)
            result = {
                "program": "llvmpipe",
                "version": f"{context.info['GL_VERSION']}, {context.info['GL_RENDERER']}",
                "threads": int(os.environ["LP_NUM_THREADS"]),
                "sphere": f"{slices}x{stacks}",
                "triangles": triangles,
                "lights": count,
                "frames": len(drawn),
                "median_ms": round(1e3 * statistics.median(drawn), 3),
                "min_ms": round(1e3 * min(drawn), 3),
                "max_ms": round(1e3 * max(drawn), 3),
                "with_readback_median_ms": round(1e3 * statistics.median(read), 3),
                "with_readback_min_ms": round(1e3 * min(read), 3),
            }
            print(json.dumps(result), flush=True)
    if options.picture:
        with open(options.picture, "wb") as file:
            file.write(f"P6 {WIDTH} {HEIGHT} 255\n".encode() + picture[::-1, :, :3].tobytes())


main()
