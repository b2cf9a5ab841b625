#!/usr/bin/env python3
"""Draws every picture and makes every sound of hello-code into ../assets. CC0, standard library only.

    make_art.py            writes the files
    make_art.py --check    writes nothing; fails when a committed file differs from what would be written
"""

import math
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "assets/tools"))

from art_files import late, mix, noise, png, tone, wav, write_or_check  # noqa: E402

ASSETS = Path(__file__).resolve().parent.parent / "assets"
CLEAR = (0, 0, 0, 0)
WIDTH, HEIGHT = 320, 180  # px, of the sky; the hills repeat after WIDTH
DUSK = [(15, 13, 36), (24, 18, 54), (40, 26, 76), (66, 36, 96), (104, 50, 108), (156, 74, 110), (208, 112, 104),
        (244, 168, 110)]
BAYER = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]]  # the ordered dither of 4 x 4 px

LETTERS = {".": CLEAR, "k": (24, 20, 44, 255), "w": (238, 242, 250, 255), "g": (152, 164, 196, 255),
           "c": (92, 214, 240, 255), "b": (42, 120, 190, 255), "r": (240, 92, 84, 255), "d": (160, 44, 70, 255),
           "y": (255, 226, 140, 255)}
SHIP = """
.......kk.......
......kwgk......
......kwgk......
.....kwwggk.....
.....kwcbgk.....
.....kwcbgk.....
....kwwcbggk....
.kk.kwwwgggk.kk.
.krkkwwwgggkkdk.
.krkwwwwggggkdk.
krrwwwwwggggddkk
krrwwwwwggggdddk
krrkwwwwgggkkddk
.kk.kwwwgggk.kk.
.....kyyyyk.....
......kkkk......
""".split()
HEART = """
.kk...kk.
kwrk.krrk
kwrrkrrdk
krrrrrrdk
.krrrrdk.
..krrdk..
...kdk...
....k....
""".split()


def picture(width, height, color):
    """`color(x, y)` gives red, green, blue and opacity."""
    return png(width, height, [part for y in range(height) for x in range(width) for part in color(x, y)])


def drawn(lines, columns=1):
    """A drawing of LETTERS, `columns` times side by side."""
    return picture(len(lines[0]) * columns, len(lines), lambda x, y: LETTERS[lines[y][x % len(lines[0])]])


def chance(*keys):
    """A number in 0..1 that depends on whole numbers only."""
    h = 0x9E3779B9
    for key in keys:
        h = (h ^ key & 0xFFFFFFFF) * 0x85EBCA6B & 0xFFFFFFFF
        h ^= h >> 13
        h = h * 0xC2B2AE35 & 0xFFFFFFFF
        h ^= h >> 16
    return h / 0xFFFFFFFF


def sky(x, y):
    moon = math.hypot(x - 246, y - 42)
    if moon < 19:
        crater = min(math.hypot(x - 240, y - 36) - 4, math.hypot(x - 252, y - 48) - 5, math.hypot(x - 251, y - 34) - 2)
        return (224, 208, 200, 255) if crater < 0 else (250, 236, 214, 255)
    place = (y / HEIGHT) ** 1.3 * (len(DUSK) - 1) + max(0.0, 1.2 - moon / 45)
    step = min(int(place), len(DUSK) - 2)
    star = chance(x, y, 7)
    if star > 0.9965 and y < 110:
        return (255, 250, 235, 255) if star > 0.9985 else (150, 130, 170, 255)
    return (*DUSK[step + (place - step > (BAYER[y % 4][x % 4] + 0.5) / 16)], 255)


def ridge(x, waves):
    """Height of a chain of hills, px; waves: pairs of how often one repeats in WIDTH and its height."""
    return sum(high * math.sin(math.tau * (often * x / WIDTH + 0.13 * often)) for often, high in waves)


def far_hills(x, y):
    top = 26 - ridge(x, ((2, 12), (5, 6), (11, 3), (29, 1)))
    return CLEAR if y < top else (86, 48, 104, 255) if y < top + 1.5 else (62, 36, 88, 255)


