"""A 5x7 pixel font of our own, as pictures for the logo and as a TrueType file for every text in the game.

Each pixel becomes a square of 100 units in an em of 1000, so a text of size 10 px comes out pixel for pixel.
"""

import struct

# Seven rows of a glyph, or eight where it goes below the line ('g', 'p', ',').
GLYPHS = {
    "A": ".###. #...# #...# ##### #...# #...# #...#", "B": "####. #...# #...# ####. #...# #...# ####.",
    "C": ".###. #...# #.... #.... #.... #...# .###.", "D": "####. #...# #...# #...# #...# #...# ####.",
    "E": "##### #.... #.... ####. #.... #.... #####", "F": "##### #.... #.... ####. #.... #.... #....",
    "G": ".###. #...# #.... #.### #...# #...# .###.", "H": "#...# #...# #...# ##### #...# #...# #...#",
    "I": "### .#. .#. .#. .#. .#. ###", "J": "..### ...#. ...#. ...#. ...#. #..#. .##..",
    "K": "#...# #..#. #.#.. ##... #.#.. #..#. #...#", "L": "#.... #.... #.... #.... #.... #.... #####",
    "M": "#...# ##.## #.#.# #.#.# #...# #...# #...#", "N": "#...# ##..# #.#.# #..## #...# #...# #...#",
    "O": ".###. #...# #...# #...# #...# #...# .###.", "P": "####. #...# #...# ####. #.... #.... #....",
    "Q": ".###. #...# #...# #...# #.#.# #..#. .##.#", "R": "####. #...# #...# ####. #.#.. #..#. #...#",
    "S": ".#### #.... #.... .###. ....# ....# ####.", "T": "##### ..#.. ..#.. ..#.. ..#.. ..#.. ..#..",
    "U": "#...# #...# #...# #...# #...# #...# .###.", "V": "#...# #...# #...# #...# #...# .#.#. ..#..",
    "W": "#...# #...# #...# #.#.# #.#.# ##.## #...#", "X": "#...# #...# .#.#. ..#.. .#.#. #...# #...#",
    "Y": "#...# #...# .#.#. ..#.. ..#.. ..#.. ..#..", "Z": "##### ....# ...#. ..#.. .#... #.... #####",
    "a": "..... ..... .###. ....# .#### #...# .####", "b": "#.... #.... ####. #...# #...# #...# ####.",
    "c": ".... .... .### #... #... #... .###", "d": "....# ....# .#### #...# #...# #...# .####",
    "e": "..... ..... .###. #...# ##### #.... .###.", "f": "..## .#.. .#.. ###. .#.. .#.. .#..",
    "g": "..... ..... .#### #...# #...# .#### ....# .###.", "h": "#... #... ###. #..# #..# #..# #..#",
    "i": "# . # # # # #", "j": "..# ... ..# ..# ..# ..# #.# .#.", "k": "#... #... #..# #.#. ##.. #.#. #..#",
    "l": "#. #. #. #. #. #. .#", "m": "..... ..... ##.#. #.#.# #.#.# #.#.# #.#.#",
    "n": ".... .... ###. #..# #..# #..# #..#", "o": "..... ..... .###. #...# #...# #...# .###.",
    "p": "..... ..... ####. #...# #...# ####. #.... #....", "q": "..... ..... .#### #...# #...# .#### ....# ....#",
    "r": ".... .... #.## ##.. #... #... #...", "s": ".... .... .### #... .##. ...# ###.",
    "t": ".#.. .#.. ###. .#.. .#.. .#.. ..##", "u": ".... .... #..# #..# #..# #..# .###",
    "v": "..... ..... #...# #...# #...# .#.#. ..#..", "w": "..... ..... #...# #.#.# #.#.# #.#.# .#.#.",
    "x": "..... ..... #...# .#.#. ..#.. .#.#. #...#", "y": ".... .... #..# #..# #..# .### ...# .##.",
    "z": ".... .... #### ...# .##. #... ####",
    "0": ".##. #..# #.## ##.# #..# #..# .##.", "1": ".#. ##. .#. .#. .#. .#. ###",
    "2": ".##. #..# ...# ..#. .#.. #... ####", "3": "###. ...# ...# .##. ...# ...# ###.",
    "4": "..## .#.# #..# #### ...# ...# ...#", "5": "#### #... ###. ...# ...# #..# .##.",
    "6": ".##. #... #... ###. #..# #..# .##.", "7": "#### ...# ..#. ..#. .#.. .#.. .#..",
    "8": ".##. #..# #..# .##. #..# #..# .##.", "9": ".##. #..# #..# .### ...# ...# .##.",
    ".": ". . . . . . #", ",": ".. .. .. .. .. .# .# #.", ":": ". . # . . # .", ";": ".. .. .# .. .. .# #.",
    "!": "# # # # # . #", "?": ".##. #..# ...# ..#. .#.. .... .#..", "'": "# # . . . . .",
    '"': "#.# #.# ... ... ... ... ...", "-": "... ... ... ### ... ... ...", "_": ".... .... .... .... .... .... ####",
    "+": "... ... .#. ### .#. ... ...", "=": "... ... ### ... ### ... ...", "/": "...# ...# ..#. ..#. .#.. .#.. #...",
    "\\": "#... #... .#.. .#.. ..#. ..#. ...#", "(": ".# #. #. #. #. #. .#", ")": "#. .# .# .# .# .# #.",
    "[": "## #. #. #. #. #. ##", "]": "## .# .# .# .# .# ##", "<": "... ..# .#. #.. .#. ..# ...",
    ">": "... #.. .#. ..# .#. #.. ...", "*": "... #.# .#. ### .#. #.# ...", "%": "##..# ##..# ...#. ..#.. .#... #..## #..##",
    "#": ".#.#. .#.#. ##### .#.#. ##### .#.#. .#.#.", "&": ".##.. #..#. #.#.. .#... #.#.# #..#. .##.#",
    "@": ".###. #...# #.### #.#.# #.### #.... .####", "$": "..#.. .#### #.#.. .###. ..#.# ####. ..#..",
    "{": ".## .#. .#. #.. .#. .#. .##", "}": "##. .#. .#. ..# .#. .#. ##.", "|": "# # # # # # #",
    "^": ".#. #.# ... ... ... ... ...", "~": ".... .... .#.# #.#. .... .... ....", "`": "#. .# .. .. .. .. ..",
    "\u00d7": "... ... #.# .#. #.# ... ...", " ": "... ... ... ... ... ... ...",
}
PIXEL, EM, ASCENT, DESCENT = 100, 1000, 800, -200


