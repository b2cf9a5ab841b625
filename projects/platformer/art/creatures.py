"""Those who walk their beat: a grumpy mushroom and an owlet. Cells of 16x16, looking to the right."""

import math

from canvas import Canvas, sheet

CAP = """
.....mqqqm......
...mqqhhqqmm....
..mqhhhqqqehm...
.mqhhqqqqqeemu..
.mqqqqehqqqqmu..
mqqqqqeeqqqqmuu.
mmqqqqqqqqqmmuu.
.uuuuuuuuuuuup..
"""
FACE = """
...SffffffffS...
...SfkkffkkfS...
...Sffkffkffs...
...SffffffffS...
....SffkkffS....
"""


def gloomcap():
    """Walk (4), flattened, gone flat."""
    cells = []
    for k in range(4):
        cell = Canvas(16, 16)
        up = 1 if k % 2 else 0
        left, right = ((4, 15), (9, 15)) if k == 0 else ((5, 15), (9, 14)) if k == 1 else ((5, 15), (8, 15))
        left, right = (left, right) if k < 3 else ((4, 14), (9, 15))
        for x, y in (left, right):
            cell.rect(x, y - 1, 3, 2, "l"), cell.put(x + 2, y, "s")
        cell.stamp(FACE, 1, 8 - up)
        cell.stamp(CAP, 0, 2 - up)
        cell.outline("k")
        cells.append(cell)
    for height in (5, 3):
        cell = Canvas(16, 16)
        cell.rect(2, 16 - height, 12, height - 1, "q"), cell.rect(3, 16 - height, 5, 1, "h")
        cell.rect(10, 16 - height, 2, 1, "e"), cell.rect(3, 15, 10, 1, "f"), cell.rect(1, 14, 14, 1, "u")
        cell.outline("k")
        cells.append(cell)
    return sheet(cells)


BODY = """
..d......d..
..td....dt..
..ttddddtt..
.tteettee...
.teeeteeed..
.tekeeekeed.
.teeeaeeetd.
.tteeaeettd.
..tiiiiittd.
..tizizittd.
...tiiittd..
....tttdd...
"""


def owlet():
    """Flap (4), struck."""
    cells = []
    for k in range(5):
        cell = Canvas(24, 16)
        lift = (-5, -1, 4, 0, 3)[k]
        for side in (-1, 1):
            for i in range(8):
                x = 12 + side * (4 + i) - (side > 0)
                y = 8 + round(lift * math.sin(i / 7 * 1.5)) - (k == 1 and i > 4)
                depth = 5 - i // 2
                for j in range(depth):
                    cell.put(x, y + j, "i" if j == 0 else "t" if j < depth - 1 else "d")
        body = BODY.replace("k", "h") if k == 4 else BODY
        cell.stamp(body, 6, 2 + (1 if lift < 0 else 0 if k != 2 else -1))
        cell.put(10, 14, "a"), cell.put(13, 14, "a")
        cell.outline("k")
        cells.append(cell)
    return sheet(cells)


def build():
    return {"gloomcap.png": gloomcap(), "owlet.png": owlet()}
