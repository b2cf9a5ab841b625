#include "ecs/tile_store.hpp"

#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/ecs/parts.hpp"

namespace plumb {
namespace {

Entity addLayer(World& world, int side = 4) {
    Entity entity = world.createEntity();
    entity.addComponent<Tiled>().cells = world.tiles().add(TileGrid{side, side});
    return entity;
}

TEST(TileStore, aGridIsRemovedWithTheEntityThatReferencesIt) {
    World world;
    Entity first = addLayer(world);
    const Entity second = addLayer(world);
    const TilesId gone = first.get<Tiled>().cells;
    first.destroy();
    EXPECT_EQ(world.tiles().size(), 2u) << "removed only when the next tick begins";

    world.beginTick();

    EXPECT_EQ(world.tiles().size(), 1u);
    EXPECT_EQ(world.tiles().find(gone), nullptr);
    EXPECT_NE(world.tiles().find(second.get<Tiled>().cells), nullptr);
}

TEST(TileStore, aGridWithTwoReferencesStaysUntilBothAreRemoved) {
    World world;
    Entity first = addLayer(world);
    Entity second = world.createEntity();
    second.addComponent<Tiled>().cells = first.get<Tiled>().cells;
    first.destroy();
    world.beginTick();
    EXPECT_EQ(world.tiles().size(), 1u);
    second.removeComponent<Tiled>();
    world.beginTick();
    EXPECT_EQ(world.tiles().size(), 0u);
}

TEST(TileStore, gridIdsAreNeverReused) {
    World world;
    Entity first = addLayer(world);
    const TilesId name = first.get<Tiled>().cells;
    first.destroy();
    world.beginTick();
    EXPECT_NE(addLayer(world).get<Tiled>().cells, name);
}

/// Returns the number of different grids that components reference.
std::size_t named(const World& world) {
    std::set<std::uint32_t> names;
    for (auto [entity, layer] : world.query<const Tiled>(withPaused)) {
        if (layer.cells.value != 0) names.insert(layer.cells.value);
    }
    return names.size();
}

TEST(TileStoreProperty, theNumberOfGridsEqualsTheNumberOfReferencedOnes) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        World world;
        std::vector<Snapshot> snapshots;
        std::vector<std::uint64_t> hashes;
        for (int step = 0; step < 300; ++step) {
            const std::vector<EntityId> all = world.entities();
            const EntityId some =
                all.empty() ? EntityId{} : all[random.below(static_cast<std::uint32_t>(all.size()))];
            switch (random.below(9)) {
                case 0:
                case 1: addLayer(world, 1 + static_cast<int>(random.below(5))); break;
                case 2: world.destroy(some); break;
                case 3: world.remove<Tiled>(some); break;
                case 4:
                    if (world.alive(some)) world.add<Tiled>(some).cells = world.tiles().add(TileGrid{2, 2});
                    break;
                case 5:
                    if (const Tiled* layer = std::as_const(world).find<Tiled>(some)) {
                        if (TileGrid* grid = world.tiles().edit(layer->cells))
                            grid->set(0, 0, random.below(9));
                        world.createEntity().addComponent<Tiled>(*layer);
                    }
                    break;
                case 6:
                    if (world.alive(some)) world.add<Paused>(some);
                    break;
                case 7:
                    world.beginTick();
                    snapshots.push_back(world.save());
                    hashes.push_back(world.hash());
                    break;
                default:
                    if (snapshots.empty()) break;
                    const std::size_t which = random.below(static_cast<std::uint32_t>(snapshots.size()));
                    world.restore(snapshots[which]);
                    ASSERT_EQ(world.hash(), hashes[which]);
                    ASSERT_EQ(world.tiles().size(), named(world)) << "right after a restore";
            }
            world.beginTick();
            ASSERT_EQ(world.tiles().size(), named(world)) << "step " << step;
            for (auto [entity, layer] : std::as_const(world).query<const Tiled>(withPaused)) {
                ASSERT_EQ(world.tiles().find(layer.cells) != nullptr, layer.cells.value != 0);
            }
        }
    }
}

