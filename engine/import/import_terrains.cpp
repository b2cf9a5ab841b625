#include "import/import_terrains.hpp"

#include <cstdint>
#include <string>

#include "assets/terrain.hpp"
#include "assets/tileset.hpp"
#include "core/text.hpp"
#include "reflect/json_members.hpp"

namespace plumb {
namespace {

constexpr std::size_t kMaxTerrains = 255;  // maximum number of terrains of a tileset

TerrainMode modeOf(const Json& set) {
    const std::string type = stringOrEmpty(set["type"]);
    if (type == "corner") return TerrainMode::Corners;
    return type == "edge" ? TerrainMode::Edges : TerrainMode::Blob;
}

/// Returns the mask of neighbours of one color, or 0 if a later color is among them. Tiled's eight Wang ids
/// have the same order as the bits of Neighbour.
std::uint8_t maskOf(const Json& ids, int color, TerrainMode mode) {
    std::uint8_t mask = 0;
    for (std::size_t i = 0; i < ids.size() && i < 8; ++i) {
        if (ids[i] > color) return 0;
        if (ids[i] == color) mask = static_cast<std::uint8_t>(mask | 1u << i);
    }
    return countedMask(mode, mask);
}

/// Converts "#aarrggbb", a form that Tiled also writes, to "#rrggbb".
std::string opaque(const std::string& color) {
    return color.size() == 9 ? format("#{}", color.substr(3)) : color;
}

/// Returns the terrain of one color of a Wang set. @param number  index of the color, 1 for the first
Json terrainOf(const Json& set, int number) {
    const Json& color = set["colors"][static_cast<std::size_t>(number - 1)];
    const TerrainMode mode = modeOf(set);
    const std::string name = stringOrEmpty(color["name"]);
    Json terrain = Json::object();
    terrain["name"] = name.empty() ? set["name"] : Json(name);
    terrain["mode"] = std::string{terrainModeNames()[static_cast<std::size_t>(mode)]};
    if (const std::string shown = stringOrEmpty(color["color"]); !shown.empty())
        terrain["color"] = opaque(shown);
    terrain["tiles"] = Json::array();
    for (const Json& tile : set["tiles"]) {
        const std::uint8_t mask = maskOf(tile["ids"], number, mode);
        if (mask == 0 || tile["tile"] >= Tileset::kMaxTiles) continue;
        Json item = Json::object();
        item["tile"] = tile["tile"];
        item["mask"] = mask;
        terrain["tiles"].push_back(std::move(item));
    }
    return terrain;
}

}  // namespace

Json terrainsOf(const tiled::Tileset& tileset) {
    Json terrains = Json::array();
    for (const Json& set : tileset.wangSets) {
        for (std::size_t color = 1; color <= set["colors"].size(); ++color) {
            Json terrain = terrainOf(set, static_cast<int>(color));
            if (terrain["tiles"].empty() || terrains.size() >= kMaxTerrains) continue;
            terrain["id"] = terrains.size() + 1;
            terrains.push_back(std::move(terrain));
        }
    }
    return terrains;
}

}  // namespace plumb
