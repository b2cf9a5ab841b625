#include "ecs/tile_store.hpp"

#include <set>
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

}  // namespace
}  // namespace plumb
