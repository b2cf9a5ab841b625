#!/usr/bin/env python3
"""Draws every picture and plays every sound of the game into ../assets. CC0, standard library only.

    make_art.py            writes the files
    make_art.py --check    writes nothing; fails when a committed file differs from what would be written

The same bytes come out on every machine: nothing here asks the clock, the system or a random generator.
"""

import sys
import tempfile
import zlib
from pathlib import Path

sys.dont_write_bytecode = True

import animations  # noqa: E402
import backdrops  # noqa: E402
import creatures  # noqa: E402
import menu  # noqa: E402
import music  # noqa: E402
import pixel_font  # noqa: E402
import player  # noqa: E402
import props  # noqa: E402
import sounds  # noqa: E402
import tilesets  # noqa: E402
import title  # noqa: E402

PAINTERS = [animations, backdrops, creatures, menu, music, pixel_font, player, props, sounds, tilesets, title]
ASSETS = Path(__file__).resolve().parent.parent / "assets"


def write_all(folder, only=()):
    folder.mkdir(parents=True, exist_ok=True)
    for painter in PAINTERS:
        if only and painter.__name__ not in only:
            continue
        for name, picture in painter.build().items():
            if isinstance(picture, bytes):
                (folder / name).write_bytes(picture)
            else:
                picture.save(folder / name)


def content(path):
    """A file's bytes; of a picture the pixels too, since another make of zlib may pack them otherwise."""
    data = path.read_bytes()
    if path.suffix != ".png":
        return data
    packed = data[data.index(b"IDAT") + 4:]
    return data[:33] + zlib.decompressobj().decompress(packed)


def check():
    """The names of committed files that this script would write differently."""
    with tempfile.TemporaryDirectory() as scratch:
        write_all(Path(scratch))
        return [made.name for made in sorted(Path(scratch).iterdir())
                if not (ASSETS / made.name).exists() or content(ASSETS / made.name) != content(made)]


if __name__ == "__main__":
    if "--check" in sys.argv:
        different = check()
        print("\n".join(f"{name} differs: run make_art.py" for name in different) or "assets are up to date")
        sys.exit(1 if different else 0)
    write_all(ASSETS, [name for name in sys.argv[1:] if not name.startswith("-")])
