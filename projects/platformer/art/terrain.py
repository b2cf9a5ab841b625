"""Ground that grows its own edges: one 16x16 tile for each way its eight neighbours can be.

A tile is drawn on a plane that knows where ground and air are around it. Every pixel asks how far the air
is above, below and beside it, and takes its colour from that, so edges, inner corners and slopes all come
out of one rule and fit each other without seams.
"""

from canvas import Canvas, noise

SIZE = 16
FAR = 14  # px; farther from the air than this all ground is alike
# Neighbours as bits, clockwise from above.
UP, UP_RIGHT, RIGHT, DOWN_RIGHT, DOWN, DOWN_LEFT, LEFT, UP_LEFT = (1 << k for k in range(8))
OFFSETS = {UP: (0, -1), UP_RIGHT: (1, -1), RIGHT: (1, 0), DOWN_RIGHT: (1, 1), DOWN: (0, 1),
           DOWN_LEFT: (-1, 1), LEFT: (-1, 0), UP_LEFT: (-1, -1)}


def reduced(mask):
    """A corner only shows when both its sides are ground: 256 masks become 47."""
    for corner, sides in ((UP_RIGHT, UP | RIGHT), (DOWN_RIGHT, DOWN | RIGHT), (DOWN_LEFT, DOWN | LEFT),
                          (UP_LEFT, UP | LEFT)):
        if mask & sides != sides:
            mask &= ~corner
    return mask


BLOB = sorted({reduced(mask) for mask in range(256)})  # tile k of a set's first 47 has neighbours BLOB[k]
ALL = 255
TOP = ALL & ~(UP | UP_LEFT | UP_RIGHT)
BOTTOM = ALL & ~(DOWN | DOWN_LEFT | DOWN_RIGHT)
LEFT_SIDE = ALL & ~(LEFT | UP_LEFT | DOWN_LEFT)
RIGHT_SIDE = ALL & ~(RIGHT | UP_RIGHT | DOWN_RIGHT)
VARIANTS = [TOP] * 3 + [ALL] * 6 + [LEFT_SIDE] * 2 + [RIGHT_SIDE] * 2 + [BOTTOM] * 2  # row 3 of a set


