"""Wick, the lamplighter: a small crimson hood, two eyes and a lantern. Cells of 24x24, feet on row 22.

A frame is built from parts (hood, cloak, boots, lantern), each drawn once, so that the figure keeps its
volume while it moves; the outline is added last and makes the silhouette.
"""

import math

from canvas import Canvas, sheet

HOOD = """
............
...coo......
..wccoooo...
.wwccooooo..
.wcccoooooo.
wwccccwwwwww
wwccwBfffff.
wwccBffkffk.
wwccBffkffk.
.wwccfqfffh.
..wwccBBBB..
"""
# The tip of the hood trails behind the figure: hanging, level, lifted.
TIPS = {
    "hang": [(3, 1, "c"), (2, 1, "c"), (1, 2, "c"), (0, 3, "w"), (0, 4, "w"), (2, 2, "w")],
    "level": [(3, 1, "c"), (2, 1, "c"), (1, 1, "c"), (0, 1, "w"), (-1, 2, "w"), (2, 2, "w"), (1, 2, "w")],
    "lift": [(3, 0, "c"), (2, 0, "c"), (2, -1, "c"), (1, -1, "w"), (1, -2, "w"), (3, 1, "c")],
    "drop": [(2, 2, "c"), (1, 3, "c"), (0, 4, "w"), (0, 5, "w"), (-1, 6, "w"), (1, 4, "w")],
}
CLOAK = {
    "still": """
...wccco...
..wwcccoo..
..wwccccoo.
.wwwccccoo.
.wwcccccoo.
.ww.wcc.co.
""",
    "flow": """
...wccco...
..wwcccoo..
.wwwccccoo.
wwwcccccoo.
wwwwccccoo.
ww.wwccco..
""",
    "stream": """
...wccco...
..wwcccoo..
.wwwcccco..
wwwwcccco..
wwwwwccoo..
www.wcco...
""",
    "open": """
...wccco...
..wwcccoo..
.wwwccccoo.
wwwccccccoo
wwwbbbbbcoo
ww..bbb..oo
""",
    "squat": """
..wwcccoo..
.wwwccccoo.
wwwccccccoo
wwwccccccoo
""",
}
LANTERN = """
.rar.
.lll.
lgyYl
lyYYl
lgyYl
.lll.
"""
DARK_LANTERN = {"g": "d", "y": "t", "Y": "i"}


def boots(cell, hip, feet):
    """Two short legs from the hip to each foot, far one first and darker."""
    for (x, y), leg, boot in zip(feet, ("b", "b"), ("B", "l")):
        cell.line(hip[0] + (1 if boot == "l" else -1), hip[1], x, y - 1, leg)
        cell.rect(x - 1, y - 1, 3, 2, boot)
        cell.put(x + 1, y, "s" if boot == "l" else "l")


def figure(head=(0, 0), tip="hang", cloak="still", feet=((10, 22), (14, 22)), body=0, lantern=(17, 13),
           eyes="open", lit=True):
    """One frame; offsets are in pixels from the standing pose."""
    cell = Canvas(24, 24)
    boots(cell, (12, 19 + body), feet)
    art = CLOAK[cloak]
    top = 14 + body + (2 if cloak == "squat" else 0)
    cell.stamp(art, 6, top)
    hx, hy = 6 + head[0], 4 + body + head[1]
    cell.stamp(HOOD, hx, hy)
    for x, y, letter in TIPS[tip]:
        cell.put(hx + x, hy + y, letter)
    if eyes == "closed":
        cell.rect(hx + 7, hy + 7, 1, 1, "f"), cell.rect(hx + 10, hy + 7, 1, 1, "f")
    if eyes == "wide":
        cell.put(hx + 7, hy + 6, "k"), cell.put(hx + 10, hy + 6, "k")
    if eyes == "hurt":
        for x in (7, 10):
            cell.put(hx + x, hy + 7, "f"), cell.put(hx + x, hy + 8, "k")
            cell.put(hx + x - 1, hy + 7, "k")
    if lantern:
        lx, ly = lantern
        cell.put(lx - 1, ly + 1, "f"), cell.put(lx, ly, "f"), cell.put(lx - 2, ly + 1, "o")
        cell.stamp(LANTERN, lx, ly, swap=None if lit else DARK_LANTERN)
    cell.outline("k")
    return cell


