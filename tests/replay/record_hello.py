#!/usr/bin/env python3
"""Records projects/hello-code/hello.replay again, after a change of the game or of the simulation.

    record_hello.py PROGRAM     PROGRAM: build/release/bin/hello-code

The input is scripted: the ship flies to and fro and fires. Space is let go now and then, so that a new game begins
after an early end; at last nobody flies, until the game is over.
"""

import random
import subprocess
import sys
from pathlib import Path

REPLAY = Path(__file__).resolve().parents[2] / "projects/hello-code/hello.replay"
PLAY = 40 * 60  # ticks of play
REST = 30 * 60  # ticks without input


def frames():
    """For each tick the names of the keys that are held."""
    choose = random.Random(4)
    yield from [set()] * 60
    yield from [{"Space"}] * 3
    way, left = "Left", 0
    for tick in range(PLAY):
        if left == 0:
            way, left = ("Right" if way == "Left" else "Left"), choose.randrange(20, 80)
        left -= 1
        held = {way}
        if tick % 200 < 40:
            held.add("Up" if tick // 200 % 2 else "Down")
        if tick % 120 >= 4:
            held.add("Space")
        yield held
    yield from [set()] * REST


def replay():
    """The text of a replay without checks; engine/input/replay_file.cpp describes it."""
    lines = ["plumb-replay 1", "project Meteor Night", "engine 0.1.0", "scene ", "seed 0000000000000001"]
    held, count, total, changes = set(), 0, 0, ""
    for now in frames():
        if now != held:
            if count:
                lines.append(f"{count}{changes}")
            changes = "".join(f" +{name}" for name in sorted(now - held))
            changes += "".join(f" -{name}" for name in sorted(held - now))
            held, count = now, 0
        count += 1
        total += 1
    return "\n".join(lines + [f"{count}{changes}", f"end {total}"]) + "\n"


def main():
    REPLAY.write_text(replay())
    command = [Path(sys.argv[1]).resolve(), "--headless", "--replay", REPLAY, "--record", REPLAY]
    return subprocess.run(command, check=False).returncode  # adds the checks


if __name__ == "__main__":
    sys.exit(main())