def ground_of(mask):
    """Whether there is ground at a pixel of the tile or of its eight neighbours."""
    known = {offset: bool(mask & bit) for bit, offset in OFFSETS.items()}
    known[0, 0] = True
    return lambda x, y: known[x // SIZE, y // SIZE]


# Slopes: the surface as a line y = start + rise * x, going on beyond the tile.
SLOPES = {
    "slopeUp": lambda x, y: y >= 15 - x,
    "slopeDown": lambda x, y: y >= x,
    "slopeUpLow": lambda x, y: y >= 15 - x // 2,
    "slopeUpHigh": lambda x, y: y >= 7 - x // 2,
    "slopeDownHigh": lambda x, y: y >= x // 2,
    "slopeDownLow": lambda x, y: y >= 8 + x // 2,
}


class Depths:
    """How far a pixel of the tile lies from the air (px, at most FAR): up, down, left, right, any way."""

    def __init__(self, solid):
        self.solid = solid
        reach = range(-SIZE, 2 * SIZE)
        near = {(x, y): 0 if not solid(x, y) else FAR * 3 for x in reach for y in reach}
        for order, steps in ((1, ((-1, 0, 3), (0, -1, 3), (-1, -1, 4), (1, -1, 4))),
                             (-1, ((1, 0, 3), (0, 1, 3), (1, 1, 4), (-1, 1, 4)))):
            for y in list(reach)[::order]:
                for x in list(reach)[::order]:
                    near[x, y] = min([near[x, y]] + [near[x + i, y + j] + cost for i, j, cost in steps
                                                     if (x + i, y + j) in near])
        self.near = near

    def toward(self, x, y, dx, dy):
        for steps in range(1, FAR + 1):
            if not self.solid(min(max(x + dx * steps, -SIZE), 2 * SIZE - 1),
                              min(max(y + dy * steps, -SIZE), 2 * SIZE - 1)):
                return steps - 1
        return FAR

    def at(self, x, y):
        return (self.toward(x, y, 0, -1), self.toward(x, y, 0, 1), self.toward(x, y, -1, 0),
                self.toward(x, y, 1, 0), min(self.near[x, y] // 3 - 1, FAR))


def grass_length(x, seed):
    """How deep grass hangs at column x (px); the same at a tile's borders in every variant."""
    inner = seed if 2 <= x <= 13 else 0
    return 3 + (noise(x // 2, inner, 7) > 0.45) + 2 * (noise(x // 2, inner, 8) > 0.72)


def wood_ground(x, y, depth, seed):
    up, down, left, right, any_way = depth
    hang = grass_length(x, seed)
    if up == 0:
        return "5" if noise(x, seed if 1 <= x <= 14 else 0, 3) > 0.5 else None
    if up == 1:
        return "5" if noise(x, seed, 4) > 0.35 else "4"
    if up <= hang:
        return "4" if up == 2 or noise(x, up, seed, 5) > 0.78 else "3"
    if up == hang + 1:
        return "2"
    if up == hang + 2:
        return "1"
    if (left == 0 or right == 0) and noise(y, left == 0, seed if 1 <= y <= 14 else 0, 9) > 0.6:
        return None
    if left <= 1 and (left == 0 or noise(y, 11) > 0.5):
        return "s"
    if down == 0:
        return "B" if noise(x, 12) > 0.25 else None
    if right == 0:
        return "l"
    if any_way <= 3 + 2 * (noise(x // 2, y // 2, 13) > 0.5):
        return "l" if noise(x // 3, y // 2, 14) > 0.72 else "B"
    if any_way <= 8 and noise(x // 2, y // 2, 15) > 0.35 + any_way * 0.06:
        return "B"
    return "b"


def brick(x, y):
    """Mortar lines of the ruin's courses: 8 px high, 16 px wide, every other one shifted."""
    return y % 8 == 7 or (x + (8 if y // 8 % 2 else 0)) % 16 == 15


def cave_ground(x, y, depth, seed):
    up, down, left, right, any_way = depth
    hang = grass_length(x, seed) - 2
    if up == 0:
        return "4" if noise(x, seed if 1 <= x <= 14 else 0, 3) > 0.55 else "3"
    if up <= hang:
        return "3" if noise(x, up, 5) > 0.6 else "2"
    if up == hang + 1:
        return "1"
    if (left == 0 or right == 0 or down == 0) and brick(x, y):
        return "A"
    if left == 0 or (up < 6 and y % 8 == 0 and any_way < 5):
        return "i" if noise(x, y, 2) > 0.3 else "t"
    if right == 0 or down == 0:
        return "d"
    if brick(x, y):
        return "A" if any_way < 9 else "n"
    shade = noise((x + (8 if y // 8 % 2 else 0)) // 16, y // 8, seed, 6)
    if any_way <= 4:
        return "t" if y % 8 == 0 or shade > 0.5 else "d"
    if any_way <= 8:
        return "d" if y % 8 == 0 or shade > 0.4 else "A"
    return "A" if y % 8 == 0 and noise(x // 3, y, seed, 1) > 0.5 else "n"


def peak_ground(x, y, depth, seed):
    up, down, left, right, any_way = depth
    cap = grass_length(x, seed) + 1
    if up == 0:
        return "e" if noise(x // 3, seed if 2 <= x <= 13 else 0, 3) > 0.3 else None
    if up < cap - 1:
        return "e" if up < 3 else "z"
    if up < cap:
        return "z" if noise(x, 5) > 0.4 else "i"
    if up == cap:
        return "i"
    if up == cap + 1:
        return "d"
    if (left == 0 or right == 0) and noise(y // 2, left == 0, seed if 2 <= y <= 13 else 0, 9) > 0.66:
        return None
    if left == 0:
        return "q"
    if right == 0 or down == 0:
        return "u"
    facet = (x * 3 + y * 5 + 8 * (noise(x // 5, y // 4, seed, 4) > 0.5)) % 16
    if any_way <= 3:
        return "m" if facet < 5 else "u"
    if any_way <= 7:
        return "u" if facet < 5 else "p"
    return "p" if facet < 2 and noise(x // 4, y // 4, seed, 6) > 0.5 else "n"


# What lies in the deep ground, by variant of the full tile: pale on dark, never loud.
BURIED = {
    "wood": [(1, "....\n.BB.\nBlBB\n.BB.", 3, 8), (2, "B.....\nBB....\n.BB.B.\n..BBB.\n...B..", 6, 4),
             (3, "..BB\n.BlB\n..BB\n.B..\nB...", 9, 5), (4, ".BBB.\nBBBBB\nB.B.B\nBBBBB\n.B.B.", 5, 6)],
    "cave": [(1, "A..A\nAddA\n.AA.", 4, 9), (3, ".AAA.\nAdAdA\nAAAAA\n.A.A.", 8, 3), (4, "AA\nAd", 3, 3)],
    "peak": [(1, "..p..\n.pup.\npuup.\n.pp..", 4, 7), (3, ".p.\npqp\npup\n.p.", 9, 4)],
}
SHADERS = {"wood": wood_ground, "cave": cave_ground, "peak": peak_ground}
# The wall behind: the same shapes, a few steps darker and without a cap.
WALL = {
    "wood": {"5": "1", "4": "1", "3": "1", "2": "1", "1": "n", "s": "B", "l": "b", "B": "b", "b": "k"},
    "cave": {"4": "1", "3": "1", "2": "1", "i": "d", "t": "A", "d": "A", "A": "n", "n": "k"},
    "peak": {"e": "d", "z": "d", "i": "A", "d": "A", "q": "p", "m": "p", "u": "n", "p": "n", "n": "k"},
}


def tile(solid, biome, seed=0):
    depths, shade, cell = Depths(solid), SHADERS[biome], Canvas(SIZE, SIZE)
    for y in range(SIZE):
        for x in range(SIZE):
            if solid(x, y):
                letter = shade(x, y, depths.at(x, y), seed)
                if letter:
                    cell.put(x, y, letter)
    return cell


def ground_tiles(biome):
    """The 47 shapes, then row 3's variants, then row 4's slopes."""
    shapes = [tile(ground_of(mask), biome) for mask in BLOB]
    variants = []
    for k, mask in enumerate(VARIANTS):
        seed = 1 + k - VARIANTS.index(mask)
        variants.append(tile(ground_of(mask), biome, seed))
        for number, art, x, y in BURIED[biome]:
            if mask == ALL and number == seed:
                variants[-1].stamp(art, x, y)
    return shapes, variants, [tile(solid, biome) for solid in SLOPES.values()]


def wall_tiles(biome, shapes):
    walls = []
    for shape in shapes:
        walls.append(shape.cut(0, 0, SIZE, SIZE).swap(WALL[biome]))
    return walls
