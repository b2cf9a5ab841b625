#!/usr/bin/env python3
"""Records arena.replay again, after a change of the game or of the simulation.

    record_arena.py PLAYER      PLAYER: build/release/bin/arena-player

The input is scripted: the ship circles in the arena and fires in all directions, by keys and by the mouse, then rests
until the game is over, and begins again. Enter, which only menus react to, is pressed now and then, so that the replay
goes on after an early end.
"""

import math
import random
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
REPLAY = HERE / "arena.replay"
PLAY = 45 * 60  # ticks of play
REST = 25 * 60  # ticks without input
WAYS = [("D",), ("D", "S"), ("S",), ("S", "A"), ("A",), ("A", "W"), ("W",), ("W", "D")]  # clockwise, from the right
AIMS = [("Right",), ("Right", "Down"), ("Down",), ("Down", "Left"), ("Left",), ("Left", "Up"), ("Up",), ("Up", "Right")]


def frames():
    """One pair for each tick: the names of what is held, and the position of the mouse, px."""
    choose = random.Random(1)
    mouse = (0, 0)
    yield from [(set(), mouse)] * 60
    yield from [({"Enter"}, mouse)] * 3
    yield from [(set(), mouse)] * 57
    way = aim = 0
    for tick in range(PLAY):
        if tick % 24 == 0:
            way = (way + choose.choice((1, 1, 1, 2))) % 8
        if tick % 9 == 0:
            aim = (aim + choose.choice((1, 1, 3))) % 8
        held = set(WAYS[way])
        if tick // 600 % 2 == 0:
            held |= set(AIMS[aim])
        else:
            angle = tick // 8 * 0.7
            mouse = (round(640 + 300 * math.cos(angle)), round(380 + 300 * math.sin(angle)))
            held.add("Mouse.Left")
        if tick % 300 >= 297:
            held.add("Enter")
        yield held, mouse
    yield from [(set(), mouse)] * REST
    yield from [({"Enter"}, mouse)] * 3
    yield from [(set(), mouse)] * 120


def replay():
    """The text of a replay without checks; engine/input/replay_file.cpp describes it."""
    lines = ["plumb-replay 1", "project Arena", "engine 0.1.0", "scene ", "seed 0000000000000001"]
    held, mouse, count, total = set(), (0, 0), 0, 0
    changes = ""
    for now, place in frames():
        if now != held or place != mouse:
            if count:
                lines.append(f"{count}{changes}")
            changes = "".join(f" +{name}" for name in sorted(now - held))
            changes += "".join(f" -{name}" for name in sorted(held - now))
            changes += f" mouse={place[0]},{place[1]}" if place != mouse else ""
            held, mouse, count = now, place, 0
        count += 1
        total += 1
    return "\n".join(lines + [f"{count}{changes}", f"end {total}"]) + "\n"


def main():
    REPLAY.write_text(replay())
    project = HERE.parent.parent / "projects/arena"
    command = [sys.argv[1], project, "--headless", "--replay", REPLAY, "--record", REPLAY]
    return subprocess.run(command, check=False).returncode  # adds the checks


if __name__ == "__main__":
    sys.exit(main())
