"""Makes studio.hdr, the environment map of the examples: a dim room with a window, two soft boxes and a floor.

    python3 examples/data/studio.py examples/data/studio.hdr
"""

import math
import struct
import sys

WIDTH, HEIGHT = 256, 128


def radiance(x, y, z):
    """Linear RGB from a direction: +Y is up, -Z the middle of the picture."""
    ground = max(-y, 0.0)
    wall = [0.20 + 0.15 * y, 0.21 + 0.16 * y, 0.24 + 0.20 * y] if y > 0.0 else [0.16, 0.13, 0.10]
    if y < -0.02:
        # A floor of tiles, one metre below.
        u, v = x / ground, z / ground
        dark = (math.floor(u) + math.floor(v)) % 2
        fade = math.exp(-0.15 * (u * u + v * v) ** 0.5)
        tile = 0.06 if dark else 0.42
        wall = [c * (1 - fade) + tile * fade * w for c, w in zip(wall, (1.0, 0.92, 0.8))]
    if z > 0.2:
        # A window of four panes behind the viewer, to the left.
        u, v = x / z + 0.7, y / z - 0.55
        if abs(u) < 0.42 and abs(v) < 0.42 and min(abs(u), abs(v)) > 0.035:
            return [7.0, 8.2, 10.0]
    if x > 0.3:
        u, v = z / x - 0.2, y / x - 0.5
        if abs(u) < 0.45 and abs(v) < 0.22:
            return [9.0, 7.6, 5.6]
    if y > 0.5 and abs(x / y) < 0.5 and abs(z / y + 0.9) < 0.12:
        return [6.0, 6.0, 6.0]
    return wall


def rgbe(color):
    """Four bytes of Ward's shared exponent."""
    greatest = max(color)
    if greatest < 1e-32:
        return bytes(4)
    fraction, exponent = math.frexp(greatest)
    scale = fraction * 256.0 / greatest
    return struct.pack("4B", *(min(int(c * scale), 255) for c in color), exponent + 128)


def main(path):
    rows = bytearray(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (HEIGHT, WIDTH))
    steps = [(i + 0.5) / 4 for i in range(4)]
    for row in range(HEIGHT):
        for column in range(WIDTH):
            total = [0.0] * 3
            for dv in steps:
                for du in steps:
                    theta = (row + dv) / HEIGHT * math.pi
                    phi = ((column + du) / WIDTH - 0.5) * 2 * math.pi
                    ring = math.sin(theta)
                    value = radiance(ring * math.sin(phi), math.cos(theta), -ring * math.cos(phi))
                    total = [t + c / 16 for t, c in zip(total, value)]
            rows += rgbe(total)
    with open(path, "wb") as file:
        file.write(rows)


main(sys.argv[1])
