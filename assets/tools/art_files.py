"""What the scripts art/make_art.py of the projects share: files of pictures and sounds. Standard library only.

The same bytes come out on every machine: nothing here asks the clock, the system or a random generator.
"""

import io
import math
import struct
import sys
import wave
import zlib

RATE = 22050  # samples a second


def png(width, height, rgba):
    """The bytes of a .png file. `rgba`: four bytes for each pixel, row by row."""
    row = width * 4
    packed = zlib.compress(b"".join(b"\0" + bytes(rgba[y * row:(y + 1) * row]) for y in range(height)), 9)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")


def wav(samples, wide=True):
    """Samples in -1..1 as the bytes of a .wav file, mono, 16 bits wide or 8."""
    out = io.BytesIO()
    with wave.open(out, "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2 if wide else 1)
        file.setframerate(RATE)
        clipped = (min(max(s, -1.0), 1.0) for s in samples)
        if wide:
            file.writeframes(b"".join(round(s * 32000).to_bytes(2, "little", signed=True) for s in clipped))
        else:
            file.writeframes(bytes(round(s * 126) + 128 for s in clipped))
    return out.getvalue()


def tone(seconds, start, end, loudness, hardness=0.0):
    """A sine that glides from one pitch to another (Hz) and fades; `hardness` 0..1 turns it into a square."""
    count, phase, samples = int(seconds * RATE), 0.0, []
    for i in range(count):
        t = i / count
        phase += (start * (end / start) ** t) / RATE
        sine = math.sin(2 * math.pi * phase)
        square = 1.0 if sine >= 0 else -1.0
        attack = min(1.0, i / 60)
        samples.append(loudness * attack * (sine + (square - sine) * hardness) * (1 - t) ** 2)
    return samples


def noise(seconds, bright, loudness):
    """Noise from a shift register that gets duller and fades. `bright`: 0..1, at its start."""
    register, low, samples, count = 0x7FFF, 0.0, [], int(seconds * RATE)
    for i in range(count):
        register = register >> 1 | ((register ^ register >> 1) & 1) << 14
        t = i / count
        low += (bright * (1 - t) ** 3 + 0.01) * ((1.0 if register & 1 else -1.0) - low)
        samples.append(loudness * low * (1 - t) ** 2)
    return samples


def mix(*parts):
    return [sum(part[i] for part in parts if i < len(part)) for i in range(max(map(len, parts)))]


def late(seconds, part):
    return [0.0] * int(seconds * RATE) + part


def content(data, name):
    """Of a picture the pixels, since another make of zlib may pack them otherwise."""
    if not name.endswith(".png"):
        return data
    return data[:33] + zlib.decompressobj().decompress(data[data.index(b"IDAT") + 4:])


def write_or_check(files, folder):
    """Writes files, or with --check only compares them with those that are there. Returns the exit code.

    files: pairs of a name and a function that returns the bytes
    """
    different = []
    for name, make in files:
        data, path = make(), folder / name
        if "--check" not in sys.argv:
            path.write_bytes(data)
        elif not path.exists() or content(path.read_bytes(), name) != content(data, name):
            different.append(name)
    print("\n".join(f"{name} differs: run make_art.py" for name in different) or "assets are up to date")
    return 1 if different else 0
