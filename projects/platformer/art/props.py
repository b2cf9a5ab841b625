"""Things that lie about and move: plumb-bobs, springs, lamps, the gate, platforms, sparks and icons."""

import math

from canvas import Canvas, sheet
from palette import color


def bob(turn, cell=None, x=8, y=1):
    """A brass plumb-bob seen at a turn of 0..1: knob, collar, body, steel point."""
    cell = cell or Canvas(16, 16)
    width = abs(math.cos(math.pi * turn))
    profile = [1, 1, 2, 4, 5, 5, 5, 4, 4, 3, 2, 2, 1, 1]
    for row, half in enumerate(profile):
        half = max(half * width, 0.5 if half < 3 else 1.0)
        for i in range(-6, 7):
            center = i + 0.5
            if abs(center) > half:
                continue
            side = center / half
            tone = "Y" if -0.6 < side < -0.15 else "y" if side < 0.15 else "g" if side < 0.6 else "a"
            if row in (2, 3):
                tone = {"Y": "y", "y": "g", "g": "a", "a": "r"}[tone]
            if row > 10:
                tone = {"Y": "e", "y": "z", "g": "i", "a": "t"}[tone]
            if row == 0:
                tone = "r"
            cell.put(x + i, y + row, tone)
    cell.outline("k")
    return cell


def bobs():
    return sheet([bob(k / 8) for k in range(8)])


