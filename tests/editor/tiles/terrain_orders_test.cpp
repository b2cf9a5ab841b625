#include <cstdlib>
#include <utility>

#include <gtest/gtest.h>

#include "assets/autotile.hpp"
#include "core/random.hpp"
#include "editor/model/tiles/terrain_paint.hpp"
#include "tests/editor/support/terrain_set.hpp"

namespace plumb::editor {
namespace {

/// Number of stroke orders tried for each mode: the environment variable PLUMB_STROKES if set, otherwise 200.
unsigned strokeOrders() {
    const char* asked = std::getenv("PLUMB_STROKES");
    return asked == nullptr ? 200u : static_cast<unsigned>(std::strtoul(asked, nullptr, 10));
}

constexpr int kSide = 12;

/// A tile layer and its terrain, painted without undo steps.
struct Ground {
    TileGrid cells{kSide, kSide};
    TileGrid terrain{kSide, kSide};

    void paint(const Autotile& autotile, const std::vector<PaintTiles::Cell>& wanted) {
        const PaintTiles::Change change = terrainChange(cells, terrain, autotile, wanted);
        for (const PaintTiles::Cell& cell : change.terrain) terrain.set(cell.x, cell.y, cell.cell);
        for (const PaintTiles::Cell& cell : change.cells) cells.set(cell.x, cell.y, cell.cell);
    }
};

template <class T>
void shuffle(std::vector<T>& items, Random& random) {
    for (std::size_t i = items.size(); i > 1; --i)
        std::swap(items[i - 1], items[random.below(static_cast<std::uint32_t>(i))]);
}

class TerrainOrders : public testing::TestWithParam<TerrainMode> {};

TEST_P(TerrainOrders, theSameTerrainGivesTheSameTilesWhateverTheOrderOfStrokes) {
    const Tileset set = terrainSet(GetParam(), 2);
    const Autotile autotile{set};
    Random random = Random::seeded(11);
    std::vector<PaintTiles::Cell> target;
    for (int i = 0; i < kSide * kSide; ++i) target.push_back({i % kSide, i / kSide, random.below(3)});
    Ground expected;
    expected.paint(autotile, target);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x)
            ASSERT_EQ(expected.cells.at(x, y), autotile.cellAt(expected.terrain, x, y).value_or(0));
    }

    for (unsigned order = 0; order < strokeOrders(); ++order) {
        Ground ground;
        // Random earlier strokes, which must have no effect on the final tiles.
        for (std::uint32_t i = random.below(6); i > 0; --i) {
            const auto from = static_cast<int>(random.below(kSide));
            std::vector<PaintTiles::Cell> stroke;
            for (int x = from; x < kSide; ++x) stroke.push_back({x, from, random.below(3)});
            ground.paint(autotile, stroke);
        }
        shuffle(target, random);
        for (std::size_t at = 0; at < target.size();) {
            const std::size_t count = std::min<std::size_t>(1 + random.below(20), target.size() - at);
            const auto first = target.begin() + static_cast<std::ptrdiff_t>(at);
            ground.paint(autotile, {first, first + static_cast<std::ptrdiff_t>(count)});
            at += count;
        }
        ASSERT_EQ(ground.terrain, expected.terrain) << "order " << order;
        ASSERT_EQ(ground.cells, expected.cells) << "order " << order;
    }
}

INSTANTIATE_TEST_SUITE_P(Modes, TerrainOrders,
                         testing::Values(TerrainMode::Edges, TerrainMode::Blob, TerrainMode::Corners));

}  // namespace
}  // namespace plumb::editor
