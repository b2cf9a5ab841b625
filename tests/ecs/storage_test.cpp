#include "ecs/storage.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/ecs/parts.hpp"
#include "tests/support/faults.hpp"

namespace plumb {
namespace {

std::vector<std::uint32_t> orderOf(World& world) {
    std::vector<std::uint32_t> order;
    for (auto [entity, position] : world.query<const Position>(withPaused))
        order.push_back(entity.id().index);
    return order;
}

// Each array of a pool has its own part of an address range, whose size is that of the largest world.
TEST(StorageTest, theArraysOfALargeWorldDoNotOverlap) {
    constexpr std::uint32_t kCount = 600'000;
    World world;
    std::vector<EntityId> ids(kCount);
    world.createEntities(ids, Numbered<0>{}, Frozen{});
    world.each<Numbered<0>>(
        [](EntityId id, Numbered<0>& number) { number.value = static_cast<int>(id.index); });
    std::uint32_t seen = 0;
    world.each<const Numbered<0>>([&](EntityId id, const Numbered<0>& number) {
        seen += id.index == seen + 1 && number.value == static_cast<int>(id.index) ? 1 : 0;
    });
    EXPECT_EQ(seen, kCount);
    for (std::uint32_t index = 1; index <= kCount; index += 4999) {
        ASSERT_TRUE(world.has<Frozen>({index, 1}));
        ASSERT_EQ((std::as_const(world).get<Numbered<0>>({index, 1}).value), static_cast<int>(index));
    }
    EXPECT_FALSE(world.has<Frozen>({kCount + 1, 1}));
}

TEST(StorageTest, entitiesAreNumberedFromOneAlsoBeyondTheFirstBlockOfMemory) {
    for (const std::uint32_t count : {1u, 16'382u, 16'383u, 16'384u, 16'385u, 70'000u}) {
        SCOPED_TRACE(count);
        World one;
        World many;
        std::vector<EntityId> ids(count);
        many.createEntities(ids, Frozen{});
        for (std::uint32_t i = 0; i < count; ++i) {
            ASSERT_EQ(one.createEntity().id(), (EntityId{i + 1, 1}));
            ASSERT_EQ(ids[i], (EntityId{i + 1, 1}));
        }
        EXPECT_EQ(many.entityCount(), count);
        EXPECT_TRUE(many.alive(ids.back()));
        EXPECT_FALSE(many.alive({count + 1, 1}));
        EXPECT_EQ(many.createEntity().id(), (EntityId{count + 1, 1}));
    }
}

TEST(StorageTest, aClearedWorldNumbersItsEntitiesAsANewOneAndKeepsOldHandlesStale) {
    for (const int filled : {3, 40, 5000}) {  // few and many components for the entities that were used
        SCOPED_TRACE(filled);
        World world;
        fillWithMovers(world, filled);
        for (int i = filled; i < 5000; ++i) world.createEntity();
        std::vector<EntityId> before = world.entities();
        for (std::size_t i = 0; i < 5000; i += 7) world.destroy(before[i]);
        for (int i = 0; i < 100; ++i) before.push_back(world.createEntity().id());

        world.clear();
        world.clear();

        EXPECT_EQ(world.entityCount(), 0u);
        EXPECT_TRUE(world.entities().empty());
        std::sort(before.begin(), before.end());
        for (const EntityId id : before) {
            ASSERT_FALSE(world.alive(id));
            ASSERT_FALSE(world.has<Position>(id));
        }
        for (std::uint32_t i = 1; i <= 5001; ++i) {
            const Entity entity = world.createEntity();
            ASSERT_EQ(entity.id().index, i);
            ASSERT_FALSE(entity.hasComponent<Position>());
            ASSERT_FALSE(std::binary_search(before.begin(), before.end(), entity.id()));
        }
        EXPECT_EQ(world.entityCount(), 5001u);
        EXPECT_EQ(world.count<Velocity>(), 0u);
    }
}

TEST(StorageTest, theIndexFreedLastIsUsedFirst) {
    World world;
    fillWithMovers(world, 10);
    for (const std::uint32_t index : {3u, 9u, 5u}) world.destroy({index, 1});
    for (const EntityId expected : {EntityId{5, 3}, EntityId{9, 3}, EntityId{3, 3}, EntityId{11, 1}})
        EXPECT_EQ(world.createEntity().id(), expected);
    EXPECT_EQ(world.entityCount(), 11u);
}

template <int... N>
void addAll(Entity entity, std::integer_sequence<int, N...>) {
    (entity.addComponent<Numbered<N>>(), ...);
}
template <int... N>
std::size_t countAll(const World& world, std::integer_sequence<int, N...>) {
    return (world.count<Numbered<N>>() + ...);
}

TEST(StorageTest, anEntityWithMoreThan63TypesIsDestroyedInALoopToo) {
    using All = std::make_integer_sequence<int, 70>;
    World world;
    for (int i = 0; i < 6; ++i) {
        Entity entity = world.createEntity();
        entity.addComponent<Position>();
        if (i != 2) addAll(entity, All{});
    }
    ASSERT_EQ(countAll(world, All{}), 5u * 70);
    for (auto [entity, position] : world.query<const Position>()) {
        if (entity.id().index % 2 == 0) entity.destroy();
        EXPECT_EQ(countAll(world, All{}), (5 - entity.id().index / 2) * 70u);
    }
    EXPECT_EQ(world.entityCount(), 3u);
    EXPECT_EQ(countAll(world, All{}), 2u * 70);
    EXPECT_EQ(world.query<const Numbered<69>>().count(), 2u);
    EXPECT_EQ(world.query<const Position>(without<Numbered<69>>).first().id().index, 3u);
}

/// A world of `count` movers of which `changes` were replaced from the end, so that their order is not that
/// of their indices.
void disorder(World& world, std::uint32_t count, std::uint32_t changes) {
    fillWithMovers(world, static_cast<int>(count + changes));
    for (std::uint32_t i = 1; i <= changes; ++i) world.destroy({i, 1});
}

// The order of iteration is part of the simulation: when it changes is a promise to recorded games.
TEST(ClusterTest, aTickSortsAPoolOf256WithMoreThanAQuarterOfChanges) {
    const struct {
        std::uint32_t count, changes;
        bool isSorted;
    } cases[] = {{256, 64, false},   {256, 65, true},   {255, 200, false},
                 {1000, 250, false}, {1000, 251, true}, {300, 10, false}};
    for (const auto& test : cases) {
        SCOPED_TRACE(testing::Message() << test.count << " with " << test.changes << " changes");
        World world;
        disorder(world, test.count, test.changes);
        const std::vector<std::uint32_t> before = orderOf(world);
        ASSERT_FALSE(std::is_sorted(before.begin(), before.end()));
        world.beginTick();
        const std::vector<std::uint32_t> after = orderOf(world);
        ASSERT_EQ(after.size(), test.count);
        EXPECT_EQ(std::is_sorted(after.begin(), after.end()), test.isSorted);
        EXPECT_EQ(after == before, !test.isSorted);
        world.beginTick();
        EXPECT_EQ(orderOf(world), after);
    }
}

TEST(ClusterTest, aTickSortsWorldsOfUpTo32768Entities) {
    for (const std::uint32_t others : {32'768u - 300u, 32'769u - 300u}) {
        SCOPED_TRACE(others);
        World world;
        disorder(world, 300, 200);
        std::vector<EntityId> ids(others);
        world.createEntities(ids, Frozen{});
        ASSERT_EQ(world.entityCount(), 300 + others);
        world.beginTick();
        const std::vector<std::uint32_t> order = orderOf(world);
        EXPECT_EQ(std::is_sorted(order.begin(), order.end()), world.entityCount() <= 32'768u);
    }
}

TEST(ClusterTest, aTickThatBeginsInALoopSortsNothing) {
    World world;
    disorder(world, 300, 200);
    const test::Faults faults;
    const std::vector<std::uint32_t> before = orderOf(world);
    std::size_t visited = 0;
    for (auto [entity, position] : world.query<const Position>()) {
        if (visited++ == 0) world.beginTick();
    }
    EXPECT_EQ(visited, 300u);
    EXPECT_EQ(orderOf(world), before);
    EXPECT_TRUE(faults.lines().empty());
}

TEST(ClusterTest, aRestoredWorldIsSortedInTheSameTick) {
    World world;
    disorder(world, 300, 70);
    const Snapshot saved = world.save();
    World other;
    other.createEntity().addComponent<Health>();  // of types used in another order
    other.restore(saved);
    bool wasSorted = false;
    for (std::uint32_t tick = 0; tick < 20; ++tick) {
        for (World* each : {&world, &other}) {
            each->destroy({71 + tick, 1});
            each->beginTick();
        }
        const std::vector<std::uint32_t> order = orderOf(world);
        ASSERT_EQ(orderOf(other), order) << tick;
        wasSorted = wasSorted || std::is_sorted(order.begin(), order.end());
    }
    EXPECT_TRUE(wasSorted);
}

TEST(HashTest, dependsOnTheTickTheEntitiesAndTheirGenerations) {
    const auto hashOf = [](auto&& change) {
        World world;
        fillWithMovers(world, 3);
        change(world);
        return world.hash();
    };
    const std::uint64_t hashes[] = {
        hashOf([](World&) {}),
        hashOf([](World& world) { world.beginTick(); }),
        hashOf([](World& world) { world.createEntity(); }),
        hashOf([](World& world) { world.createEntity(), world.createEntity(); }),
        hashOf([](World& world) { world.createEntity().destroy(), world.createEntity(); }),
        hashOf([](World& world) {
            world.createEntity(), world.createEntity(), world.destroy({4, 1});
        }),
        hashOf([](World& world) {
            world.add<Frozen>({1, 1});
        }),
        hashOf([](World& world) {
            world.add<Frozen>({2, 1});
        }),
        hashOf([](World& world) {
            world.add<Player>({1, 1});
        }),
        hashOf([](World& world) {
            world.get<Velocity>({2, 1}).x = 2.0f;
        }),
        hashOf([](World& world) {
            world.get<Velocity>({3, 1}).x = 2.0f;
        }),
        hashOf([](World& world) {
            world.get<Position>({2, 1}).x = 2.0f;
        }),
        hashOf([](World& world) {
            world.remove<Velocity>({3, 1});
        }),
        hashOf([](World& world) {
            world.destroy({3, 1});
        }),
    };
    for (std::size_t i = 0; i < std::size(hashes); ++i) {
        for (std::size_t k = 0; k < i; ++k) EXPECT_NE(hashes[i], hashes[k]) << k << " and " << i;
    }
    EXPECT_EQ(hashOf([](World& world) { world.createEntity().destroy(); }), hashes[0]) << "only a history";
}

TEST(StorageTest, componentsAreFoundByTheirTypeInAWorldForReadingToo) {
    World world;
    const World& reader = world;
    const Entity with = world.createEntity();
    const Entity without = world.createEntity();
    for (const TypeInfo* type : {&componentType<Numbered<11>>().info, &componentType<Player>().info}) {
        for (const Entity entity : {with, without}) {  // of a type that the world has not met
            EXPECT_EQ(reader.find(*type, entity), nullptr);
            EXPECT_EQ(world.find(*type, entity), nullptr);
            EXPECT_FALSE(reader.has(*type, entity));
            world.remove(*type, entity);
        }
        EXPECT_EQ(reader.count(*type), 0u);
        const void* added = world.add(*type, with);
        ASSERT_NE(added, nullptr);
        EXPECT_EQ(reader.find(*type, with), added);
        EXPECT_EQ(world.find(*type, with), added);
        EXPECT_EQ(reader.find(*type, without), nullptr);
        EXPECT_EQ(world.find(*type, without), nullptr);
        EXPECT_TRUE(reader.has(*type, with));
        EXPECT_FALSE(reader.has(*type, without));
        world.remove(*type, without);
        EXPECT_EQ(reader.count(*type), 1u);
    }
    EXPECT_EQ(with.get<Numbered<11>>().value, 11);
}

TEST(ServiceTest, everyTypeHasItsOwn) {
    World world;
    Health health;
    Velocity velocity;
    world.provide(health);
    world.provide(velocity);
    EXPECT_EQ(world.service<Health>(), &health);
    EXPECT_EQ(world.service<Velocity>(), &velocity);
    EXPECT_EQ(world.service<Position>(), nullptr);
}

}  // namespace
}  // namespace plumb