def glyph_rows(letter):
    return GLYPHS[letter].split(" ")


def outline_of(letter):
    """The glyph as closed runs of squares: one box for each horizontal run of pixels."""
    boxes = []
    for y, row in enumerate(glyph_rows(letter)):
        x = 0
        while x < len(row):
            end = x
            while end < len(row) and row[end] == "#":
                end += 1
            if end > x:
                boxes.append((x * PIXEL, (6 - y) * PIXEL, end * PIXEL, (7 - y) * PIXEL))
            x = end + 1
    return boxes


def glyph_bytes(boxes):
    if not boxes:
        return b""
    xs, ys = [b[0] for b in boxes] + [b[2] for b in boxes], [b[1] for b in boxes] + [b[3] for b in boxes]
    data = struct.pack(">hhhhh", len(boxes), min(xs), min(ys), max(xs), max(ys))
    data += b"".join(struct.pack(">H", 4 * k + 3) for k in range(len(boxes))) + struct.pack(">H", 0)
    points = [p for x0, y0, x1, y1 in boxes for p in ((x0, y0), (x0, y1), (x1, y1), (x1, y0))]
    data += b"\x01" * len(points)
    for axis in (0, 1):
        before = 0
        for point in points:
            data += struct.pack(">h", point[axis] - before)
            before = point[axis]
    return data + b"\0" * (-len(data) % 4)


def name_table(names):
    records, text = b"", b""
    for number, value in names:
        encoded = value.encode("utf-16-be")
        records += struct.pack(">HHHHHH", 3, 1, 0x409, number, len(encoded), len(text))
        text += encoded
    return struct.pack(">HHH", 0, len(names), 6 + len(records)) + records + text