def spring():
    """Rest, pressed, stretched, settling."""
    cells = []
    for top in (8, 11, 1, 5):
        cell = Canvas(16, 16)
        cell.stamp("\n".join(["lssssssssssl", "BllllllllllB"]), 2, 14)
        coils = max((14 - top - 3) // 2, 1)
        for k in range(coils):
            y = top + 3 + round(k * (11 - top) / coils)
            cell.line(4, y + 1, 11, y, "i")
            cell.put(4, y + 1, "z"), cell.put(11, y, "t")
        cell.stamp("\n".join([".oooooooooo.", "ohhooooooocc", ".cccccccccw."]), 2, top)
        cell.outline("k")
        cells.append(cell)
    return sheet(cells)


POST = """
.....kk.....
....kaak....
...karrak...
..krrrrrrk..
.kllllllllk.
..kd....dk..
..kd....dk..
..kd....dk..
..kd....dk..
..kd....dk..
..kaaaaaak..
...krrrrk...
....kllk....
....kslk....
....kslk....
....kslk....
....kslk....
....kllk....
....kslk....
....kslk....
....kslk....
....kslk....
....kllk....
....kslk....
....kslk....
....kslk....
...kssllk...
..kssllBlk..
.ksssllBBlk.
.kkkkkkkkkk.
"""


def lamp():
    """A lamp post of 16x32: dark, being lit (2), burning (4)."""
    cells = []
    for k in range(7):
        cell = Canvas(16, 32)
        cell.stamp(POST, 2, 2)
        glass = {"0": "A", "1": "a", "2": "g"}.get(str(k), "y")
        cell.rect(6, 7, 4, 5, glass)
        if k == 0:
            cell.put(6, 8, "t"), cell.put(7, 7, "t"), cell.rect(7, 10, 2, 2, "n")
        elif k <= 2:
            cell.rect(7, 9, 2, 3, "y" if k == 1 else "Y")
        else:
            height, lean = (3, 4, 4, 3)[k - 3], (0, 0, 1, 1)[k - 3]
            cell.rect(7, 12 - height, 2, height, "Y")
            cell.put(7 + lean, 11 - height, "Y")
        cells.append(cell)
    return sheet(cells)


def gate():
    """The way on, 32x48: an arch of stone with a plumb-bob hanging in its light. 6 frames."""
    cells = []
    for k in range(6):
        cell = Canvas(32, 48)
        for y in range(48):
            for x in range(32):
                across, top = abs(x - 15.5), y - 17
                far = math.hypot(across, min(top, 0))
                if far <= 10.5:
                    wave = math.sin((x * 0.35 + y * 0.5) - k * math.pi / 3) + math.sin(y * 0.3 + k * math.pi / 3)
                    heat = far / 10.5 + wave * 0.14 + max(0, y - 34) * 0.02
                    cell.put(x, y, "Y" if heat < 0.3 else "y" if heat < 0.55 else "g" if heat < 0.8 else "a"
                             if heat < 1.0 else "r")
                elif far <= 15.5:
                    angle = math.atan2(min(top, 0), x - 15.5)
                    seam = (y % 7 == 6 if top > 0 else int((angle + math.pi) * 8 / math.pi + 0.5) % 2 == 0
                            and far > 14.2) or far > 15
                    lit = far < 12
                    cell.put(x, y, "d" if seam else "f" if lit and x > 15 else "i" if lit or x < 4 else "t")
        cell.rect(15, 7, 1, 12, "r")
        swing = round(math.sin(k * math.pi / 3))
        bob(0.0, cell, 15 + swing, 19)
        cell.stamp("\n".join(["kkkkkkkk", "kyggggak", "kggaaark", ".kkkkkk."]), 12, 0)
        cell.rect(0, 45, 32, 3, "d"), cell.rect(1, 45, 30, 1, "i"), cell.rect(0, 47, 32, 1, "A")
        cell.outline("k")
        cells.append(cell)
    return sheet(cells)


def platform():
    """A log slung on brass, 48x12, drawn for riding; and a short one of 32x12."""
    def log(width):
        cell = Canvas(width, 12)
        for x in range(1, width - 1):
            for y, letter in enumerate("Ssslll lB"):
                if letter != " ":
                    cell.put(x, y + 1, letter)
            if (x * 7) % 11 < 4:
                cell.put(x, 3, "l")
            if (x * 5) % 13 < 3:
                cell.put(x, 6, "B")
            cell.put(x, 7, "B")
        for x in (4, width - 7):
            cell.rect(x, 1, 3, 8, "a"), cell.rect(x, 1, 3, 1, "y"), cell.rect(x + 2, 2, 1, 7, "r")
        middle = width // 2
        cell.stamp("\n".join([".aa.", "gYYa", ".aa."]), middle - 2, 8)
        cell.outline("k")
        return cell
    return log(48), log(32)


def dust():
    """A puff of 8x8 in 4 frames, and a spark in 4."""
    puff = ["........\n..ee....\n.eeee...\n.eeeeh..\n.heeeh..\n..hhh...\n........\n........",
            "..ee....\n.eeee.e.\n.eeeh...\n..hhh...\n.....he.\n..e.....\n........\n........",
            "..e.....\n.ee..e..\n..h.....\n......h.\n.h......\n........\n........\n........",
            "..h.....\n........\n.....h..\n........\n........\n........\n........\n........"]
    spark = ["........\n...Y....\n...Y....\n.YYYYY..\n...Y....\n...Y....\n........\n........",
             "...y....\n...y....\n...Y....\nyyYYYyy.\n...Y....\n...y....\n...y....\n........",
             "...g....\n.g...g..\n........\ng..Y..g.\n........\n.g...g..\n...g....\n........",
             "...a....\n........\n........\na.....a.\n........\n........\n...a....\n........"]
    cells = []
    for art in puff + spark:
        cell = Canvas(8, 8)
        cell.stamp(art)
        cells.append(cell)
    return sheet(cells, 4)


ICONS = {
    "bob": "....rr....\n...kyak...\n..kyygak..\n.kYyyggak.\n.kYyyggak.\n.kYyyggak.\n..kyygak..\n...kzik...\n....kk....",
    "skull": "..kkkkkk..\n.keeeeehk.\nkeeeeeehhk\nkekkeekkhk\nkekkeekkhk\nkeeeeeehhk\n.kehkehhk.\n.kehkehhk.\n..kkkkkk..",
    "clock": "..kkkkkk..\n.kggggaak.\nkgeekeeeak\nkgeekeeeak\nkgeekkkeak\nkaeeeeeeak\nkaeeeeeerk\n.kaaaaarrk\n..kkkkkk..",
}


def icons():
    cells = []
    for art in ICONS.values():
        cell = Canvas(12, 12)
        cell.stamp(art, 1, 1)
        cells.append(cell)
    return sheet(cells)


def light(radius, letter, strength):
    """A soft round light, for laying over the picture: without steps, which would be seen as rings."""
    size = radius * 2
    cell = Canvas(size, size)
    for y in range(size):
        for x in range(size):
            far = math.hypot(x + 0.5 - radius, y + 0.5 - radius) / radius
            near = max(0.0, 1 - far)
            alpha = round(5 * strength * near * near * (3 - 2 * near))
            if alpha > 0:
                cell.put(x, y, color(letter, alpha))
    return cell


def dusk():
    """Ten cells of 8x8 from dark to clear: laid over the picture, they let a level come out of the dark."""
    return sheet([Canvas(8, 8, color("k", round(255 * (1 - k / 10) ** 1.4))) for k in range(10)])


def tree():
    """A broad old tree, 80x96, to stand behind the path."""
    cell = Canvas(80, 96)
    for y in range(40, 96):
        half = 5 + max(0, y - 82) ** 2 // 16 + (2 if y < 50 else 0)
        for x in range(40 - half, 40 + half):
            part = (x - 40) / half
            cell.put(x, y, "l" if part < -0.5 else "B" if part < 0.35 else "b")
            if (x * 5 + y // 5 * 3) % 9 == 0:
                cell.put(x, y, "b")
    cell.line(40, 60, 20, 44, "B"), cell.line(40, 61, 20, 45, "b"), cell.line(41, 56, 62, 42, "B")
    cell.line(41, 57, 62, 43, "b")
    crowns = [(24, 36, 20), (57, 37, 20), (40, 22, 22), (14, 44, 11), (67, 46, 11), (40, 42, 16)]
    for dx, dy, letter in ((0, 3, "n"), (0, 0, "1"), (-2, -3, "2"), (-4, -6, "3")):
        for k, (cx, cy, radius) in enumerate(crowns):
            shrink = {"n": 0, "1": 1, "2": 6, "3": 12}[letter]
            for y in range(cy - radius - 2, cy + radius + 4):
                for x in range(cx - radius - 2, cx + radius + 3):
                    ragged = 2.2 * math.sin(x * 1.3 + k) * math.cos(y * 1.1 - k)
                    if math.hypot(x - cx - dx, (y - cy - dy) * 1.15) < radius - shrink + ragged:
                        cell.put(x, y, letter)
    return cell


def build():
    long_log, short_log = platform()
    return {"bob.png": bobs(), "spring.png": spring(), "lamp.png": lamp(), "gate.png": gate(),
            "platform.png": long_log, "platform_short.png": short_log, "dust.png": dust(), "icons.png": icons(),
            "light.png": light(32, "y", 9), "light_big.png": light(56, "f", 7), "dusk.png": dusk(), "tree.png": tree(), "tree_snow.png": tree().swap({"n": "A", "1": "d", "2": "i", "3": "e"})}