def near_hills(x, y):
    for tree in range(-1, 41):  # one in 8 px, more or less
        middle = tree * 8 + round(chance(tree % 40, 3) * 6)
        high = 9 + round(chance(tree % 40, 5) * 9)
        foot = 26 - ridge(middle, ((1, 9), (3, 6), (7, 3)))
        row = y - (foot - high)
        if 0 <= row <= high + 2 and abs(x - middle) <= (row % 5) * 0.45 + row * 0.16:
            return (34, 24, 58, 255)
    return CLEAR if y < 26 - ridge(x, ((1, 9), (3, 6), (7, 3))) else (34, 24, 58, 255)


def ground(x, y):
    for number, left in enumerate((22, 41, 57, 148, 169, 248, 266, 285)):  # houses with lit windows
        wide, high = 11 + number * 5 % 4, 8 + number * 7 % 4
        i, j = x - left, y - (12 - high)
        if 0 <= i < wide and 0 <= j < high + 2:
            lit = 2 <= j < 5 and i in (2, 3, wide - 4, wide - 3)
            return (255, 208, 110, 255) if lit else (26, 20, 44, 255)
        if -3 <= j < 0 and abs(i - (wide - 1) / 2) <= wide / 2 + 1 + j:
            return (52, 30, 58, 255)
    top = 12 + (chance(x, 1) < 0.35)
    return CLEAR if y < top else (44, 34, 66, 255) if y < top + 1 else (18, 15, 34, 255)


def meteor(x, y):
    """Three rocks in cells of 24 px, each smaller than the one before."""
    kind, i, j = x // 24, x % 24 - 11.5, y - 11.5
    radius, angle = (11.0, 7.5, 4.8)[kind], math.atan2(j, i)
    edge = radius * (0.92 + 0.07 * math.sin(3 * angle + kind) + 0.05 * math.sin(7 * angle + 2 * kind))
    depth = edge - math.hypot(i, j)
    if depth < 0:
        return CLEAR
    if depth < 1.1:
        return (36, 20, 30, 255)
    light = (i - j) / radius + 0.5 * chance(x // 2, y // 2, kind)
    crater = min(math.hypot(i - radius * a, j - radius * b) - radius * c for a, b, c in
                 ((-0.3, -0.2, 0.26), (0.35, 0.3, 0.2), (0.1, -0.55, 0.15)))
    if crater < 0:
        return (92, 50, 52, 255)
    return (214, 142, 104, 255) if light > 0.9 else (168, 98, 80, 255) if light > 0 else (122, 66, 64, 255)


def shot(x, y):
    across, along = abs(x - 2), min(y, 9 - y)
    if across == 0 and along > 0:
        return (255, 255, 255, 255)
    return (110, 232, 250, 230 if across < 2 and along > 1 else 60)


def notes(*pitches):
    return mix(*(late(0.08 * i, tone(0.22, pitch, pitch, 0.26, 0.3)) for i, pitch in enumerate(pitches)))


FILES = {
    "sky.png": lambda: picture(WIDTH, HEIGHT, sky),
    "far_hills.png": lambda: picture(WIDTH, 110, far_hills),
    "near_hills.png": lambda: picture(WIDTH, 90, near_hills),
    "ground.png": lambda: picture(WIDTH, 48, ground),
    "ship.png": lambda: drawn(SHIP),
    "hearts.png": lambda: drawn(HEART, 3),
    "meteor.png": lambda: picture(72, 24, meteor),
    "shot.png": lambda: picture(5, 10, shot),
    "shot.wav": lambda: wav(tone(0.1, 1100, 330, 0.14, 0.4)),
    "hit.wav": lambda: wav(mix(noise(0.28, 0.6, 0.6), tone(0.14, 380, 90, 0.3, 0.3))),
    "hurt.wav": lambda: wav(mix(noise(0.5, 0.5, 0.8), tone(0.4, 260, 50, 0.5, 0.5))),
    "start.wav": lambda: wav(notes(392.0, 523.3, 659.3, 784.0)),
    "over.wav": lambda: wav(mix(notes(440.0, 370.0, 311.1, 220.0), noise(0.9, 0.4, 0.7))),
}

if __name__ == "__main__":
    sys.exit(write_or_check(FILES.items(), ASSETS))
