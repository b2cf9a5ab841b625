#!/usr/bin/env python3
"""Draws the two pictures of the sample game into ../assets. CC0, standard library only.

    make_art.py            writes the files
    make_art.py --check    writes nothing; fails when a committed file differs from what would be written
"""

import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "assets/tools"))

from art_files import png, write_or_check  # noqa: E402

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


def picture(rows):
    return png(len(rows[0]), len(rows), [part for row in rows for pixel in row for part in pixel])


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


FILES = {
    "player.png": lambda: picture(player()),
    "platform.png": lambda: picture(platform()),
}

if __name__ == "__main__":
    sys.exit(write_or_check(FILES.items(), ASSETS))