def idle():
    return [figure(), figure(head=(0, 0), lantern=(17, 14)), figure(head=(0, 1), lantern=(17, 14)),
            figure(head=(0, 1), lantern=(17, 13), eyes="closed")]


def run():
    frames = []
    for k in range(8):
        phase = 2 * math.pi * k / 8
        feet = []
        for offset in (math.pi, 0.0):
            swing, lift = math.cos(phase + offset), max(0.0, -math.sin(phase + offset))
            feet.append((round(12 + 4 * swing), round(22 - 3 * lift)))
        up = -1 if k in (1, 2, 5, 6) else 0
        frames.append(figure(head=(1, 0), tip="level" if k % 4 < 2 else "hang",
                             cloak="stream" if k % 4 < 2 else "flow", feet=feet, body=up,
                             lantern=(18, 13 - (k in (2, 3, 6, 7)))))
    return frames


def air():
    """Jump (2), apex, fall (2), land (2)."""
    return [
        figure(head=(0, -1), tip="drop", cloak="still", feet=((10, 22), (13, 21)), body=-1, lantern=(17, 14)),
        figure(head=(0, -1), tip="drop", cloak="flow", feet=((9, 21), (14, 20)), body=-1, lantern=(17, 14)),
        figure(tip="level", cloak="flow", feet=((9, 20), (14, 20)), body=-1, lantern=(18, 12)),
        figure(tip="lift", cloak="open", feet=((9, 20), (15, 20)), body=-1, lantern=(18, 9), eyes="wide"),
        figure(tip="lift", cloak="open", feet=((9, 21), (15, 21)), body=-1, lantern=(18, 8), eyes="wide"),
        figure(head=(0, 3), tip="lift", cloak="squat", feet=((8, 22), (16, 22)), body=1, lantern=(18, 16),
               eyes="closed"),
        figure(head=(0, 1), tip="level", cloak="still", feet=((9, 22), (15, 22)), body=1, lantern=(18, 15)),
    ]


def flame(height, width, wave):
    """The spark that Wick turns into and comes back from."""
    cell = Canvas(24, 24)
    for y in range(height):
        part = y / max(height - 1, 1)
        half = width * math.sin(math.pi * (0.18 + 0.8 * part ** 0.75)) ** 0.9 * (1 - part * 0.35)
        shift = math.sin(part * 4 + wave) * 1.5 * part
        for x in range(24):
            far = abs(x - 12 - shift)
            if far <= half:
                heat = far / max(half, 0.1) + part * 0.5
                cell.put(x, 21 - y, "Y" if heat < 0.4 else "y" if heat < 0.75 else "g" if heat < 1.05 else "a")
    cell.outline("r")
    return cell


def hurt():
    """Hurt (2), going out (3), coming back (4)."""
    hit = figure(head=(-1, 0), tip="lift", cloak="open", feet=((8, 21), (16, 20)), lantern=(18, 9), eyes="hurt",
                 lit=False)
    white = Canvas(24, 24)
    white.pixels = [0xFFF5B8FF if p & 0xFF else 0 for p in hit.pixels]
    out = [flame(14, 6, 0.0), flame(9, 4, 1.5), flame(4, 2, 3.0)]
    back = [flame(6, 3, 0.5), flame(12, 5, 2.0), flame(18, 7, 3.5)]
    return [hit, white] + out + back


def build():
    """Rows: idle 4 | run 8 | jump 2, apex, fall 2, land 2 | hurt 2, out 3, back 3."""
    cells = [Canvas(24, 24) for _ in range(32)]
    for row, frames in enumerate((idle(), run(), air(), hurt())):
        cells[row * 8:row * 8 + len(frames)] = frames
    return {"player.png": sheet(cells, 8)}
