"""A small canvas of 0xRRGGBBAA pixels, and the few drawing functions that pixel art needs."""

from art_files import png
from palette import CLEAR, RGBA, color

# The 8x8 ordered-dither matrix of Bayer, as thresholds in 0..1.
BAYER = [[0]]
for _ in range(3):
    BAYER = [[4 * v for v in row] + [4 * v + 2 for v in row] for row in BAYER] + [
        [4 * v + 3 for v in row] + [4 * v + 1 for v in row] for row in BAYER]
BAYER = [[(v + 0.5) / 64 for v in row] for row in BAYER]


def noise(*keys):
    """A value in 0..1 that depends on whole numbers only, and not on the machine."""
    h = 0x9E3779B9
    for key in keys:
        h = (h ^ (int(key) & 0xFFFFFFFF)) * 0x85EBCA6B & 0xFFFFFFFF
        h ^= h >> 13
        h = h * 0xC2B2AE35 & 0xFFFFFFFF
        h ^= h >> 16
    return h / 0xFFFFFFFF


def dithered(ramp, t, x, y):
    """The colour of `ramp` at position t (0..1), mixed with its neighbour by ordered dither."""
    place = min(max(t, 0.0), 1.0) * (len(ramp) - 1)
    lower = min(int(place), len(ramp) - 2)
    return color(ramp[lower + (place - lower > BAYER[y % 8][x % 8])])


class Canvas:
    def __init__(self, width, height, fill=CLEAR):
        self.width, self.height = width, height
        self.pixels = [fill] * (width * height)

    def get(self, x, y):
        return self.pixels[y * self.width + x] if 0 <= x < self.width and 0 <= y < self.height else CLEAR

    def put(self, x, y, value):
        """Outside the canvas nothing happens; `value` is 0xRRGGBBAA or a palette letter."""
        if 0 <= x < self.width and 0 <= y < self.height:
            self.pixels[y * self.width + x] = RGBA[value] if isinstance(value, str) else value

    def wrap(self, x, y, value):
        """Like put, but columns go round, for pictures that repeat."""
        self.put(x % self.width, y, value)

    def rect(self, x, y, width, height, value):
        for j in range(height):
            for i in range(width):
                self.put(x + i, y + j, value)

    def line(self, x0, y0, x1, y1, value):
        steps = max(abs(x1 - x0), abs(y1 - y0), 1)
        for k in range(steps + 1):
            self.put(round(x0 + (x1 - x0) * k / steps), round(y0 + (y1 - y0) * k / steps), value)

    def disc(self, cx, cy, radius, value):
        for y in range(int(cy - radius) - 1, int(cy + radius) + 2):
            for x in range(int(cx - radius) - 1, int(cx + radius) + 2):
                if (x - cx) ** 2 + (y - cy) ** 2 <= radius * radius:
                    self.put(x, y, value)

    def stamp(self, art, x=0, y=0, flip=False, swap=None):
        """Draws ASCII art: one palette letter a pixel, '.' or space leaves what is there."""
        for j, row in enumerate(rows(art)):
            for i, letter in enumerate(reversed(row) if flip else row):
                if letter not in ". ":
                    self.put(x + i, y + j, (swap or {}).get(letter, letter))

    def paste(self, other, x, y, flip=False):
        for j in range(other.height):
            for i in range(other.width):
                value = other.get(other.width - 1 - i if flip else i, j)
                if value & 0xFF:
                    self.put(x + i, y + j, value)

    def cut(self, x, y, width, height):
        part = Canvas(width, height)
        for j in range(height):
            for i in range(width):
                part.put(i, j, self.get(x + i, y + j))
        return part

    def outline(self, value="k", corners=False):
        """Puts `value` on every clear pixel that touches a drawn one."""
        around = [(1, 0), (-1, 0), (0, 1), (0, -1)]
        around += [(1, 1), (-1, 1), (1, -1), (-1, -1)] if corners else []
        edge = [(x, y) for y in range(self.height) for x in range(self.width)
                if not self.get(x, y) & 0xFF and any(self.get(x + i, y + j) & 0xFF for i, j in around)]
        for x, y in edge:
            self.put(x, y, value)

    def swap(self, table):
        """Recolours whole colours: {letter: letter}."""
        values = {RGBA[a]: RGBA[b] for a, b in table.items()}
        self.pixels = [values.get(p, p) for p in self.pixels]
        return self

    def png(self):
        return png(self.width, self.height, b"".join(pixel.to_bytes(4, "big") for pixel in self.pixels))


def rows(art):
    """ASCII art as a list of rows: a string loses its first and last empty line."""
    return art.strip("\n").split("\n") if isinstance(art, str) else art


def sheet(cells, columns=None):
    """Cells of one size side by side, `columns` a row (all in one row by default)."""
    columns = columns or len(cells)
    width, height = cells[0].width, cells[0].height
    result = Canvas(width * columns, height * ((len(cells) + columns - 1) // columns))
    for k, cell in enumerate(cells):
        result.paste(cell, k % columns * width, k // columns * height)
    return result
