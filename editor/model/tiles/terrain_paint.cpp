#include "editor/model/tiles/terrain_paint.hpp"

#include <algorithm>
#include <optional>

#include "editor/model/document/cell_selection.hpp"

namespace plumb::editor {
namespace {

/// A rectangular part of a layer's terrain before and after a change. Beyond the layer's border the terrain
/// of the border cells continues.
class TerrainPatch {
public:
    TerrainPatch(const TileGrid& terrain, CellPlace from, CellPlace to)
        : terrain_{terrain}, from_{from}, width_{to.x - from.x + 1}, height_{to.y - from.y + 1} {
        before_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
        for (int y = 0; y < height_; ++y) {
            for (int x = 0; x < width_; ++x)
                before_[slot(x + from.x, y + from.y)] =
                    static_cast<std::uint8_t>(terrain.at(x + from.x, y + from.y));
        }
        after_ = before_;
        touched_.resize(before_.size());
    }

    [[nodiscard]] std::uint8_t before(int x, int y) const { return before_[slot(x, y)]; }
    void set(int x, int y, std::uint8_t id) {
        after_[slot(x, y)] = id;
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                if (terrain_.has(x + dx, y + dy)) touched_[slot(x + dx, y + dy)] |= kBeside;
            }
        }
        touched_[slot(x, y)] |= kWanted;
    }

    /// Calls `visit(x, y, before, after, wanted)` for the cells whose tile may change: `before` and `after`
    /// are the tiles by autotiling, `wanted` is true for the painted cells.
    template <class Visit>
    void eachTouched(const Autotile& autotile, Visit visit) const {
        for (int y = from_.y; y < from_.y + height_; ++y) {
            for (int x = from_.x; x < from_.x + width_; ++x) {
                const std::uint8_t touched = touched_[slot(x, y)];
                if (touched == 0) continue;
                visit(x, y, autotile.cellFor(around(before_, x, y), x, y),
                      autotile.cellFor(around(after_, x, y), x, y), (touched & kWanted) != 0);
            }
        }
    }

private:
    static constexpr std::uint8_t kBeside = 1;
    static constexpr std::uint8_t kWanted = 2;

    [[nodiscard]] std::size_t slot(int x, int y) const {
        return static_cast<std::size_t>(y - from_.y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x - from_.x);
    }
    [[nodiscard]] Autotile::Around around(const std::vector<std::uint8_t>& ids, int x, int y) const {
        Autotile::Around found{};
        for (int i = 0; i < 9; ++i) {
            const int atX = std::clamp(x + i % 3 - 1, 0, terrain_.width() - 1);
            const int atY = std::clamp(y + i / 3 - 1, 0, terrain_.height() - 1);
            found[static_cast<std::size_t>(i)] = ids[slot(atX, atY)];
        }
        return found;
    }

    const TileGrid& terrain_;
    CellPlace from_;
    int width_;
    int height_;
    std::vector<std::uint8_t> before_;
    std::vector<std::uint8_t> after_;
    std::vector<std::uint8_t> touched_;
};

}  // namespace

PaintTiles::Change terrainChange(const TileGrid& cells, const TileGrid& terrain, const Autotile& autotile,
                                 std::span<const PaintTiles::Cell> wanted) {
    PaintTiles::Change change;
    std::optional<CellPlace> least;
    CellPlace most;
    for (const PaintTiles::Cell& cell : wanted) {
        if (!terrain.has(cell.x, cell.y)) continue;
        if (!least) least = most = {cell.x, cell.y};
        least = {std::min(least->x, cell.x), std::min(least->y, cell.y)};
        most = {std::max(most.x, cell.x), std::max(most.y, cell.y)};
    }
    if (!least) return change;
    // A change also affects the neighbours of a cell, and their tiles depend on the neighbours' neighbours.
    TerrainPatch patch{
        terrain,
        {std::max(least->x - 2, 0), std::max(least->y - 2, 0)},
        {std::min(most.x + 2, terrain.width() - 1), std::min(most.y + 2, terrain.height() - 1)}};
    for (const PaintTiles::Cell& cell : wanted) {
        if (!terrain.has(cell.x, cell.y)) continue;
        patch.set(cell.x, cell.y, static_cast<std::uint8_t>(cell.cell));
        if (patch.before(cell.x, cell.y) != cell.cell) change.terrain.push_back(cell);
    }
    patch.eachTouched(autotile, [&](int x, int y, std::optional<TileCell> before,
                                    std::optional<TileCell> after, bool isWanted) {
        if (before == after && !(isWanted && after)) return;
        const TileCell cell = after.value_or(0);
        if (cells.at(x, y) != cell) change.cells.push_back({x, y, cell});
    });
    return change;
}

PaintTiles::Change retiled(const TileGrid& cells, const TileGrid& terrain, const Autotile& autotile) {
    PaintTiles::Change change;
    for (int y = 0; y < cells.height(); ++y) {
        for (int x = 0; x < cells.width(); ++x) {
            const std::optional<TileCell> cell = autotile.cellAt(terrain, x, y);
            if (cell && *cell != cells.at(x, y)) change.cells.push_back({x, y, *cell});
        }
    }
    return change;
}

}  // namespace plumb::editor
