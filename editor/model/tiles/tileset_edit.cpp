#include "editor/model/tiles/tileset_edit.hpp"

#include <algorithm>
#include <array>

#include "assets/asset_store.hpp"
#include "core/text.hpp"
#include "editor/model/commands/write_tileset.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/workspace.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"
#include "scene/components/drawing/tile_layer.hpp"

namespace plumb::editor {
namespace {

constexpr std::array kTerrainColors{Color{120, 200, 90, 255},  Color{214, 158, 92, 255},
                                    Color{96, 160, 230, 255},  Color{220, 110, 110, 255},
                                    Color{180, 130, 220, 255}, Color{230, 205, 90, 255}};

bool containsWords(std::string_view text, std::string_view words) {
    const auto same = [](char a, char b) {
        const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
        return lower(a) == lower(b);
    };
    return std::search(text.begin(), text.end(), words.begin(), words.end(), same) != text.end();
}

bool isFound(const Tile& tile, std::string_view words) {
    if (containsWords(tile.material, words)) return true;
    if (containsWords(tileShapeNames()[static_cast<std::size_t>(tile.shape)], words)) return true;
    return std::any_of(tile.properties.begin(), tile.properties.end(), [&](const TileProperty& property) {
        return containsWords(property.name, words) || containsWords(property.json, words);
    });
}

}  // namespace

Tile& tileIn(Tileset& tileset, int tile) {
    const auto at = std::lower_bound(tileset.tiles.begin(), tileset.tiles.end(), tile,
                                     [](const Tile& a, int id) { return a.id < id; });
    if (at != tileset.tiles.end() && at->id == tile) return *at;
    Tile made;
    made.id = tile;
    return *tileset.tiles.insert(at, made);
}

void tidy(Tileset& tileset) {
    std::erase_if(tileset.tiles, [](const Tile& tile) {
        Tile plain;
        plain.id = tile.id;
        return tile == plain;
    });
}

void setShape(Tileset& tileset, std::span<const int> tiles, TileShape shape) {
    for (const int id : tiles) {
        Tile& tile = tileIn(tileset, id);
        tile.shape = shape;
        tile.polygons.clear();
    }
}

void setPolygons(Tileset& tileset, std::span<const int> tiles, std::vector<std::vector<Vec2>> polygons) {
    std::erase_if(polygons, [](const std::vector<Vec2>& polygon) { return polygon.size() < 3; });
    for (const int id : tiles) {
        Tile& tile = tileIn(tileset, id);
        tile.shape = polygons.empty() ? TileShape::None : TileShape::Polygon;
        tile.polygons = polygons;
    }
}

void setProperty(Tileset& tileset, std::span<const int> tiles, std::string_view name, std::string_view json) {
    for (const int id : tiles) {
        std::vector<TileProperty>& properties = tileIn(tileset, id).properties;
        const auto known = std::find_if(properties.begin(), properties.end(),
                                        [&](const TileProperty& property) { return property.name == name; });
        if (json.empty()) {
            if (known != properties.end()) properties.erase(known);
        } else if (known != properties.end()) {
            known->json = json;
        } else {
            properties.push_back({std::string{name}, std::string{json}});
        }
    }
}

std::string propertyJson(std::string_view typed) {
    if (typed.empty()) return "true";
    const Result<Json> json = parseJson(typed, "property");
    return compactText(json ? *json : Json(std::string{typed}));
}

std::vector<int> tilesFound(const Tileset& tileset, std::string_view words) {
    std::vector<int> found;
    for (int tile = 0; tile < tileset.count; ++tile) {
        const Tile* known = words.empty() ? nullptr : tileset.find(tile);
        if (words.empty() || format("{}", tile) == words || (known != nullptr && isFound(*known, words)))
            found.push_back(tile);
    }
    return found;
}

Terrain& addTerrain(Tileset& tileset, TerrainMode mode) {
    Terrain terrain;
    terrain.mode = mode;
    terrain.id = tileset.terrains.empty() ? 1 : tileset.terrains.back().id + 1;
    terrain.name = format("terrain {}", terrain.id);
    terrain.color = kTerrainColors[static_cast<std::size_t>(terrain.id - 1) % kTerrainColors.size()];
    tileset.terrains.push_back(std::move(terrain));
    return tileset.terrains.back();
}

std::span<const std::string_view> terrainLayoutNames() {
    static constexpr std::array<std::string_view, 3> kNames{"in mask order", "4 x 4", "3 x 3"};
    return kNames;
}

void assignMasks(Terrain& terrain, const Tileset& tileset, std::span<const int> chosen,
                 TerrainLayout layout) {
    if (chosen.empty()) return;
    terrain.tiles.clear();
    if (layout == TerrainLayout::InOrder) {
        const std::vector<std::uint8_t> masks = masksOf(terrain.mode);
        for (std::size_t i = 0; i < std::min(chosen.size(), masks.size()); ++i)
            terrain.tiles.push_back({chosen[i], masks[i]});
        return;
    }
    const auto side = static_cast<int>(layout == TerrainLayout::Block ? 3 : 4);
    const Tileset::Place first = tileset.placeOf(chosen.front());
    for (const int tile : chosen) {
        const Tileset::Place at = tileset.placeOf(tile);
        const int x = at.column - first.column;
        const int y = at.row - first.row;
        if (x < 0 || y < 0 || x >= side || y >= side) continue;
        // The last column has the tiles of terrain one cell wide, the last row those of terrain one cell
        // high; their common corner is the tile of a single cell.
        using N = Neighbour;
        unsigned mask = N::kAll;
        const unsigned up = N::kUp | N::kUpLeft | N::kUpRight;
        const unsigned down = N::kDown | N::kDownLeft | N::kDownRight;
        const unsigned left = N::kLeft | N::kUpLeft | N::kDownLeft;
        const unsigned right = N::kRight | N::kUpRight | N::kDownRight;
        if (x == 0 || x == 3) mask &= ~left;
        if (x == 2 || x == 3) mask &= ~right;
        if (y == 0 || y == 3) mask &= ~up;
        if (y == 2 || y == 3) mask &= ~down;
        terrain.tiles.push_back({tile, countedMask(terrain.mode, static_cast<std::uint8_t>(mask))});
    }
}

void setMask(Terrain& terrain, std::span<const int> tiles, std::optional<std::uint8_t> mask) {
    for (const int id : tiles) {
        const auto known = std::find_if(terrain.tiles.begin(), terrain.tiles.end(),
                                        [&](const TerrainTile& tile) { return tile.tile == id; });
        if (!mask) {
            if (known != terrain.tiles.end()) terrain.tiles.erase(known);
        } else if (known != terrain.tiles.end()) {
            known->mask = *mask;
        } else {
            terrain.tiles.push_back({id, *mask});
        }
    }
}

std::optional<std::uint8_t> maskOf(const Terrain& terrain, int tile) {
    const auto known = std::find_if(terrain.tiles.begin(), terrain.tiles.end(),
                                    [&](const TerrainTile& other) { return other.tile == tile; });
    if (known == terrain.tiles.end()) return std::nullopt;
    return known->mask;
}

bool changeTileset(Workspace& workspace, std::string label, const std::function<void(Tileset&)>& change) {
    const ObjectId layer = activeTileLayer(workspace.document, workspace.tiles);
    const Tileset* tileset = tilesetOf(workspace.document, layer);
    if (tileset == nullptr || !workspace.canEdit()) return false;
    const TilesetId id = workspace.document.world.get<TileLayer>(workspace.document.find(layer)).tileset;
    Tileset changed = *tileset;
    change(changed);
    tidy(changed);
    if (changed == *tileset) return false;
    const Result<Path> file = workspace.assets.resolve(workspace.assets.pathOf(id));
    if (!file || !std::filesystem::exists(*file)) {
        workspace.notice = "This tileset has no file of its own in the project, so it cannot be changed";
        return false;
    }
    workspace.undo.push(
        std::make_unique<WriteTileset>(std::move(label), workspace.assets, id, writeTileset(changed)));
    return true;
}

}  // namespace plumb::editor