def character_map(codes):
    """Format 4, one segment for each character: small fonts need no more."""
    segments = [(code, code, index + 1 - code) for index, code in enumerate(codes)] + [(0xFFFF, 0xFFFF, 1)]
    count = len(segments)
    power = 1 << (count.bit_length() - 1)
    body = struct.pack(">HHHH", count * 2, power * 2, power.bit_length() - 1, (count - power) * 2)
    body += b"".join(struct.pack(">H", s[1]) for s in segments) + b"\0\0"
    body += b"".join(struct.pack(">H", s[0]) for s in segments)
    body += b"".join(struct.pack(">H", s[2] & 0xFFFF) for s in segments) + b"\0\0" * count
    return struct.pack(">HHHHI", 0, 1, 3, 1, 12) + struct.pack(">HHH", 4, len(body) + 6, 0) + body


def font_bytes():
    letters = sorted(GLYPHS, key=ord)
    shapes = [[(0, 0, 400, 700)]] + [outline_of(letter) for letter in letters]
    widths = [500] + [(max(len(r) for r in glyph_rows(letter)) + 1) * PIXEL for letter in letters]
    data, offsets = b"", [0]
    for boxes in shapes:
        data += glyph_bytes(boxes)
        offsets.append(len(data))
    most = max(len(boxes) for boxes in shapes)
    tables = {
        b"OS/2": struct.pack(">HhHHH", 3, 500, 400, 5, 0) + struct.pack(">hhhhhhhhhhh", *[0] * 11) + bytes(10)
        + struct.pack(">IIII", 1, 0, 0, 0) + b"PLMB" + struct.pack(">HHHhhhHHII", 64, 32, 0xD7, ASCENT, DESCENT, 0,
                                                                 ASCENT, -DESCENT, 1, 0)
        + struct.pack(">hhHHH", 500, 700, 0, 32, 0),
        b"cmap": character_map([ord(letter) for letter in letters]),
        b"glyf": data,
        b"head": struct.pack(">IIIIHHqqhhhhHHhhh", 0x10000, 0x10000, 0, 0x5F0F3CF5, 3, EM, 0, 0, 0, -100, 600, 700,
                             0, 10, 2, 1, 0),
        b"hhea": struct.pack(">IhhhHhhhhhhhhhhhH", 0x10000, ASCENT, DESCENT, 0, 600, 0, 0, 600, 1, 0, 0, 0, 0, 0, 0,
                             0, len(shapes)),
        b"hmtx": b"".join(struct.pack(">Hh", width, min([b[0] for b in boxes] or [0]))
                          for width, boxes in zip(widths, shapes)),
        b"loca": b"".join(struct.pack(">I", offset) for offset in offsets),
        b"maxp": struct.pack(">IHHHHHHHHHHHHHH", 0x10000, len(shapes), most * 4, most, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0,
                             0),
        b"name": name_table([(0, "CC0"), (1, "Wickwood"), (2, "Regular"), (3, "Wickwood 1"), (4, "Wickwood"),
                             (6, "Wickwood")]),
        b"post": struct.pack(">IIhhIIIII", 0x30000, 0, -100, 50, 0, 0, 0, 0, 0),
    }
    return assembled(tables)


def assembled(tables):
    def checksum(table):
        padded = table + b"\0" * (-len(table) % 4)
        return sum(struct.unpack(f">{len(padded) // 4}I", padded)) & 0xFFFFFFFF

    count = len(tables)
    power = 1 << (count.bit_length() - 1)
    header = struct.pack(">IHHHH", 0x10000, count, power * 16, power.bit_length() - 1, (count - power) * 16)
    at, directory, body = 12 + 16 * count, b"", b""
    for tag, table in sorted(tables.items()):
        directory += tag + struct.pack(">III", checksum(table), at + len(body), len(table))
        body += table + b"\0" * (-len(table) % 4)
    font = header + directory + body
    place = font.index(b"\x5F\x0F\x3C\xF5") - 4
    return font[:place] + struct.pack(">I", 0xB1B0AFBA - checksum(font) & 0xFFFFFFFF) + font[place + 4:]


def build():
    return {"wickwood.ttf": font_bytes()}
