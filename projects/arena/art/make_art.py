#!/usr/bin/env python3
"""Draws every picture and makes every sound of the arena into ../assets. CC0, standard library only.

    make_art.py            writes the files
    make_art.py --check    writes nothing; fails when a committed file differs from what would be written

Shapes are white with a glow: each sprite's tint gives them their color, and a white tint makes them flash.
"""

import math
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "assets/tools"))

from art_files import RATE, late, mix, noise, png, tone, wav, write_or_check  # noqa: E402

ASSETS = Path(__file__).resolve().parent.parent / "assets"
FINE = 3  # samples a side for each pixel

# ---- pictures: a shape is a function of x and y that returns the distance to its border, px, negative inside ----


def circle(radius):
    return lambda x, y: math.hypot(x, y) - radius


def capsule(length, radius):
    return lambda x, y: math.hypot(x - min(max(x, -length / 2), length / 2), y) - radius


def polygon(corners, radius):
    """A regular polygon, one corner upwards, or a star if `radius` is a pair."""
    radii = radius if isinstance(radius, tuple) else (radius, radius)
    points = [(radii[i % 2] * math.sin(math.tau * i / corners), -radii[i % 2] * math.cos(math.tau * i / corners))
              for i in range(corners)]

    def distance(x, y):
        nearest, inside = math.inf, False
        for (ax, ay), (bx, by) in zip(points, points[1:] + points[:1]):
            along = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / ((bx - ax) ** 2 + (by - ay) ** 2)
            along = min(max(along, 0.0), 1.0)
            nearest = min(nearest, math.hypot(x - ax - along * (bx - ax), y - ay - along * (by - ay)))
            if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
                inside = not inside
        return -nearest if inside else nearest

    return distance


def neon(shape, line=3.0, fill=0.22, glow=7.0):
    """The opacity of a glowing outline; the shape's inside is filled faintly."""
    def opacity(x, y):
        depth = shape(x, y)
        if -line <= depth <= 0:
            return 1.0
        light = 0.55 * math.exp(-(depth if depth > 0 else -depth - line) / glow)
        return max(light, fill) if depth < 0 else light
    return opacity


def both(a, b):
    return lambda x, y: max(a(x, y), b(x, y))


def spark(x, y):
    return max(0.0, 1.0 - math.hypot(x, y) / 16) ** 2


def grid(x, y):
    return 0.5 if min(abs(x), abs(y)) < 1 else 0.0


def pips(x, y):
    """Eight bars in a row, for the points of a hull."""
    return 1.0 if capsule(10, 4)(y, (x + 96) % 24 - 12) <= 0 else 0.0


def white(width, height, opacity):
    """White, with an opacity that depends on the distance from the middle."""
    rgba = bytearray()
    for y in range(height):
        for x in range(width):
            total = sum(opacity(x + (i + 0.5) / FINE - width / 2, y + (j + 0.5) / FINE - height / 2)
                        for j in range(FINE) for i in range(FINE))
            # The glow ends in the picture: its last pixels fade out.
            border = min(x, y, width - 1 - x, height - 1 - y)
            fade = min(1.0, border / 8) if opacity not in (grid, pips) else 1.0
            rgba += bytes((255, 255, 255, round(255 * fade * total / FINE ** 2)))
    return png(width, height, rgba)


# ---- sounds ---------------------------------------------------------------------------------------------------


def music():
    """Four bars of bass, broken chords and hats at 120 beats a minute: A minor, F, C, G."""
    step = RATE // 8  # a sixteenth note
    track = [0.0] * (step * 64)

    def add(at, part):
        for i, sample in enumerate(part):
            track[(at * step + i) % len(track)] += sample  # what rings on is heard at the start of the loop

    for bar, (root, third) in enumerate([(110.0, 3), (87.31, 4), (130.81, 4), (98.0, 4)]):
        for sixteenth in range(16):
            at = bar * 16 + sixteenth
            if sixteenth % 4 != 0:
                add(at, tone(0.16, root, root * 0.995, 0.2, 0.35))
            else:
                add(at, tone(0.22, 140, 42, 0.5))
            steps = (0, third, 7, 12)[sixteenth * 3 % 4]
            add(at, tone(0.2, root * 4 * 2 ** (steps / 12), root * 4 * 2 ** (steps / 12), 0.055, 0.25))
            if sixteenth % 4 == 2:
                add(at, noise(0.05, 0.9, 0.07))
    return track


FILES = {
    "ship.png": lambda: white(72, 72, both(neon(circle(20)), neon(circle(7), line=7, glow=4))),
    "barrel.png": lambda: white(64, 32, neon(capsule(24, 5), line=5, glow=4)),
    "bullet.png": lambda: white(48, 32, neon(capsule(14, 4), line=4, glow=5)),
    "drone.png": lambda: white(72, 72, both(neon(polygon(4, 23)), neon(polygon(4, 7), line=7, glow=3))),
    "dart.png": lambda: white(64, 64, neon(polygon(6, (21, 8)), fill=0.4)),
    "brute.png": lambda: white(112, 112, both(neon(polygon(6, 42), line=4), neon(polygon(6, 22), line=3, glow=4))),
    "ring.png": lambda: white(128, 128, neon(circle(54), line=4, fill=0.0)),
    "spark.png": lambda: white(32, 32, spark),
    "grid.png": lambda: white(80, 80, grid),
    "pips.png": lambda: white(192, 24, pips),
    "shot.wav": lambda: wav(tone(0.1, 880, 260, 0.16, 0.5)),
    "hit.wav": lambda: wav(mix(tone(0.07, 420, 180, 0.2, 0.4), noise(0.05, 0.8, 0.25))),
    "blast.wav": lambda: wav(mix(noise(0.45, 0.5, 0.7), tone(0.3, 160, 40, 0.4))),
    "hurt.wav": lambda: wav(mix(tone(0.3, 300, 70, 0.4, 0.6), noise(0.25, 0.6, 0.4))),
    "end.wav": lambda: wav(mix(noise(1.2, 0.4, 0.9), tone(1.0, 220, 30, 0.6, 0.2), late(0.1, tone(0.8, 110, 25, 0.4)))),
    "select.wav": lambda: wav(tone(0.06, 660, 700, 0.3)),
    "confirm.wav": lambda: wav(mix(tone(0.12, 523, 523, 0.3), late(0.07, tone(0.25, 784, 784, 0.3)))),
    "music.wav": lambda: wav(music(), wide=False),
}


if __name__ == "__main__":
    sys.exit(write_or_check(FILES.items(), ASSETS))
