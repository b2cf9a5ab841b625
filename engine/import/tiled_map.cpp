#include "import/tiled_map.hpp"

#include <algorithm>
#include <iterator>

namespace plumb::tiled {
namespace {

constexpr std::string_view kOrientations[] = {"orthogonal", "isometric", "staggered", "hexagonal"};

}  // namespace

std::string_view nameOf(Orientation orientation) {
    return kOrientations[static_cast<std::size_t>(orientation)];
}

std::optional<Orientation> orientationNamed(std::string_view name) {
    const auto found = std::find(std::begin(kOrientations), std::end(kOrientations), name);
    if (found == std::end(kOrientations)) return std::nullopt;
    return static_cast<Orientation>(found - std::begin(kOrientations));
}

const Tile* Tileset::find(int id) const {
    const auto at = std::lower_bound(tiles.begin(), tiles.end(), id,
                                     [](const Tile& tile, int wanted) { return tile.id < wanted; });
    return at != tiles.end() && at->id == id ? &*at : nullptr;
}

TileRef Map::resolve(Gid gid) const {
    const Gid number = gid & ~kFlags;
    TileRef found;
    for (std::size_t i = 0; number != 0 && i < tilesets.size(); ++i) {
        const Gid first = tilesets[i].firstGid;
        if (first == 0 || first > number) continue;
        if (found.empty() || tilesets[static_cast<std::size_t>(found.tileset)].firstGid < first) {
            found = {static_cast<int>(i), static_cast<int>(number - first), gid & kFlags};
        }
    }
    return found;
}

}  // namespace plumb::tiled
