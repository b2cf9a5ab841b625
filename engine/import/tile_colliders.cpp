#include "import/tile_colliders.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "import/tile_shapes.hpp"
#include "import/tiled_json.hpp"

namespace plumb {
namespace {

using tiled::Gid;

constexpr int kMaxColliders = 1 << 14;        // of one import; each is an entity
constexpr std::size_t kMaxCorners = 1 << 17;  // of all colliders of one import
using Lines = std::vector<CollisionLine>;

/// Applies the flips of a cell to a point of a tile. @return px from the lower left corner of the drawn tile
Vec2 flipped(Vec2 point, Vec2 size, Gid flags) {
    if ((flags & tiled::kFlipDiagonal) != 0) {
        std::swap(point.x, point.y);
        std::swap(size.x, size.y);
    }
    if ((flags & tiled::kFlipX) != 0) point.x = size.x - point.x;
    if ((flags & tiled::kFlipY) != 0) point.y = size.y - point.y;
    return {point.x, point.y - size.y};
}

class ColliderCollector {
public:
    ColliderCollector(const EntityImport& import, const tiled::Layer& layer, std::string key)
        : import_{import}, layer_{layer}, key_{std::move(key)} {}

    void add(Vec2 offset) {
        bool opened = false;
        for (std::size_t i = 0; i < layer_.cells.size(); ++i) {
            if (layer_.cells[i] == 0) continue;
            const Lines& lines = linesOf(layer_.cells[i]);
            if (lines.empty()) continue;
            if (!std::exchange(opened, true))
                import_.draft.open(key_ + "/colliders", layer_.name + " colliders", offset);
            const auto width = static_cast<std::size_t>(layer_.width);
            addCell(lines, layer_.x + static_cast<int>(i % width), layer_.y + static_cast<int>(i / width));
        }
        if (!opened) return;
        import_.draft.close();
        import_.draft.report.note(
            "tiles collide by colliders below an entity of their layer; tiles painted later have none");
        if (leftOut_ > 0) tellLeftOut();
    }

private:
    /// Returns the shapes of a tile, px from the lower left corner of its cell.
    const Lines& linesOf(Gid gid) {
        const auto [at, isNew] = known_.try_emplace(gid);
        if (isNew) at->second = makeLines(import_.map.resolve(gid));
        return at->second;
    }

    [[nodiscard]] Lines makeLines(const tiled::TileRef& ref) const {
        if (ref.empty()) return {};
        const ImportedTileset& tileset = import_.tilesets[static_cast<std::size_t>(ref.tileset)];
        const tiled::Tileset& original = *tileset.original;
        const tiled::Tile* tile = original.find(ref.id);
        const bool isBeyond = tileset.count > 0 && ref.id >= tileset.count;  // has no cell either
        if (tile == nullptr || isBeyond) return {};
        const Vec2 size = tileset.sizeOf(ref.id);
        const Vec2 scale = tileset.scaleIn(import_.map, ref.id);
        const Vec2 offset{static_cast<float>(original.offsetX), static_cast<float>(original.offsetY)};
        Lines lines = collisionLinesOf(*tile, original, size.y);
        for (CollisionLine& line : lines) {
            for (Vec2& point : line.points)
                point = flipped(scaled(point, scale), scaled(size, scale), ref.flags) + scaled(offset, scale);
        }
        return lines;
    }

    void addCell(const Lines& lines, int column, int row) {
        const Vec2 place{static_cast<float>(column) * static_cast<float>(import_.map.tileWidth),
                         static_cast<float>(row + 1) * static_cast<float>(import_.map.tileHeight)};
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const std::string key = format("{}/collider {} {} {}", key_, column, row, i);
            if (lines[i].closed) {
                addEntity(key, place, "PolygonCollider", lines[i].points);
                continue;
            }
            // A chain is solid on one side only.
            addEntity(key, place, "ChainCollider", lines[i].points);
            addEntity(key + " back", place, "ChainCollider",
                      {lines[i].points.rbegin(), lines[i].points.rend()});
        }
    }

    void addEntity(const std::string& key, Vec2 place, const char* collider,
                   const std::vector<Vec2>& points) {
        SceneDraft& draft = import_.draft;
        if (draft.report.colliders == kMaxColliders || draft.colliderCorners + points.size() > kMaxCorners) {
            ++leftOut_;
            return;
        }
        ++draft.report.colliders;
        draft.colliderCorners += points.size();
        Json components = Json::object();
        components["Transform"] = transformJson(place, 0.0f, {1.0f, 1.0f});
        for (const Vec2 point : points) components[collider]["points"].push_back(vec2Json(point));
        draft.add(key, "collider", std::move(components));
    }

    void tellLeftOut() {
        import_.draft.report.problems.push_back(
            {format("layer {}", layer_.name),
             format("{} colliders of its tiles were left out, since an import may have {} with {} corners",
                    leftOut_, kMaxColliders, kMaxCorners),
             "draw large solid areas as objects of the map instead of a collision shape in every tile"});
    }

    const EntityImport& import_;
    const tiled::Layer& layer_;
    std::string key_;
    std::map<Gid, Lines> known_;
    int leftOut_ = 0;
};

}  // namespace

void addTileColliders(const EntityImport& import, const tiled::Layer& layer, const LayerPlacement& place,
                      const std::string& key) {
    ColliderCollector{import, layer, key}.add(place.offset);
}

}  // namespace plumb
