"""Writes the files that the scenes beside it name: a texture, a normal map, a profile, a glTF panel, coloured triangles.

Run once: python3 make.py. The standard library is enough; every number is written here.
"""

import base64
import json
import math
import struct
import zlib


def png(path, width, height, pixel):
    rows = b"".join(b"\0" + bytes(c for x in range(width) for c in pixel(x, y)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def checks(x, y):
    light = (x // 4 + y // 4) % 2 == 0
    alpha = 0 if (x - 16) ** 2 + (y - 16) ** 2 < 25 else 255
    return (230, 220, 180 + x, alpha) if light else (40 + 4 * y, 60, 150, alpha)


def bumps(x, y):
    slope = [0.5 * math.sin(2.0 * math.pi * v / 8.0) for v in (x, y)]
    length = math.sqrt(slope[0] ** 2 + slope[1] ** 2 + 1.0)
    normal = [slope[0] / length, slope[1] / length, 1.0 / length]
    return tuple(round(127.5 * (c + 1.0)) for c in normal) + (255,)


def rough_metal(x, y):
    return (255, 40 + 6 * y, 255 if x >= 16 else 0, 255)


png("checks.png", 32, 32, checks)
png("bumps.png", 32, 32, bumps)
png("rough-metal.png", 32, 32, rough_metal)

with open("wing.ies", "w", newline="\r\n") as file:
    gammas = [0, 15, 30, 45, 60, 75, 90]
    candela = {0: [600, 700, 900, 1000, 700, 150, 0], 45: [600, 620, 640, 500, 300, 90, 0], 90: [600, 500, 350, 220, 120, 40, 0]}
    file.write("IESNA:LM-63-2002\n[TEST] none\n[MANUFAC] none\nTILT=NONE\n")
    file.write(f"1 1000 1 {len(gammas)} {len(candela)} 1 2 0.1 0.1 0\n1 1 10\n")
    file.write(" ".join(map(str, gammas)) + "\n" + " ".join(map(str, candela)) + "\n")
    for row in candela.values():
        file.write(" ".join(map(str, row)) + "\n")

positions = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
uvs = [(0, 1), (1, 1), (1, 0), (0, 0)]
data = b"".join(struct.pack("<3f", *p) for p in positions) + struct.pack("<3f", 0, 0, 1) * 4
data += b"".join(struct.pack("<2f", *t) for t in uvs) + struct.pack("<6H", 0, 1, 2, 0, 2, 3)
document = {
    "asset": {"version": "2.0"},
    "extensionsUsed": ["KHR_materials_clearcoat"],
    "scene": 0,
    "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3, "material": 0}]}],
    "materials": [{
        "name": "panel",
        "doubleSided": True,
        "pbrMetallicRoughness": {
            "baseColorFactor": [0.9, 0.6, 0.3, 1.0],
            "metallicRoughnessTexture": {"index": 0},
        },
        "extensions": {"KHR_materials_clearcoat": {"clearcoatFactor": 0.6, "clearcoatRoughnessFactor": 0.2}},
    }],
    "textures": [{"source": 0, "sampler": 0}],
    "samplers": [{"wrapS": 33071, "wrapT": 33071}],
    "images": [{"uri": "rough-metal.png"}],
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]},
        {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"},
        {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC2"},
        {"bufferView": 3, "componentType": 5123, "count": 6, "type": "SCALAR"},
    ],
    "bufferViews": [
        {"buffer": 0, "byteOffset": 0, "byteLength": 48},
        {"buffer": 0, "byteOffset": 48, "byteLength": 48},
        {"buffer": 0, "byteOffset": 96, "byteLength": 32},
        {"buffer": 0, "byteOffset": 128, "byteLength": 12},
    ],
    "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
}
with open("panel.gltf", "w") as file:
    json.dump(document, file, indent=1)
    file.write("\n")

with open("colours.ply", "w") as file:
    file.write("ply\nformat ascii 1.0\nelement vertex 5\n")
    for name in "xyz":
        file.write(f"property float {name}\n")
    for name in ("red", "green", "blue", "alpha"):
        file.write(f"property uchar {name}\n")
    file.write("element face 2\nproperty list uchar int vertex_indices\nend_header\n")
    for x, y, z, r, g, b in [(-1, -1, 0, 255, 40, 40), (1, -1, 0, 40, 255, 40), (1, 1, 0.3, 40, 40, 255), (-1, 1, 0, 250, 250, 60), (0, 1.6, 0, 255, 255, 255)]:
        file.write(f"{x} {y} {z} {r} {g} {b} 255\n")
    file.write("4 0 1 2 3\n3 3 2 4\n")


def rgbe(r, g, b):
    mantissa, exponent = math.frexp(max(r, g, b))
    scale = mantissa * 256.0 / max(r, g, b)
    return bytes([int(r * scale), int(g * scale), int(b * scale), exponent + 128])


def room(column, row):
    window = 20 <= column < 26 and 8 <= row < 14
    ground = row >= 16
    return rgbe(12.0, 13.0, 16.0) if window else rgbe(0.25, 0.2, 0.15) if ground else rgbe(0.4, 0.45, 0.6)


with open("room.hdr", "wb") as file:
    file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n")
    file.write(b"".join(room(column, row) for row in range(32) for column in range(64)))
