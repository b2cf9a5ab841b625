#!/usr/bin/env python3
"""Draws every picture and makes every sound of the playground into ../assets. CC0, standard library only.

    make_art.py            writes the files
    make_art.py --check    writes nothing; fails when a committed file differs from what would be written

Pictures are white with a darker rim: each sprite's tint gives them their color.
"""

import math
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "assets/tools"))

from art_files import RATE, noise, png, wav, write_or_check  # noqa: E402

ASSETS = Path(__file__).resolve().parent.parent / "assets"
RIM = 0.78  # brightness of the rim
FINE = 4    # samples a side for each pixel


def shaded(width, height, shade):
    """`shade(x, y)` gives the brightness there in 0..1, or None outside of the shape."""
    rgba = bytearray()
    for y in range(height):
        for x in range(width):
            samples = [shade(x + (i + 0.5) / FINE, y + (j + 0.5) / FINE) for j in range(FINE) for i in range(FINE)]
            inside = [s for s in samples if s is not None]
            light = round(255 * sum(inside) / len(inside)) if inside else 255
            rgba += bytes((light, light, light, round(255 * len(inside) / len(samples))))
    return png(width, height, rgba)


def rounded(depth, rim):
    """Shade by how deep inside a point is (px)."""
    return None if depth < 0 else RIM if depth < rim else 1.0


def disc(x, y):
    depth = 64 - math.hypot(x - 64, y - 64)
    spoke = abs(y - 64) < 2.5 and x > 64  # shows how it turns
    return RIM if depth > 0 and spoke else rounded(depth, 7)


def plain_disc(x, y):
    return rounded(64 - math.hypot(x - 64, y - 64), 7)


def dot(x, y):
    return 1.0 if math.hypot(x - 64, y - 64) < 64 else None


def rail(x, y):
    return rounded(12 - math.hypot(x - 12, y - min(max(y, 12), 180)), 2)


def box(x, y):
    return rounded(min(x, y, 64 - x, 64 - y), 4)


def ring(x, y):
    return 1.0 if 22 < math.hypot(x - 32, y - 32) < 32 else None


def capsule(x, y):
    return rounded(24 - math.hypot(x - 24, y - min(max(y, 24), 120)), 4)


def tone(seconds, start, end, loudness):
    """A sine that glides from one pitch to another (Hz) and fades."""
    count, phase, samples = int(seconds * RATE), 0.0, []
    for i in range(count):
        t = i / count
        phase += (start + (end - start) * t) / RATE
        samples.append(loudness * math.sin(2 * math.pi * phase) * (1 - t) ** 2)
    return samples


FILES = {
    "disc.png": lambda: shaded(128, 128, disc),
    "ball.png": lambda: shaded(128, 128, plain_disc),
    "dot.png": lambda: shaded(128, 128, dot),
    "rail.png": lambda: shaded(24, 192, rail),
    "box.png": lambda: shaded(64, 64, box),
    "ring.png": lambda: shaded(64, 64, ring),
    "capsule.png": lambda: shaded(48, 144, capsule),
    "jump.wav": lambda: wav(tone(0.18, 280, 560, 0.4)),
    "step.wav": lambda: wav(tone(0.06, 520, 500, 0.35)),
    "choose.wav": lambda: wav(tone(0.16, 520, 780, 0.4)),
    "blast.wav": lambda: wav(noise(0.9, 0.35, 1.4)),
}


if __name__ == "__main__":
    sys.exit(write_or_check(FILES.items(), ASSETS))
