#include "ecs/snapshot.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "ecs/hierarchy.hpp"
#include "tests/ecs/parts.hpp"

namespace plumb {
namespace {

struct Score {
    int coins = 0;
    std::vector<int> best;

    void addTo(Hasher& hasher) const { hasher.add(static_cast<std::uint64_t>(coins)); }
};
struct Unhashed {
    int value = 0;
};

std::vector<EntityId> orderOf(World& world) {
    std::vector<EntityId> order;
    for (auto [entity, position] : world.query<const Position>()) order.push_back(entity);
    return order;
}

TEST(SnapshotTest, restoresTheOrderAndTheNextIds) {
    World world;
    fillWithMovers(world, 100);
    for (const std::uint32_t index : {5u, 50u, 7u}) world.destroy(EntityId{index, 1});
    const std::vector<EntityId> before = orderOf(world);
    const Snapshot saved = world.save();
    const EntityId next = world.createEntity();

    fillWithMovers(world, 10);
    world.destroy(EntityId{20, 1});
    world.restore(saved);

    EXPECT_EQ(orderOf(world), before);
    EXPECT_EQ(world.entityCount(), 97u);
    EXPECT_FALSE(world.alive(next)) << "handles from after the snapshot are stale";
    EXPECT_EQ(world.createEntity().id(), next);
}

TEST(SnapshotTest, restoringKeepsOldHandlesAndMakesNewerOnesStale) {
    World world;
    Entity kept = world.createEntity();
    kept.addComponent<Position>(1.0f, 0.0f);
    const Snapshot saved = world.save();
    Entity late = world.createEntity();
    late.addComponent<Position>(9.0f, 0.0f);
    kept.destroy();

    world.restore(saved);

    EXPECT_TRUE(kept.alive());
    EXPECT_EQ(kept.get<Position>().x, 1.0f);
    EXPECT_FALSE(late.alive());
    EXPECT_EQ(late.find<Position>(), nullptr);
}

TEST(SnapshotTest, restoresResourcesTilesAndTick) {
    World world;
    world.resource<Score>().coins = 3;
    const TilesId tiles = world.tiles().add(TileGrid{4, 4});
    world.createEntity().addComponent<Tiled>().cells = tiles;
    world.tiles().edit(tiles)->set(1, 1, 7);
    world.beginTick();
    const Snapshot saved = world.save();
    const std::uint64_t hash = world.hash();

    world.resource<Score>().coins = 4;
    world.resource<Score>().best = {1, 2};
    world.resource<Unhashed>().value = 5;
    world.tiles().edit(tiles)->set(1, 1, 8);
    world.beginTick();
    EXPECT_NE(world.hash(), hash);
    world.restore(saved);

    EXPECT_EQ(world.resource<Score>().coins, 3);
    EXPECT_TRUE(world.resource<Score>().best.empty());
    EXPECT_EQ(world.findResource<Unhashed>(), nullptr) << "not yet added when the snapshot was taken";
    EXPECT_EQ(world.tiles().find(tiles)->at(1, 1), 7u);
    EXPECT_EQ(world.tick, 1u);
    EXPECT_EQ(world.hash(), hash);
}

TEST(SnapshotTest, canBeRestoredInAnotherWorld) {
    World world;
    fillWithMovers(world, 50);
    Entity parent = world.createEntity();
    Entity child = world.createEntity();
    setParent(world, child, parent);
    const TextId text = world.texts().add("hello");
    const Snapshot saved = world.save();

    World other;  // a world in which other types were used in another order
    other.createEntity().addComponent<Health>();
    other.createEntity().addComponent<Velocity>();
    EXPECT_EQ(other.query<Velocity>(without<Health>).count(), 1u);
    other.restore(saved);

    EXPECT_EQ(other.hash(), world.hash());
    EXPECT_EQ(other.texts().find(text), "hello");
    EXPECT_EQ(other.count<Health>(), 0u);
    EXPECT_EQ(other.query<Velocity>(without<Health>).count(), 50u);
    EXPECT_EQ(parentOf(other, child.id()).id(), parent.id());
    other.destroy(parent);
    EXPECT_FALSE(other.alive(child));
    EXPECT_TRUE(world.alive(child));
}

TEST(SnapshotTest, aReusedSnapshotEqualsANewOne) {
    World world;
    Snapshot saved;
    for (int round = 0; round < 5; ++round) {
        fillWithMovers(world, 100 * round);
        world.save(saved);
        const std::uint64_t hash = world.hash();
        fillWithMovers(world, 30);
        world.restore(saved);
        EXPECT_EQ(world.hash(), hash);
    }
    world.clear();
    world.save(saved);
    EXPECT_LT(saved.byteCount(), 100000u);
    fillWithMovers(world, 3);
    world.restore(saved);
    EXPECT_EQ(world.entityCount(), 0u);
}

TEST(SnapshotTest, tilesOfDifferentBranchesAreNotMixedUp) {
    World world;
    const TilesId id = world.tiles().add(TileGrid{2, 2});
    const Snapshot start = world.save();
    world.tiles().edit(id)->set(0, 0, 1);
    const Snapshot one = world.save();
    world.restore(start);
    world.tiles().edit(id)->set(0, 0, 2);
    const Snapshot two = world.save();

    world.restore(one);
    EXPECT_EQ(world.tiles().find(id)->at(0, 0), 1u);
    world.restore(two);
    EXPECT_EQ(world.tiles().find(id)->at(0, 0), 2u);
    world.restore(start);
    EXPECT_EQ(world.tiles().find(id)->at(0, 0), 0u);
}

TEST(HashTest, dependsOnlyOnTheState) {
    World straight;
    World winding;
    std::vector<Entity> a;
    std::vector<Entity> b;
    for (int i = 0; i < 500; ++i) {
        a.push_back(straight.createEntity());
        b.push_back(winding.createEntity());
    }
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    for (int i = 0; i < 500; ++i) {
        if (i % 3 != 0) a[at(i)].addComponent<Position>(static_cast<float>(i), 0.0f);
        if (i % 2 != 0) a[at(i)].addComponent<Velocity>(static_cast<float>(i), 0.0f);
    }
    for (int round = 0; round < 3; ++round) {
        for (int i = 499; i >= 0; --i) {
            if (i % 2 != 0) b[at(i)].removeComponent<Velocity>();
            if (i % 2 != 0) b[at(i)].addComponent<Velocity>(static_cast<float>(i), 0.0f);
            if (i % 3 != 0) b[at(i)].removeComponent<Position>();
            if (i % 3 != 0) b[at(i)].addComponent<Position>(static_cast<float>(i), -0.0f);
        }
    }
    winding.createEntity().destroy();
    b[0].addComponent<Health>();
    b[0].removeComponent<Health>();
    EXPECT_EQ(straight.hash(), winding.hash());

    straight.cluster();
    winding.cluster();
    EXPECT_EQ(straight.hash(), winding.hash());
    EXPECT_EQ(orderOf(straight), orderOf(winding)) << "clustering makes the order independent of history";

    b[1].get<Position>().x += 0.5f;
    EXPECT_NE(straight.hash(), winding.hash());
}

TEST(DeterminismTest, theSameOperationsYieldTheSameOrderAndHash) {
    int born = 0;
    int gone = 0;
    const auto play = [&](World& world) {
        fillWithMovers(world, 400);
        for (int tick = 0; tick < 60; ++tick) {
            world.beginTick();
            for (auto [entity, position, velocity] : world.query<Position, Velocity>()) {
                position.x += velocity.x * 0.25f;
                if (static_cast<int>(position.x + velocity.y) % 37 == 0) {
                    world.createEntity().addComponent<Position>(position);
                    entity.removeComponent<Velocity>();
                    ++born;
                } else if (static_cast<int>(velocity.y) % 50 == tick) {
                    entity.destroy();
                    ++gone;
                }
            }
        }
    };
    World first;
    World second;
    EXPECT_TRUE(second.query<Health>().empty());  // another order of first use
    play(first);
    play(second);

    ASSERT_GT(born, 20);
    ASSERT_GT(gone, 20);
    EXPECT_EQ(first.hash(), second.hash());
    EXPECT_EQ(orderOf(first), orderOf(second));
}

TEST(SnapshotTest, resourcesComeAndGoWithTheSnapshots) {
    World world;
    const Snapshot none = world.save();
    world.resource<Score>() = {3, {1, 2}};
    world.resource<Unhashed>().value = 4;
    const Snapshot both = world.save();
    const std::uint64_t hash = world.hash();
    World other;
    other.resource<Unhashed>().value = 9;
    for (World* each : {&world, &other}) {
        for (int round = 0; round < 2; ++round) {
            each->restore(none);
            EXPECT_EQ(each->findResource<Score>(), nullptr);
            EXPECT_EQ(each->findResource<Unhashed>(), nullptr);
            EXPECT_NE(each->hash(), hash);
            each->restore(both);
            ASSERT_NE(each->findResource<Score>(), nullptr);
            ASSERT_NE(each->findResource<Unhashed>(), nullptr);
            EXPECT_EQ(each->findResource<Score>()->coins, 3);
            EXPECT_EQ(each->findResource<Score>()->best, (std::vector<int>{1, 2}));
            EXPECT_EQ(each->findResource<Unhashed>()->value, 4);
            EXPECT_EQ(each->hash(), hash);
        }
        each->restore(none);
        EXPECT_EQ(each->resource<Score>().coins, 0) << "created again with its defaults";
        EXPECT_TRUE(each->resource<Score>().best.empty());
    }
}

TEST(SnapshotTest, aSnapshotHasTheTickAndItsOwnTexts) {
    World world;
    const TextId text = world.texts().add("before");
    for (int i = 0; i < 3; ++i) world.beginTick();
    Snapshot saved = world.save();
    EXPECT_EQ(saved.tick(), 3u);
    EXPECT_GT(saved.byteCount(), 0u);
    EXPECT_EQ(Snapshot{}.byteCount(), 0u);
    const TextId late = world.texts().add("after");
    World other;
    other.restore(saved);
    EXPECT_EQ(other.tick, 3u);
    EXPECT_EQ(other.texts().find(text), "before");
    EXPECT_NE(other.texts().find(late), "after");
    world.save(saved);
    other.restore(saved);
    EXPECT_EQ(other.texts().find(late), "after");
}

}  // namespace
}  // namespace plumb
