"""Shaders of users on Mesa's llvmpipe and on the lane machine in turn, each on one core.

Prints one JSON line per shader: Mfragments in a second, median, least and spread of both.

    python shaders.py PROGRAM FILE…    PROGRAM is the example `bench` of glanz-shader
"""

import json
import os
import re
import statistics
import struct
import subprocess
import sys
import time

os.environ["LP_NUM_THREADS"] = "0"
os.environ.setdefault("LIBGL_ALWAYS_SOFTWARE", "1")
os.environ.setdefault("GALLIUM_DRIVER", "llvmpipe")

import moderngl

SIDE, TURNS = 1024, 9


def vertex(inputs):
    """A triangle over all pixels whose outputs vary."""
    outs = "".join(f"out {kind} {name};\n" for kind, name in inputs)
    sets = "".join(f"{name} = {kind}(at.x - 0.5);\n" for kind, name in inputs)
    return (
        f"#version 330\n{outs}void main() {{ vec2 at = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;\n{sets}"
        "gl_Position = vec4(at * 2.0 - 1.0, 0.0, 1.0); }"
    )


def prepare(context, text):
    inputs = re.findall(r"^in (\w+) (\w+);", text, re.M)
    program = context.program(vertex_shader=vertex(inputs), fragment_shader=text)
    for number, name in enumerate(program):
        member = program[name]
        if isinstance(member, moderngl.Uniform):
            count = member.dimension * member.array_length
            # Each with numbers of its own, as the other one has them.
            values = [3] if name == "nLights" else [0.4 + 0.01 * ((number * 7 + k * 3) % 31) for k in range(count)]
            member.write(struct.pack("=" + ("i" if name == "nLights" else "f") * count, *values))
    return context.vertex_array(program, [])


def llvmpipe(context, array):
    start = time.perf_counter()
    array.render(moderngl.TRIANGLES, vertices=3)
    context.finish()
    return SIDE * SIDE * 1e-6 / (time.perf_counter() - start)


def main():
    ours, *files = sys.argv[1:]
    context = moderngl.create_standalone_context(backend="egl")
    target = context.framebuffer([context.texture((SIDE, SIDE), 4)])
    target.use()
    for file in files:
        with open(file, encoding="utf-8") as text:
            array = prepare(context, text.read())
        llvmpipe(context, array)
        speeds = {"glanz": [], "llvmpipe": []}
        for _ in range(TURNS):
            speeds["glanz"].append(float(subprocess.check_output([ours, "--turn", file])))
            speeds["llvmpipe"].append(statistics.median(llvmpipe(context, array) for _ in range(9)))
        row = {"table": "Shaders of users in turn with llvmpipe, one core, Mfragments/s", "name": os.path.basename(file)}
        for name, values in speeds.items():
            median = statistics.median(values)
            row[name] = round(median, 1)
            row[f"{name}, least"] = round(min(values), 1)
            row[f"{name}, spread"] = f"{(max(values) - min(values)) / median:.0%}"
        print(json.dumps(row), flush=True)


if __name__ == "__main__":
    main()
