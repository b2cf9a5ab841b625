#include <algorithm>
#include <span>
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

// Writes are noted for blocks of 256 components, losses for blocks of 256 indices.
TEST(ChangesTest, onlyTheBlockOfAWrittenComponentCounts) {
    World world;
    std::vector<EntityId> ids(256 * 3);
    world.createEntities(std::span{ids}.first(256), Position{}, Velocity{});
    world.createEntities(std::span{ids}.subspan(256), Position{});
    const auto changedBlocks = [&](std::uint64_t mark) {
        std::vector<std::size_t> blocks;
        for (std::size_t i = 0; i < ids.size(); ++i) {
            if (world.changedSince<Position>(ids[i], mark) && (blocks.empty() || blocks.back() != i / 256))
                blocks.push_back(i / 256);
        }
        std::vector<EntityId> visited;
        world.eachChangedSince<Position>(mark, [&](EntityId id) { visited.push_back(id); });
        EXPECT_EQ(visited.size(), 256 * blocks.size());
        EXPECT_EQ(world.changedSince<Position>(mark), !blocks.empty());
        return blocks;
    };
    using Blocks = std::vector<std::size_t>;
    for (const std::size_t at : {0u, 255u, 256u, 511u, 512u, 767u}) {
        const std::uint64_t mark = world.markChanges();
        world.get<Position>(ids[at]).x = 1.0f;
        EXPECT_EQ(changedBlocks(mark), Blocks{at / 256}) << at;
    }
    const std::uint64_t mark = world.markChanges();
    EXPECT_EQ(changedBlocks(mark), Blocks{});
    world.each<Position, const Velocity>([](Position& position, const Velocity&) { position.x = 2.0f; });
    EXPECT_EQ(changedBlocks(mark), Blocks{0}) << "a loop over the entities of one block";
}

TEST(ChangesTest, componentsCreatedInOneCallAreWritten) {
    World world;
    std::vector<EntityId> before(256), ids(700);
    world.createEntities(before, Position{});
    const std::uint64_t mark = world.markChanges();
    world.createEntities(ids, Position{});
    for (const EntityId id : before) ASSERT_FALSE(world.changedSince<Position>(id, mark));
    for (const EntityId id : ids) ASSERT_TRUE(world.changedSince<Position>(id, mark)) << id.index;
}

TEST(ChangesTest, aLossIsReportedForTheIndicesOfItsBlock) {
    World world;
    fillWithMovers(world, 600);
    for (const std::uint32_t index : {1u, 255u, 256u, 257u, 511u, 512u, 600u}) {
        const std::uint64_t mark = world.markChanges();
        world.remove<Velocity>({index, 1});
        std::vector<std::uint32_t> expected;
        for (std::uint32_t other = 1; other <= 600; ++other) {
            if (other / 256 == index / 256) expected.push_back(other);
        }
        EXPECT_EQ(lossesSince(world, mark), expected) << index;
        EXPECT_TRUE(lossesSince(world, world.markChanges()).empty());
    }
}

}  // namespace
}  // namespace plumb
