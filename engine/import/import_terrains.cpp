#include "import/import_terrains.hpp"

#include <cstdint>
#include <string>

#include "assets/terrain.hpp"
#include "assets/tileset.hpp"
#include "core/text.hpp"
#include "reflect/json_members.hpp"

namespace plumb {
namespace {

constexpr std::size_t kMostTerrains = 255;  // of a tileset

TerrainMode modeOf(const Json& set) {
    const std::string type = textOrEmpty(set["type"]);
    if (type == "corner") return TerrainMode::Corners;
    return type == "edge" ? TerrainMode::Edges : TerrainMode::Blob;
}

/// The neighbours that are of one color, 0 when a later color is among them: the order of the eight numbers
/// is that of Neighbour's bits.
std::uint8_t maskOf(const Json& ids, int color, TerrainMode mode) {
    std::uint8_t mask = 0;
    for (std::size_t i = 0; i < ids.size() && i < 8; ++i) {
        if (ids[i] > color) return 0;
        if (ids[i] == color) mask = static_cast<std::uint8_t>(mask | 1u << i);
    }
    return countedMask(mode, mask);
}

/// "#rrggbb" of "#aarrggbb", which Tiled also writes.
std::string opaque(const std::string& color) {
    return color.size() == 9 ? format("#{}", color.substr(3)) : color;
}

/// @param number  of the color, from 1 on
Json terrainOf(const Json& set, int number) {
    const Json& color = set["colors"][static_cast<std::size_t>(number - 1)];
    const TerrainMode mode = modeOf(set);
    const std::string name = textOrEmpty(color["name"]);
    Json terrain = Json::object();
    terrain["name"] = name.empty() ? set["name"] : Json(name);
    terrain["mode"] = std::string{terrainModeNames()[static_cast<std::size_t>(mode)]};
    if (const std::string shown = textOrEmpty(color["color"]); !shown.empty())
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
            if (terrain["tiles"].empty() || terrains.size() >= kMostTerrains) continue;
            terrain["id"] = terrains.size() + 1;
            terrains.push_back(std::move(terrain));
        }
    }
    return terrains;
}

}  // namespace plumb
