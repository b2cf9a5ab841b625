#include "editor/model/tiles/tile_clipboard.hpp"

#include <cstdint>

#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"
#include "scene/files/tiles_json.hpp"

namespace plumb::editor {
namespace {

constexpr std::int64_t kMostCells = std::int64_t{1} << 22;

}  // namespace

std::string tilesAsText(const TileStamp& stamp) {
    TileGrid grid;
    grid.replaceCells(stamp.width, stamp.height, stamp.cells);
    Json json = Json::object();
    json["tiles"] = tilesToJson(grid);
    return writeJson(json);
}

std::optional<TileStamp> tilesFromText(std::string_view text) {
    if (text.find("\"tiles\"") == std::string_view::npos) return std::nullopt;
    const Result<Json> json = parseJson(text, "clipboard");
    const Json* tiles = json ? findMember(*json, "tiles") : nullptr;
    if (tiles == nullptr) return std::nullopt;
    const Result<ReadTiles> read = tilesFromJson(*tiles);
    if (!read) return std::nullopt;
    const TileGrid& grid = read->grid;
    const std::int64_t count = std::int64_t{grid.width()} * grid.height();
    if (count == 0 || count > kMostCells) return std::nullopt;
    return TileStamp{grid.width(), grid.height(), grid.cells()};
}

}  // namespace plumb::editor
