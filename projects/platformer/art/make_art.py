#!/usr/bin/env python3
"""Draws every picture and plays every sound of the game into ../assets. CC0, standard library only.

    make_art.py            writes the files
    make_art.py props      writes those of props.py only
    make_art.py --check    writes nothing; fails when a committed file differs from what would be written
"""

import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "assets/tools"))

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
from art_files import write_or_check  # noqa: E402

PAINTERS = [animations, backdrops, creatures, menu, music, pixel_font, player, props, sounds, tilesets, title]
ASSETS = Path(__file__).resolve().parent.parent / "assets"


def files(only):
    """Pairs of a name and a function that returns the bytes. `only`: names of painters; empty: all"""
    for painter in PAINTERS:
        if not only or painter.__name__ in only:
            for name, picture in painter.build().items():
                yield name, lambda picture=picture: picture if isinstance(picture, bytes) else picture.png()


if __name__ == "__main__":
    sys.exit(write_or_check(files([name for name in sys.argv[1:] if not name.startswith("-")]), ASSETS))
