#!/usr/bin/env python3
"""Draws every picture and makes every sound of the playground into ../assets. CC0, standard library only.

    make_art.py            writes the files
    make_art.py --check    writes nothing; fails when a committed file differs from what would be written

Pictures are white with a darker rim: each sprite's tint gives them their color.
"""

import io
import math
import struct
import sys
import wave
import zlib
from pathlib import Path

ASSETS = Path(__file__).resolve().parent.parent / "assets"
RIM = 0.78  # brightness of the rim
FINE = 4    # samples a side for each pixel
RATE = 22050


def png(width, height, shade):
    """`shade(x, y)` gives the brightness there in 0..1, or None outside of the shape."""
    rows = bytearray()
    for y in range(height):
        rows.append(0)
        for x in range(width):
            samples = [shade(x + (i + 0.5) / FINE, y + (j + 0.5) / FINE) for j in range(FINE) for i in range(FINE)]
            inside = [s for s in samples if s is not None]
            light = round(255 * sum(inside) / len(inside)) if inside else 255
            rows += bytes((light, light, light, round(255 * len(inside) / len(samples))))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(bytes(rows), 9)) +
            chunk(b"IEND", b""))


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


def wav(samples):
    out = io.BytesIO()
    with wave.open(out, "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(RATE)
        clipped = (min(max(s, -1.0), 1.0) for s in samples)
        file.writeframes(b"".join(int(round(s * 32000)).to_bytes(2, "little", signed=True) for s in clipped))
    return out.getvalue()


def tone(seconds, start, end, loudness):
    """A sine that glides from one pitch to another (Hz) and fades."""
    count, phase, samples = int(seconds * RATE), 0.0, []
    for i in range(count):
        t = i / count
        phase += (start + (end - start) * t) / RATE
        samples.append(loudness * math.sin(2 * math.pi * phase) * (1 - t) ** 2)
    return samples


def blast():
    """Noise from a shift register that gets duller and fades."""
    register, low, samples, count = 0x7FFF, 0.0, [], int(0.9 * RATE)
    for i in range(count):
        register = register >> 1 | ((register ^ register >> 1) & 1) << 14
        t = i / count
        low += (0.35 * (1 - t) ** 3 + 0.01) * ((1.0 if register & 1 else -1.0) - low)
        samples.append(1.4 * low * (1 - t) ** 2)
    return samples


FILES = {
    "disc.png": lambda: png(128, 128, disc),
    "ball.png": lambda: png(128, 128, plain_disc),
    "dot.png": lambda: png(128, 128, dot),
    "rail.png": lambda: png(24, 192, rail),
    "box.png": lambda: png(64, 64, box),
    "ring.png": lambda: png(64, 64, ring),
    "capsule.png": lambda: png(48, 144, capsule),
    "jump.wav": lambda: wav(tone(0.18, 280, 560, 0.4)),
    "step.wav": lambda: wav(tone(0.06, 520, 500, 0.35)),
    "choose.wav": lambda: wav(tone(0.16, 520, 780, 0.4)),
    "blast.wav": lambda: wav(blast()),
}


def content(data, name):
    """Of a picture the pixels, since another make of zlib may pack them otherwise."""
    if not name.endswith(".png"):
        return data
    return data[:33] + zlib.decompressobj().decompress(data[data.index(b"IDAT") + 4:])


def main():
    different = []
    for name, make in FILES.items():
        data, path = make(), ASSETS / name
        if "--check" not in sys.argv:
            path.write_bytes(data)
        elif not path.exists() or content(path.read_bytes(), name) != content(data, name):
            different.append(name)
    print("\n".join(f"{name} differs: run make_art.py" for name in different) or "assets are up to date")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