TEST(TileStore, assigningAStoreUpdatesLargeGridsInBothDirections) {
    TileStore store;
    const TilesId id = store.add(TileGrid{2048, 2048});
    TileStore copy = store;
    for (int round = 0; round < 20; ++round) {
        TileGrid* grid = store.edit(id);
        for (int i = 0; i < 30; ++i)
            grid->set((round * 97 + i * 31) % 2048, (round * 53 + i) % 2048, 1 + i % 3);
        const TileGrid before = *copy.find(id);
        copy = store;
        ASSERT_EQ(*copy.find(id), *store.find(id)) << round;
        EXPECT_EQ(copy.find(id)->chunk(0, 0), store.find(id)->chunk(0, 0)) << "both must share the chunk";
        grid->set(round, 2047, 7);  // within the same edit; must not change the copy
        EXPECT_EQ(copy.find(id)->at(round, 2047), before.at(round, 2047));
        copy = store;
        ASSERT_EQ(copy.find(id)->at(round, 2047), 7u);
        Hasher one, other;
        store.addTo(one), copy.addTo(other);
        ASSERT_EQ(one.value(), other.value());
    }
    const TileStore past = copy;
    store.edit(id)->set(1000, 1000, 5);
    store = past;
    EXPECT_EQ(*store.find(id), *past.find(id));
}

std::uint64_t hashOf(const TileStore& store) {
    Hasher hasher;
    store.addTo(hasher);
    return hasher.value();
}

/// The hash of a store with one grid, filled by a function.
template <class Fill>
std::uint64_t hashOfGrid(int width, int height, Fill&& fill) {
    TileStore store;
    TileGrid grid{width, height};
    fill(grid);
    store.add(std::move(grid));
    return hashOf(store);
}

// Grids of up to 65,536 cells and larger ones are hashed in two ways.
TEST(TileStoreHash, dependsOnTheSizeAndOnEveryCell) {
    const auto nothing = [](TileGrid&) {};
    std::set<std::uint64_t> hashes;
    std::size_t count = 0;
    for (const auto& [width, height] : {std::pair{2, 8},
                                        {4, 4},
                                        {4, 5},
                                        {256, 255},
                                        {256, 256},
                                        {256, 257},
                                        {257, 256},
                                        {300, 300},
                                        {300, 301},
                                        {600, 150},
                                        {40, 3000}}) {
        const std::uint64_t empty = hashOfGrid(width, height, nothing);
        hashes.insert(empty), ++count;
        for (const auto& [x, y] : {std::pair{0, 0},
                                   {width - 1, 0},
                                   {0, height - 1},
                                   {width - 1, height - 1},
                                   {width / 2, height / 2}}) {
            const auto setOne = [x = x, y = y](TileGrid& grid) { grid.set(x, y, 1); };
            const auto setTwo = [x = x, y = y](TileGrid& grid) { grid.set(x, y, 2); };
            const auto setBack = [x = x, y = y](TileGrid& grid) { grid.set(x, y, 1), grid.set(x, y, 0); };
            hashes.insert(hashOfGrid(width, height, setOne)), ++count;
            hashes.insert(hashOfGrid(width, height, setTwo)), ++count;
            EXPECT_EQ(hashOfGrid(width, height, setBack), empty) << "only a history";
        }
    }
    EXPECT_EQ(hashes.size(), count);
}

TEST(TileStoreHash, seesEveryChangeSinceTheLastCall) {
    TileStore store;
    const TilesId id = store.add(TileGrid{4, 4});
    const std::uint64_t empty = hashOf(store);
    TileGrid* grid = store.edit(id);
    grid->set(1, 1, 5);
    const std::uint64_t one = hashOf(store);
    EXPECT_NE(one, empty);
    grid->set(2, 1, 5);  // within the same edit
    EXPECT_NE(hashOf(store), one);
    grid->set(2, 1, 0);
    EXPECT_EQ(hashOf(store), one);
    *store.edit(id) = TileGrid{4, 4};  // another grid, whose version is that of a new one
    EXPECT_EQ(hashOf(store), empty);
    *store.edit(id) = TileGrid{4, 5};
    EXPECT_NE(hashOf(store), empty);
    *store.edit(id) = TileGrid{4, 4};
    EXPECT_EQ(hashOf(store), empty);
    store.add(TileGrid{4, 4});
    const std::uint64_t two = hashOf(store);
    EXPECT_NE(two, empty);
    store.remove(id);
    EXPECT_NE(hashOf(store), empty) << "the remaining grid has another id";
}

