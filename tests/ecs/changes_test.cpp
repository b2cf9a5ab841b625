#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/ecs/parts.hpp"

namespace plumb {
namespace {

TEST(ChangesTest, writesAreDetectedAndReadsAreNot) {
    World world;
    fillWithMovers(world, 1000);
    const EntityId first{1, 1};
    const EntityId last{1000, 1};
    std::uint64_t mark = world.markChanges();
    EXPECT_FALSE(world.changedSince<Position>(mark));

    static_cast<void>(world.get<const Position>(first).x);
    for (auto [entity, position] : world.query<const Position>()) static_cast<void>(position.x);
    world.each<const Position, Velocity>([](const Position& p, Velocity& v) { v.x = p.x; });
    EXPECT_FALSE(world.changedSince<Position>(mark));
    EXPECT_TRUE(world.changedSince<Velocity>(mark));

    mark = world.markChanges();
    world.get<Position>(last).x = 1.0f;
    EXPECT_TRUE(world.changedSince<Position>(last, mark));
    EXPECT_FALSE(world.changedSince<Position>(first, mark)) << "in another block of memory";
    EXPECT_TRUE(world.changedSince<Position>(mark));
    EXPECT_FALSE(world.changedSince<Velocity>(mark));

    mark = world.markChanges();
    for (auto [entity, position] : world.query<Position>()) position.y = 1.0f;
    EXPECT_TRUE(world.changedSince<Position>(first, mark));

    mark = world.markChanges();
    world.destroy(EntityId{500, 1});
    EXPECT_TRUE(world.changedSince<Position>(last, mark)) << "moved into the gap of the destroyed one";
}

TEST(ChangesTest, addedAndRestoredComponentsCountAsChanged) {
    World world;
    fillWithMovers(world, 10);
    const Snapshot saved = world.save();
    std::uint64_t mark = world.markChanges();
    Entity e = world.createEntity();
    EXPECT_FALSE(world.changedSince<Position>(e, mark));
    e.addComponent<Position>();
    EXPECT_TRUE(world.changedSince<Position>(e, mark));
    mark = world.markChanges();
    world.restore(saved);
    EXPECT_TRUE(world.changedSince<Position>(EntityId{1, 1}, mark));
}

/// Returns the entity indices near which a component was removed since the mark.
std::vector<std::uint32_t> lossesSince(const World& world, std::uint64_t mark) {
    std::vector<std::uint32_t> indices;
    world.eachLossSince(mark, [&](EntityId id) { indices.push_back(id.index); });
    return indices;
}

bool contains(const std::vector<std::uint32_t>& indices, std::uint32_t index) {
    return std::find(indices.begin(), indices.end(), index) != indices.end();
}

TEST(ChangesTest, removalsAreReportedNearTheirEntity) {
    World world;
    fillWithMovers(world, 3000);
    const Snapshot saved = world.save();
    std::uint64_t mark = world.markChanges();
    world.get<Position>(EntityId{10, 1}).x = 1.0f;
    world.add<Position>(world.createEntity());
    EXPECT_TRUE(lossesSince(world, mark).empty()) << "writing and adding remove nothing";

    world.remove<Velocity>(EntityId{10, 1});
    EXPECT_TRUE(contains(lossesSince(world, mark), 10));
    EXPECT_FALSE(contains(lossesSince(world, mark), 2000)) << "in another block of memory";
    mark = world.markChanges();
    world.destroy(EntityId{2000, 1});
    EXPECT_TRUE(contains(lossesSince(world, mark), 2000));
    EXPECT_FALSE(contains(lossesSince(world, mark), 10));
    mark = world.markChanges();
    for (auto [entity, position] : world.query<const Position>()) {
        if (entity.id().index == 500) world.remove<Position>(entity);
    }
    EXPECT_TRUE(contains(lossesSince(world, mark), 500)) << "removed while a query loop ran";
    mark = world.markChanges();
    world.restore(saved);
    EXPECT_TRUE(contains(lossesSince(world, mark), 10)) << "restoring counts as removing";
    mark = world.markChanges();
    world.clear();
    EXPECT_EQ(lossesSince(world, mark).size(), 3000u);
}

TEST(ClusterTest, keepsEveryComponentWithItsEntity) {
    World world;
    fillWithMovers(world, 3000);
    int i = 0;
    for (auto [entity, position] : world.query<Position>()) {
        if (++i % 3 == 0) entity.removeComponent<Velocity>();
        if (i % 7 == 0) entity.addComponent<Frozen>();
        if (i % 11 == 0) entity.destroy();
    }
    const std::uint64_t before = world.hash();
    const std::size_t movers = world.query<Position, Velocity>().count();

    world.cluster();

    EXPECT_EQ(world.hash(), before);
    EXPECT_EQ((world.query<Position, Velocity>().count()), movers);
    for (auto [entity, position, velocity] : world.query<Position, Velocity>())
        ASSERT_EQ(position.x, velocity.y);
    int runs = 0;
    world.chunks<Position, Velocity>([&](std::size_t, Position*, Velocity*) { ++runs; });
    EXPECT_LE(runs, 2) << "one range with Frozen, one without";
}

TEST(ClusterTest, smallWorldsAreClusteredAutomatically) {
    World world;
    fillWithMovers(world, 2000);
    for (std::uint32_t index = 1; index <= 2000; index += 2) world.remove<Velocity>(EntityId{index, 1});
    for (int tick = 0; tick < 2; ++tick) world.beginTick();
    int runs = 0;
    world.chunks<const Position, const Velocity>(
        [&](std::size_t, const Position*, const Velocity*) { ++runs; });
    EXPECT_EQ(runs, 1);
}

TEST(ChangesTest, onlyBlocksThatWereWrittenAreVisited) {
    World world;
    fillWithMovers(world, 1000);
    const EntityId last{1000, 1};
    const std::uint64_t mark = world.markChanges();
    std::vector<EntityId> visited;
    const auto look = [&] {
        visited.clear();
        world.eachChangedSince<Position>(mark, [&](EntityId id) { visited.push_back(id); });
    };
    look();
    EXPECT_TRUE(visited.empty());
    world.get<Position>(last).x = 1.0f;
    look();
    EXPECT_NE(std::find(visited.begin(), visited.end(), last), visited.end());
    EXPECT_LT(visited.size(), 500u);
    for (auto [entity, position] : world.query<Position>()) position.x = 2.0f;
    look();
    EXPECT_EQ(visited.size(), 1000u);
}

TEST(ChangesTest, theMembershipCounterIncreasesWithEveryAddAndRemove) {
    World world;
    fillWithMovers(world, 10);
    std::uint64_t before = world.memberships<Position, Velocity>();
    const auto grew = [&] {
        const std::uint64_t now = world.memberships<Position, Velocity>();
        return now > std::exchange(before, now);
    };
    world.get<Position>(EntityId{1, 1}).x = 3.0f;
    EXPECT_FALSE(grew()) << "writing a field adds no component";
    world.remove<Velocity>(EntityId{1, 1});
    EXPECT_TRUE(grew());
    world.add<Velocity>(EntityId{1, 1});
    EXPECT_TRUE(grew());
    world.destroy(EntityId{10, 1});
    EXPECT_TRUE(grew());
}

}  // namespace
}  // namespace plumb
