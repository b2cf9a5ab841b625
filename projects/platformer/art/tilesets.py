"""Puts each biome's tiles into one picture of 16 columns, and writes what each tile means beside it.

Rows: 0-2 ground in its 47 shapes | 3 variants of the common ones | 4 slopes | 5 planks, thorns |
6 small things | 8-10 the wall behind in the same 47 shapes.
"""

from animations import text_of
from canvas import Canvas
from decor import ORDER, planks, small_tiles, thorns
from terrain import ALL, BLOB, SIZE, SLOPES, VARIANTS, ground_tiles, wall_tiles

COLUMNS, ROWS = 16, 11
VARIANT_ROW, SLOPE_ROW, EDGE_ROW, SMALL_ROW, WALL_ROW = 3, 4, 5, 6, 8
THORN_NAMES = ["thornsUp", "thornsUp2", "thornsDown", "thornsDown2", "thornsRight", "thornsLeft"]


def meaning():
    """{tile number: {"collision": ..., "properties": ...}} for every tile that is more than a picture."""
    tiles = {k: {"collision": "full"} for k in range(len(BLOB))}
    for k, mask in enumerate(VARIANTS):  # bones and roots in the depth are rare
        rare = {"probability": 0.04} if mask == ALL else {}
        tiles[VARIANT_ROW * COLUMNS + k] = {"collision": "full", **rare}
    tiles.update({SLOPE_ROW * COLUMNS + k: {"collision": name} for k, name in enumerate(SLOPES)})
    tiles.update({EDGE_ROW * COLUMNS + k: {"collision": "oneWay"} for k in range(4)})
    for k, name in enumerate(THORN_NAMES):
        tiles[EDGE_ROW * COLUMNS + 4 + k] = {"properties": {"name": name, "hazard": True}}
    for k, name in enumerate(ORDER):
        tiles[SMALL_ROW * COLUMNS + k] = {"properties": {"name": name}}
    return tiles


def terrains():
    """What the editor paints as a whole: the ground with its variants, and the wall behind."""
    ground = [{"tile": k, "mask": mask} for k, mask in enumerate(BLOB)]
    ground += [{"tile": VARIANT_ROW * COLUMNS + k, "mask": mask} for k, mask in enumerate(VARIANTS)]
    wall = [{"tile": WALL_ROW * COLUMNS + k, "mask": mask} for k, mask in enumerate(BLOB)]
    return [{"id": 1, "name": "ground", "mode": "blob", "color": "#78c85a", "tiles": ground},
            {"id": 2, "name": "wall behind", "mode": "blob", "color": "#7f8fb5", "tiles": wall}]


def description(image):
    what = {"format": 1, "image": f"assets/{image}", "tileSize": [SIZE, SIZE], "margin": 0, "spacing": 0,
            "columns": COLUMNS, "count": COLUMNS * ROWS,
            "tiles": [{"id": number, **meant} for number, meant in sorted(meaning().items())],
            "terrains": terrains()}
    return (text_of(what) + "\n").encode()


def build():
    files = {}
    for biome in ("wood", "cave", "peak"):
        picture = Canvas(COLUMNS * SIZE, ROWS * SIZE)
        shapes, variants, slopes = ground_tiles(biome)
        rows = {0: shapes, VARIANT_ROW: variants, SLOPE_ROW: slopes, EDGE_ROW: planks(biome) + thorns(biome),
                SMALL_ROW: small_tiles(biome), WALL_ROW: wall_tiles(biome, shapes)}
        for row, cells in rows.items():
            for k, cell in enumerate(cells):
                picture.paste(cell, k % COLUMNS * SIZE, (row + k // COLUMNS) * SIZE)
        files[f"{biome}.png"] = picture
        files[f"{biome}.tileset.json"] = description(f"{biome}.png")
    return files
