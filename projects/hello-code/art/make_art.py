#!/usr/bin/env python3
"""Draws the two pictures of hello-code. Run it from anywhere; the same files come out every time. CC0."""
import struct
import zlib
from pathlib import Path

ASSETS = Path(__file__).resolve().parent.parent / "assets"
PALETTE = {".": (0, 0, 0, 0), "k": (34, 32, 52, 255), "r": (172, 50, 50, 255), "R": (217, 87, 99, 255),
           "s": (238, 195, 154, 255), "w": (255, 255, 255, 255), "b": (63, 63, 116, 255), "y": (251, 242, 54, 255)}

BODY = """
................
.....kkkkkk.....
....kRRRRRRk....
...kRRRRRRRRk...
...kRssssssRk...
...kssksskssk...
...kssksskssk...
...kssssssssk...
....kssssssk....
...krrrrrrrrk...
..krrryrryrrrk..
..ksrrrrrrrrsk..
...krrrrrrrrk...
""".split()
LEGS = [
    ["...kbbbkkbbbk...", "...kbbk..kbbk...", "...kkkk..kkkk..."],
    ["..kbbbk.kbbbk...", ".kbbk....kbbk...", ".kkk......kkk..."],
    ["...kbbbkkbbbk...", "....kbbkkbbk....", "....kkkkkkkk...."],
    ["...kbbbk.kbbbk..", "..kbbk....kbbk..", "..kkk......kkk.."],
]


def write_png(path, rows):
    raw = b"".join(b"\0" + b"".join(bytes(pixel) for pixel in row) for row in rows)
    chunk = lambda kind, data: (struct.pack(">I", len(data)) + kind + data
                                + struct.pack(">I", zlib.crc32(kind + data)))
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 6, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(raw, 9))
                     + chunk(b"IEND", b""))


def doubled(rows):
    return [[pixel for pixel in row for _ in range(2)] for row in rows for _ in range(2)]


def player():
    frames = [doubled([[PALETTE[c] for c in line] for line in BODY + legs]) for legs in LEGS]
    return [sum((frame[y] for frame in frames), []) for y in range(32)]


def platform():
    grass, dark_grass = (106, 190, 48, 255), (55, 148, 110, 255)
    earth, stone, edge = (143, 86, 59, 255), (102, 57, 49, 255), (69, 40, 60, 255)
    rows = []
    for y in range(20):
        row = []
        for x in range(100):
            blade = (x * 7 + x // 3) % 4
            if x in (0, 99) or y == 19:
                color = edge
            elif y < 3 + blade % 2:
                color = grass
            elif y < 4 + blade:
                color = dark_grass
            else:
                color = stone if (x * 5 + y * 11 + (x * y) % 7) % 17 == 0 else earth
            row.append(color)
        rows.append(row)
    return rows


if __name__ == "__main__":
    write_png(ASSETS / "player.png", player())
    write_png(ASSETS / "platform.png", platform())
