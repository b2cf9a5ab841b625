"""The far world, layer by layer: every picture repeats sideways without a seam. View of 320x180."""

import math

from canvas import BAYER, Canvas, dithered, noise

VIEW = (320, 180)


def hills(width, base, waves):
    """A ridge y(x) that repeats after `width`: waves of (turns, height, shift)."""
    return [base + sum(height * math.sin(2 * math.pi * turns * x / width + shift)
                       for turns, height, shift in waves) for x in range(width)]


def crags(width, base, height, seed, steps=5):
    """A rough ridge by midpoint displacement, repeating after `width` (a power of two times 5)."""
    count = 5
    points = [base + (noise(k, seed) - 0.5) * height for k in range(count)]
    for step in range(steps):
        height *= 0.52
        points = [p for k in range(len(points)) for p in (
            points[k], (points[k] + points[(k + 1) % len(points)]) / 2 + (noise(k, step, seed) - 0.5) * height)]
    span = width / len(points)
    return [points[int(x / span)] + (points[(int(x / span) + 1) % len(points)] - points[int(x / span)])
            * (x / span % 1) for x in range(width)]


def fill_below(canvas, ridge, ramp, depth, edge=None, fade_from=0):
    """Everything under the ridge: the first of the ramp at the top, dithered to the last `depth` px below."""
    for x in range(canvas.width):
        top = int(ridge[x])
        for y in range(max(top, 0), canvas.height):
            canvas.put(x, y, edge if edge and y == top else dithered(ramp, (y - top - fade_from) / depth, x, y))


def sky(ramp, stars, bottom=150, seed=1):
    picture = Canvas(*VIEW)
    for y in range(VIEW[1]):
        for x in range(VIEW[0]):
            picture.put(x, y, dithered(ramp, y / bottom, x, y))
    for k in range(stars):
        x, y = int(noise(k, seed, 1) * 320), int(noise(k, seed, 2) ** 1.6 * 90)
        picture.put(x, y, "e" if k % 3 == 0 else "h" if k % 3 == 1 else "q")
        if k % 11 == 0:
            for i, j in ((1, 0), (-1, 0), (0, 1), (0, -1)):
                picture.put(x + i, y + j, "q")
            picture.put(x, y, "Y")
    return picture


def moon(picture, cx, cy, radius, light, mid, halo):
    for y in range(cy - radius * 3, cy + radius * 3):
        for x in range(cx - radius * 3, cx + radius * 3):
            far = math.hypot(x - cx, y - cy)
            if far <= radius:
                crater = any(math.hypot(x - cx - i, y - cy - j) < r for i, j, r in (
                    (-radius * .35, radius * .2, radius * .26), (radius * .4, -radius * .3, radius * .18),
                    (radius * .25, radius * .45, radius * .14)))
                picture.put(x, y, mid if crater or far > radius - 1.2 and x > cx else light)
            elif far < radius * 2.6 and BAYER[y % 8][x % 8] > 0.45 + (far - radius) / (radius * 1.6) * 0.55:
                picture.put(x, y, halo)


