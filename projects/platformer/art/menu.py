"""The boards that menus are written on: signboards of the wood that hang from two cords."""

from canvas import Canvas, dithered
from title import shadowed, word

WIDTH = 168


def board(height, cord):
    """Returns a board below cords of `cord` px."""
    result = Canvas(WIDTH, height + cord)
    for x in (26, WIDTH - 27):
        for y in range(cord + 3):
            result.put(x, y, "a" if y % 4 < 2 else "r")
            result.put(x + 1, y, "r")
    for y in range(height):
        for x in range(WIDTH):
            cut = {0: 3, 1: 1, 2: 1}.get(min(y, height - 1 - y), 0)  # round corners
            if not cut <= x < WIDTH - cut:
                continue
            edge = min(x - cut, WIDTH - 1 - cut - x, y, height - 1 - y)
            if edge == 0:
                value = "k"
            elif edge == 1:
                value = "S" if y < 3 else "b" if y > height - 4 else "s"
            elif edge in (2, 3):
                value = "l" if (x * 3 + y) % 23 else "B"
            elif edge == 4:
                value = "b" if y > height - 7 else "k"
            else:
                value = dithered("ppnnn", (y - 5) / (height - 10), x, y)
            result.put(x, cord + y, value)
    for x in (5, WIDTH - 8):  # nails of brass
        for y in (5, height - 8):
            result.rect(x, cord + y, 3, 3, "a")
            result.put(x, cord + y, "y")
            result.put(x + 2, cord + y + 2, "r")
    return result


def pause():
    cord = 16
    result = board(148, cord)
    heading = shadowed(word("PAUSED", "Yyygga", rounds=1), 2)
    result.paste(heading, (WIDTH - heading.width) // 2, cord + 12)
    for x in range(24, WIDTH - 24):  # a line under it, brightest in the middle
        part = abs(x - WIDTH / 2) / (WIDTH / 2 - 24)
        result.put(x, cord + 37, dithered("Sslup", part, x, 0))
    return result


def build():
    return {"board.png": board(116, 34), "pause.png": pause()}