/// A store and what it must contain.
struct ModelledStore {
    TileStore store;
    std::map<std::uint32_t, std::vector<TileCell>> cells;

    void expectSame() const {
        ASSERT_EQ(store.size(), cells.size());
        for (const auto& [id, expected] : cells) {
            const TileGrid* grid = store.find({id});
            ASSERT_NE(grid, nullptr);
            ASSERT_EQ(grid->cells(), expected) << id;
        }
    }
};

TEST(TileStoreProperty, assignedStoresAreEqualAndIndependent) {
    constexpr std::pair<int, int> kSizes[] = {{3, 4}, {270, 260}, {260, 270}, {260, 260}, {270, 300}};
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        ModelledStore stores[3];
        for (int step = 0; step < 120; ++step) {
            ModelledStore& some = stores[random.below(3)];
            const auto& [width, height] = kSizes[random.below(std::size(kSizes))];
            const std::uint32_t what = random.below(10);
            if (what < 2) {
                const TilesId id = some.store.add(TileGrid{width, height});
                some.cells[id.value] = TileGrid{width, height}.cells();
            } else if (what < 5) {
                const ModelledStore& other = stores[random.below(3)];
                some.store = other.store;
                some.cells = other.cells;
                ASSERT_EQ(hashOf(some.store), hashOf(other.store));
            } else if (!some.cells.empty()) {
                auto at = some.cells.begin();
                std::advance(at, random.below(static_cast<std::uint32_t>(some.cells.size())));
                if (what == 5) {
                    some.store.remove({at->first});
                    some.cells.erase(at);
                } else {
                    TileGrid* grid = some.store.edit({at->first});
                    if (what == 6) *grid = TileGrid{width, height};
                    const auto x = static_cast<int>(random.below(static_cast<std::uint32_t>(grid->width())));
                    const auto y = static_cast<int>(random.below(static_cast<std::uint32_t>(grid->height())));
                    grid->set(x, y, 1 + random.below(3));
                    at->second = grid->cells();
                }
            }
            if (step % 10 != 0) continue;
            for (const ModelledStore& each : stores) each.expectSame();
            if (HasFatalFailure()) return;
        }
    }
}

struct OnlyTiles {
    TilesId cells;

    static void describe(TypeBuilder<OnlyTiles>& type) {
        type.name("OnlyTiles");
        type.field<&OnlyTiles::cells>("cells");
    }
};

TEST(TileStore, aGridIsKeptByAComponentOfNothingElse) {
    World world;
    const TilesId kept = world.tiles().add(TileGrid{4, 4});
    const TilesId gone = world.tiles().add(TileGrid{4, 4});
    world.createEntity().addComponent<OnlyTiles>().cells = kept;
    world.createEntity().addComponent<Position>();
    world.beginTick();
    EXPECT_NE(world.tiles().find(kept), nullptr);
    EXPECT_EQ(world.tiles().find(gone), nullptr);
}

TEST(TileStore, unknownIdsAreFoundEditedRemovedAndMarkedInVain) {
    TileStore store;
    const TilesId ids[] = {store.add(TileGrid{1, 1}), store.add(TileGrid{2, 1}), store.add(TileGrid{3, 1})};
    store.remove(ids[1]);
    for (const TilesId none : {TilesId{}, ids[1], TilesId{4}}) {
        EXPECT_EQ(store.find(none), nullptr);
        EXPECT_EQ(store.edit(none), nullptr);
        store.remove(none);
    }
    EXPECT_EQ(store.size(), 2u);
    EXPECT_EQ(store.find(ids[0])->width(), 1);
    EXPECT_EQ(store.find(ids[2])->width(), 3);
    store.unmarkAll();
    store.mark(ids[2]);
    store.mark(ids[1]);
    store.dropUnmarked();
    EXPECT_EQ(store.size(), 1u);
    EXPECT_NE(store.find(ids[2]), nullptr);
    store.unmarkAll();
    store.dropUnmarked();
    EXPECT_EQ(store.size(), 0u);
    EXPECT_EQ(store.add(TileGrid{1, 1}).value, 4u);
}

}  // namespace
}  // namespace plumb
