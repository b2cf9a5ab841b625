"""The game's name, and the picture of the last screen."""

import math

from canvas import Canvas
from pixel_font import glyph_rows
from props import bob


def doubled(grid):
    """Scale2x: twice the size with rounded corners, from a grid of booleans."""
    height, width = len(grid), len(grid[0])

    def at(x, y):
        return 0 <= x < width and 0 <= y < height and grid[y][x]

    result = [[False] * (2 * width) for _ in range(2 * height)]
    for y in range(height):
        for x in range(width):
            here, up, down, left, right = at(x, y), at(x, y - 1), at(x, y + 1), at(x - 1, y), at(x + 1, y)
            corners = [here] * 4
            if left != right and up != down:
                corners = [left if left == up else here, right if up == right else here,
                           left if left == down else here, right if down == right else here]
            for k, value in enumerate(corners):
                result[2 * y + k // 2][2 * x + k % 2] = value
    return result


def word(text, ramp, rounds=2, gap=1):
    """A word in big rounded letters, lit from above."""
    letters = [[[c == "#" for c in row] for row in glyph_rows(letter)[:7]] for letter in text]
    rows_ = [[] for _ in range(9)]
    for grid in letters:
        for y in range(9):
            rows_[y] += [False] * gap + (grid[y - 1] if 1 <= y <= 7 else [False] * len(grid[0]))
    grid = [row + [False] * gap for row in rows_]
    for _ in range(rounds):
        grid = doubled(grid)
    canvas = Canvas(len(grid[0]), len(grid))
    scale = 2 ** rounds
    for y, row in enumerate(grid):
        for x, inside in enumerate(row):
            if inside:
                part = (y - scale) / (7 * scale)
                above = not grid[y - 1][x]
                below = not grid[y + 1][x]
                canvas.put(x, y, "Y" if above else ramp[-1] if below else ramp[min(int(part * (len(ramp) - 1)),
                                                                                 len(ramp) - 2)])
    return canvas


def shadowed(canvas, depth):
    """An outline, and a dark edge that goes down from it."""
    result = Canvas(canvas.width, canvas.height + depth + 2)
    for d in range(depth, 0, -1):
        shade = Canvas(canvas.width, canvas.height)
        shade.pixels = [0x6B1F3FFF if p & 0xFF else 0 for p in canvas.pixels]
        result.paste(shade, 0, d)
    result.paste(canvas, 0, 0)
    result.outline("k", corners=True)
    return result


def logo():
    art = shadowed(word("WICKWOOD", "Yyygga"), 3)
    result = Canvas(art.width, art.height + 20)
    result.paste(art, 0, 0)
    # A plumb-bob hangs from the last letter, and a flame lives in each O.
    x = art.width - 13
    result.rect(x, 30, 1, 8, "r")
    bob(0.0, result, x, 37)
    for middle in (126, 150):
        for k, half in enumerate((2, 3, 4, 4, 4, 3, 3, 2, 2, 1, 1)):
            result.rect(middle - half, 25 - k, 2 * half, 1, "c" if k == 0 else "o")
            inner = half - 2 if k < 7 else 0
            if inner > 0:
                result.rect(middle - inner, 25 - k, 2 * inner, 1, "Y" if k < 4 else "y")
    return result


def build():
    return {"logo.png": logo()}