def conifer(canvas, cx, foot, height, body, lit=None):
    """A fir of ragged tiers; its left side may catch the light."""
    tiers = max(3, height // 9)
    for y in range(height - 3):
        tier = y * tiers / (height - 3)
        half = 0.6 + (tier % 1 * 0.75 + int(tier) * 0.55) * height / 34 * 3.1
        half += (noise(cx, y, height) - 0.5) * 1.2
        for x in range(int(-half), int(half) + 1):
            tone = lit if lit and x < -half * 0.35 and noise(cx + x, y, 3) > 0.3 else body
            canvas.wrap(cx + x, foot - height + y, tone)
    for y in range(4):
        canvas.wrap(cx, foot - 3 + y, body)


def grove(canvas, ridge, count, sizes, body, seed, lit=None):
    spots = sorted((noise(k, seed, 5) * canvas.width, k) for k in range(count))
    for at, k in spots:
        x = int(at) % canvas.width
        conifer(canvas, x, int(ridge[x]) + 4, int(sizes[0] + noise(k, seed, 6) * (sizes[1] - sizes[0])), body, lit)


def trunk(canvas, cx, width, body, edge, seed):
    """A trunk that leaves the picture at the top, with roots and a few dead branches."""
    for y in range(canvas.height):
        flare = max(0, y - 140) ** 2 / 190 + max(0, 24 - y) ** 2 / 90
        sway = 2.2 * math.sin(y / 31 + seed)
        half = width / 2 + flare
        for x in range(int(-half), int(half) + 1):
            canvas.wrap(int(cx + sway) + x, y, edge if x <= -half + 1.6 and noise(y // 3, seed) > 0.25 else body)
    for k in range(3):
        y, side = 30 + int(noise(k, seed) * 70), 1 if noise(k, seed, 2) > 0.5 else -1
        for i in range(10 + int(noise(k, seed, 3) * 14)):
            for t in range(max(1, 3 - i // 5)):
                canvas.wrap(int(cx) + side * (width // 2 + i), y - i // 2 + t, body)


def mist(width, height, letter, seed, top=0.3):
    """A bank of mist in dither only, thicker below."""
    picture = Canvas(width, height)
    edge = hills(width, height * top, [(2, height * .12, seed), (3, height * .1, seed * 2), (5, height * .05, 1)])
    for x in range(width):
        for y in range(height):
            thick = (y - edge[x]) / (height - edge[x] + 1) * 0.75
            if thick > BAYER[y % 8][x % 8]:
                picture.put(x, y, letter)
    return picture


def wood():
    heaven = sky("npumqhf", 70)
    moon(heaven, 236, 62, 21, "e", "f", "h")
    far = Canvas(*VIEW)
    fill_below(far, crags(320, 104, 58, 3), "mmmqh", 74, "q")
    nearer = crags(320, 122, 40, 8)
    fill_below(far, nearer, "uuum", 60, "m")
    middle = Canvas(384, 180)
    ridge = hills(384, 134, [(1, 9, 0.4), (3, 5, 2.0), (5, 2, 1.0)])
    grove(middle, ridge, 46, (16, 40), "u", 2)
    fill_below(middle, ridge, "uuum", 60)
    ridge = hills(384, 150, [(2, 7, 1.4), (3, 5, 0.0), (7, 2, 1.0)])
    grove(middle, ridge, 40, (22, 50), "p", 4)
    fill_below(middle, ridge, "ppu", 50)
    near = Canvas(512, 180)
    ridge = hills(512, 166, [(2, 5, 0.4), (5, 3, 2.0)])
    for k, (x, width) in enumerate(((40, 16), (150, 10), (232, 22), (338, 12), (440, 18))):
        trunk(near, x, width, "n", "p", k)
    grove(near, ridge, 20, (18, 34), "n", 9)
    fill_below(near, ridge, "nn", 20)
    return {"wood_sky.png": heaven, "wood_far.png": far, "wood_middle.png": middle, "wood_near.png": near,
            "wood_mist.png": mist(384, 72, "m", 1.0)}


def crystal(canvas, x, foot, height, lean, letters):
    light, mid, dark = letters
    for y in range(height):
        half = min(height * 0.16 + 1, (height - y) * 0.7)
        cx = x + lean * y
        for i in range(int(-half), int(half) + 1):
            canvas.wrap(int(cx) + i, foot - y, light if i < -half * 0.3 else mid if i < half * 0.4 else dark)


def hanging(canvas, ridge, body, edge=None):
    for x in range(canvas.width):
        for y in range(int(ridge[x])):
            canvas.put(x, y, edge if edge and y >= int(ridge[x]) - 1 else body)


def pillar(canvas, cx, width, top, body, edge, dark):
    for y in range(top, canvas.height):
        wide = width // 2 + (3 if y < top + 4 or y > 168 else 2 if y < top + 7 else 0)
        for x in range(-wide, wide + 1):
            tone = edge if x < -wide + 2 else dark if x % 5 == 0 or x > wide - 3 else body
            canvas.wrap(cx + x, y, dark if y % 24 == 0 else tone)


def cave():
    heaven = Canvas(*VIEW)
    for y in range(180):
        for x in range(320):
            far = math.hypot((x - 170) * 0.62, y - 96) / 130
            beam = 0.13 * max(0, 1 - abs((x - y * 0.45) % 107 - 30) / 13) * (1 - y / 200)
            heaven.put(x, y, dithered("tddAAn", far - 1.6 * beam + 0.1, x, y))
    far = Canvas(*VIEW)
    hanging(far, [34 - 0.5 * y + 20 for y in crags(320, 40, 60, 12)], "A")
    for x, width, top in ((38, 14, 62), (112, 12, 84), (205, 16, 58), (284, 12, 74)):
        pillar(far, x, width, top, "d", "t", "A")
    fill_below(far, crags(320, 146, 24, 5), "dAAA", 30, "t")
    middle = Canvas(384, 180)
    spikes = crags(384, 20, 26, 21, 6)
    hanging(middle, [max(4, y + (14 if int(x / 9) % 4 == 0 else 0) * (1 - abs(x % 9 - 4) / 5))
                     for x, y in enumerate(spikes)], "n", "A")
    for x, height, lean in ((60, 34, 0.2), (70, 22, -0.3), (52, 18, -0.5), (210, 40, -0.15), (221, 26, 0.3),
                            (330, 24, 0.2), (322, 30, -0.2), (140, 20, 0.3), (132, 26, -0.1),
                            (272, 18, -0.3)):
        crystal(middle, x, 162, height, lean, "zit" if x not in (330, 322, 132, 140) else "hqm")
    fill_below(middle, crags(384, 154, 22, 31), "nnk", 30, "A")
    near = Canvas(512, 180)
    hanging(near, [8 + 10 * abs(math.sin(2 * math.pi * 6 * x / 512)) ** 6 + 4 * math.sin(2 * math.pi * 3 * x / 512)
                   for x in range(512)], "k")
    fill_below(near, [y + 14 for y in crags(512, 156, 22, 41)], "kk", 20)
    return {"cave_sky.png": heaven, "cave_far.png": far, "cave_middle.png": middle, "cave_near.png": near,
            "cave_mist.png": mist(384, 72, "d", 2.0)}


def peak():
    heaven = sky("kAAdtih", 110, 165, 7)
    for x in range(320):
        for band, (base, letter) in enumerate(((44, "3"), (54, "i"), (38, "q"))):
            crest = base + 12 * math.sin(x / 34 + band * 2) + 6 * math.sin(x / 13 + band)
            for y in range(int(crest) - 22, int(crest)):
                strength = (1 - (crest - y) / 22) * (0.42 + 0.2 * math.sin(x / 7 + band))
                if strength > BAYER[y % 8][x % 8] + 0.08 and y >= 0:
                    heaven.put(x, y, letter)
    moon(heaven, 40, 40, 13, "e", "z", "t")
    far = Canvas(*VIEW)
    ridge = crags(320, 98, 84, 16)
    fill_below(far, ridge, "tti", 80)
    for x in range(320):
        slope = ridge[(x + 2) % 320] - ridge[x - 2]
        for y in range(int(ridge[x]), min(int(ridge[x]) + 24 + int(8 * noise(x // 3, 2)), 180)):
            if noise(x // 2, y // 3, 4) > (y - ridge[x]) / 28:
                far.put(x, y, "z" if slope < 0 else "i")
    middle = Canvas(384, 180)
    ridge = hills(384, 140, [(1, 9, 0.4), (3, 6, 2.6), (5, 2, 1.0)])
    grove(middle, ridge, 44, (18, 44), "d", 12, "i")
    fill_below(middle, ridge, "itd", 50, "z")
    near = Canvas(512, 180)
    ridge = hills(512, 160, [(2, 6, 1.4), (5, 3, 0.0)])
    grove(near, ridge, 26, (34, 74), "A", 19, "t")
    fill_below(near, ridge, "tdA", 40, "i")
    return {"peak_sky.png": heaven, "peak_far.png": far, "peak_middle.png": middle, "peak_near.png": near,
            "peak_mist.png": mist(384, 72, "t", 3.0)}


def build():
    return {**wood(), **cave(), **peak()}
