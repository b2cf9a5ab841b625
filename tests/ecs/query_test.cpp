#include "ecs/query.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "ecs/hierarchy.hpp"
#include "tests/ecs/parts.hpp"
#include "tests/support/faults.hpp"

namespace plumb {
namespace {

TEST(QueryTest, visitsEntitiesWithAllComponents) {
    World world;
    Entity e1 = world.createEntity();
    Entity e2 = world.createEntity();
    e1.addComponent<Position>();
    e1.addComponent<Velocity>(1.0f, 2.0f);
    e2.addComponent<Position>();

    int count = 0;
    for (auto [entity, position, velocity] : world.query<Position, Velocity>()) {
        count++;
    }
    EXPECT_EQ(count, 1);
    for (auto [entity, position, velocity] : world.query<Position, const Velocity>()) {
        EXPECT_EQ(entity, e1);
        position.x += velocity.x;
    }
    EXPECT_EQ(e1.get<Position>().x, 1.0f);
}

TEST(QueryTest, filtersAndTagsRestrictAQuery) {
    World world;
    fillWithMovers(world, 100);
    int i = 0;
    for (auto [entity, position] : world.query<Position>()) {
        if (i % 2 == 0) entity.addComponent<Frozen>();
        if (i % 5 == 0) entity.addComponent<Player>();
        ++i;
    }
    EXPECT_EQ(world.query<Position>(without<Frozen>).count(), 50u);
    EXPECT_EQ((world.query<Position>(without<Frozen, Player>).count()), 40u);
    EXPECT_EQ(world.query<Position>(with<Frozen>, without<Player>).count(), 40u);
    EXPECT_EQ((world.query<const Position, Frozen>(with<Player>).count()), 10u);
    EXPECT_EQ(world.query<Player>().count(), 20u);
    for (auto [entity, position, frozen] : world.query<const Position, const Frozen>(with<Player>)) {
        EXPECT_EQ(static_cast<int>(position.x) % 10, 0);
    }
    world.query<const Position>(without<Frozen>).each([](const Position& position) {
        EXPECT_EQ(static_cast<int>(position.x) % 2, 1);
    });
}

TEST(QueryTest, allKindsOfLoopsVisitTheSameEntities) {
    World world;
    fillWithMovers(world, 1000);
    std::vector<EntityId> gone;
    for (auto [entity, velocity] : world.query<const Velocity>()) {
        if (static_cast<int>(velocity.y) % 3 == 0) gone.push_back(entity);
    }
    for (const EntityId id : gone) world.remove<Velocity>(id);

    for (int round = 0; round < 3; ++round) {
        SCOPED_TRACE(round);
        float byRange = 0.0f;
        float byEach = 0.0f;
        float byEntity = 0.0f;
        float byChunks = 0.0f;
        for (auto [entity, p, v] : world.query<const Position, const Velocity>()) byRange += p.x + v.x;
        world.each<const Position, const Velocity>(
            [&](const Position& p, const Velocity& v) { byEach += p.x + v.x; });
        world.each<const Position, const Velocity>([&](EntityId id, const Position& p, const Velocity& v) {
            EXPECT_EQ(world.find<const Position>(id), &p);
            byEntity += p.x + v.x;
        });
        world.chunks<const Position, const Velocity>(
            [&](std::size_t n, const Position* p, const Velocity* v) {
                for (std::size_t i = 0; i < n; ++i) byChunks += p[i].x + v[i].x;
            });
        EXPECT_GT(byRange, 0.0f);
        EXPECT_EQ(byRange, byEach);
        EXPECT_EQ(byRange, byEntity);
        EXPECT_EQ(byRange, byChunks);
        EXPECT_EQ((world.query<Position, Velocity>().count()), 666u);
        if (round == 1)
            world.cluster();
        else
            world.createEntity().addComponent<Position>();
    }
}

TEST(QueryTest, aConstWorldIsReadWithConstComponents) {
    World world;
    fillWithMovers(world, 5);
    const World& reader = world;
    float sum = 0.0f;
    for (auto [entity, position] : reader.query<const Position>()) sum += position.x;
    reader.each<const Position>([&](const Position& position) { sum += position.x; });
    EXPECT_EQ(sum, 20.0f);
}

TEST(QueryTest, theFirstMatchIsFoundAndNoMatchIsAnEmptyHandle) {
    World world;
    EXPECT_FALSE(world.first<Position>());
    fillWithMovers(world, 3);
    EXPECT_EQ((world.first<Position, Velocity>().id().index), 1u);
    EXPECT_TRUE(world.query<Health>().empty());
}

TEST(QueryTest, anEntityMayDestroyItselfInTheLoop) {
    World world;
    fillWithMovers(world, 1000);
    int visited = 0;
    for (auto [entity, position, velocity] : world.query<Position, Velocity>()) {
        ++visited;
        if (static_cast<int>(position.x) % 2 == 0) entity.destroy();
    }
    EXPECT_EQ(visited, 1000);
    EXPECT_EQ(world.entityCount(), 500u);
    for (auto [entity, position] : world.query<Position>()) EXPECT_EQ(static_cast<int>(position.x) % 2, 1);
    EXPECT_EQ((world.query<Position, Velocity>().count()), 500u);
}

TEST(QueryTest, aDestroyedEntityIsNoLongerVisited) {
    World world;
    fillWithMovers(world, 100);
    std::vector<Entity> all;
    for (auto [entity, position] : world.query<Position>()) all.push_back(entity);

    int visited = 0;
    for (auto [entity, position] : world.query<Position>()) {
        ++visited;
        ASSERT_TRUE(entity.alive());
        const std::size_t at = static_cast<std::size_t>(position.x);
        if (at + 1 < all.size()) all[at + 1].destroy();
    }
    EXPECT_EQ(visited, 50);

    visited = 0;
    world.each<Position>([&](Position&) {
        if (++visited == 10) world.clear();
    });
    EXPECT_EQ(visited, 10);
    EXPECT_EQ(world.entityCount(), 0u);
    EXPECT_EQ(world.count<Position>(), 0u);
}

TEST(QueryTest, anEntityThatStopsMatchingIsSkipped) {
    World world;
    fillWithMovers(world, 10);
    std::vector<Entity> all;
    for (auto [entity, position] : world.query<Position>()) all.push_back(entity);

    int visited = 0;
    for (auto [entity, position, velocity] : world.query<Position, Velocity>(without<Frozen>)) {
        ++visited;
        all[3].removeComponent<Velocity>();
        all[4].addComponent<Frozen>();
        all[5].removeComponent<Velocity>();
        all[5].addComponent<Velocity>();  // a new component, added after the loop began, so the loop skips it
    }
    EXPECT_EQ(visited, 7);
    EXPECT_TRUE(all[5].hasComponent<Velocity>());
    EXPECT_EQ((world.query<Position, Velocity>().count()), 9u);
}

TEST(QueryTest, componentsAddedInALoopExistImmediatelyAndAreVisitedByTheNextLoop) {
    World world;
    fillWithMovers(world, 10);
    int visited = 0;
    for (auto [entity, position] : world.query<Position>()) {
        ++visited;
        Entity child = world.createEntity();
        child.addComponent<Position>(position.x, 1.0f);
        EXPECT_EQ(child.get<Position>().x, position.x);
    }
    EXPECT_EQ(visited, 10);
    EXPECT_EQ(world.query<Position>().count(), 20u);
}

TEST(QueryTest, nestedLoopsSeeTheCurrentWorld) {
    World world;
    fillWithMovers(world, 20);
    int pairs = 0;
    int outer = 0;
    for (auto [a, positionA] : world.query<Position>()) {
        ++outer;
        for (auto [b, positionB] : world.query<Position>()) {
            ++pairs;
            if (b != a) {
                b.destroy();  // the first iteration destroys all other entities
            }
        }
        EXPECT_EQ(world.query<Position>().count(), 1u);
    }
    EXPECT_EQ(outer, 1);
    EXPECT_EQ(pairs, 20);
    EXPECT_EQ(world.count<Position>(), 1u);
    EXPECT_EQ(world.query<Position>().count(), 1u);
}

TEST(QueryTest, savingRestoringAndClusteringInALoopIsRefusedWithTheRemedy) {
    World world;
    fillWithMovers(world, 10);
    const Snapshot before = world.save();
    Snapshot inside;
    int visited = 0;
    for (auto [entity, position] : world.query<Position>()) {
        entity.destroy();
        test::Faults faults;
        world.save(inside);
        EXPECT_TRUE(faults.mention("save() was called inside a loop")) << visited;
        world.restore(before);
        EXPECT_TRUE(faults.mention("restore() was called inside a loop"));
        world.cluster();
        EXPECT_TRUE(faults.mention("cluster() was called inside a loop"));
        EXPECT_TRUE(faults.mention("call it after the loop"));
        ++visited;
    }
    EXPECT_EQ(visited, 10);
    EXPECT_EQ(world.entityCount(), 0u);
    const test::Faults faults;
    world.restore(inside);
    EXPECT_TRUE(faults.mention("a snapshot that holds no world"));
    EXPECT_EQ(world.entityCount(), 0u);
    world.restore(before);
    EXPECT_EQ((world.query<Position, Velocity>().count()), 10u);
}

/// Changes the world at random, also by loops within the loop.
void change(World& world, Random& random, int depth) {
    const auto any = [&] { return world.entity({random.below(40) + 1, random.below(6) + 1}); };
    for (int i = 0; i < 3; ++i) {
        const Entity entity = any();
        switch (random.below(10)) {
            case 0: world.createEntity().addComponent<Position>(1.0f, 1.0f); break;
            case 1:
            case 2: entity.destroy(); break;
            case 3: entity.removeComponent<Position>(); break;
            case 4: entity.removeComponent<Velocity>(); break;
            case 5: entity.removeComponent<Frozen>(); break;
            case 6:
                if (entity) entity.addComponent<Frozen>();
                break;
            case 7:
                if (entity) entity.addComponent<Velocity>(2.0f, 2.0f);
                break;
            case 8: static_cast<void>(setParent(world, entity, any())); break;
            default:
                if (random.below(20) == 0) world.clear();
        }
    }
    if (depth > 0 && random.below(4) == 0) {
        for (auto [entity, velocity] : world.query<Velocity>(without<Frozen>))
            change(world, random, depth - 1);
    }
}

TEST(QueryProperty, anyChangeInsideALoopLeavesItWithLivingEntitiesThatMatch) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        World world;
        fillWithMovers(world, 30);
        const auto check = [&](Entity entity, Position& position) {
            ASSERT_TRUE(entity.alive());
            ASSERT_EQ(entity.find<Position>(), &position);
            ASSERT_TRUE(entity.hasComponent<Velocity>());
            ASSERT_FALSE(entity.hasComponent<Frozen>());
            position.x += 1.0f;
            change(world, random, 2);
        };
        for (auto [entity, position, velocity] : world.query<Position, Velocity>(without<Frozen>))
            check(entity, position);
        fillWithMovers(world, 10);
        world.query<Position, const Velocity>(without<Frozen>)
            .each([&](Entity entity, Position& position, const Velocity&) { check(entity, position); });
        std::size_t alive = 0;
        for (auto [entity, position] : world.query<Position>()) {
            ASSERT_EQ(entity.find<Position>(), &position);
            ++alive;
        }
        ASSERT_EQ(alive, world.count<Position>());
    }
}

TEST(QueryTest, leavingALoopEarlyAppliesItsChanges) {
    World world;
    fillWithMovers(world, 10);
    for (auto [entity, position] : world.query<Position>()) {
        entity.destroy();
        if (position.x >= 4.0f) break;
    }
    EXPECT_EQ(world.count<Position>(), 5u);
    int visited = 0;
    for (auto [entity, position] : world.query<Position>()) {
        EXPECT_GT(position.x, 4.0f);
        ++visited;
    }
    EXPECT_EQ(visited, 5);
}

TEST(QueryTest, detectsChangesThatKeepTheNumberOfEntities) {
    World world;
    std::vector<Entity> entities(8);
    for (Entity& entity : entities) {
        entity = world.createEntity();
        entity.addComponent<Position>();
    }
    const auto sum = [&world] {
        std::uint32_t total = 0;
        for (auto [entity, position] : world.query<const Position>()) total += entity.id().index;
        return total;
    };
    const std::uint32_t before = sum();
    const Snapshot snapshot = world.save();
    Entity newcomer = world.createEntity();
    entities[2].removeComponent<Position>();
    newcomer.addComponent<Position>();
    EXPECT_EQ(sum(), before - entities[2].id().index + newcomer.id().index);
    world.restore(snapshot);
    EXPECT_EQ(sum(), before);
    world.clear();
    EXPECT_EQ(sum(), 0u);
    for (int i = 0; i < 8; ++i) world.createEntity().addComponent<Position>();
    EXPECT_EQ(sum(), before);
}

TEST(QueryTest, scatteredEntitiesAreFoundAfterEveryChange) {
    World world;
    fillWithMovers(world, 2000);
    std::vector<Entity> all;
    for (auto [entity, position] : world.query<Position>()) all.push_back(entity);
    std::size_t expected = 2000;
    for (std::size_t round = 0; round < 50; ++round) {
        SCOPED_TRACE(round);
        for (std::size_t i = round; i < all.size(); i += 50) {
            if ((i / 50) % 2 == 0) {
                all[i].removeComponent<Velocity>();
                --expected;
            }
        }
        std::size_t seen = 0;
        world.each<Position, const Velocity>([&](Position&, const Velocity&) { ++seen; });
        ASSERT_EQ(seen, expected);
        seen = 0;
        for (auto [entity, p, v] : world.query<Position, const Velocity>()) {
            ASSERT_EQ(p.x, v.y) << "both components must be of the same entity";
            ++seen;
        }
        ASSERT_EQ(seen, expected);
    }
}

TEST(PausedTest, queriesSkipPausedEntitiesByDefault) {
    World world;
    fillWithMovers(world, 10);
    for (const std::uint32_t index : {3u, 4u, 9u}) world.add<Paused>(EntityId{index, 1});

    EXPECT_EQ(world.query<const Position>().count(), 7u);
    EXPECT_EQ((world.query<const Position, const Velocity>(without<Frozen>).count()), 7u);
    EXPECT_EQ(world.query<const Position>(withPaused).count(), 10u);
    EXPECT_EQ(world.query<const Position>(with<Paused>).count(), 3u);
    EXPECT_EQ((world.query<const Position, const Paused>().count()), 3u);
    EXPECT_EQ(world.query<const Position>(without<Paused>).count(), 7u);
    int seen = 0;
    world.each<Position>([&seen](Position&) { ++seen; });
    EXPECT_EQ(seen, 7);
    EXPECT_TRUE(world.has<Position>(EntityId{3, 1})) << "a paused entity is still found by its id";

    world.remove<Paused>(EntityId{3, 1});
    EXPECT_EQ(world.query<const Position>().count(), 8u);
}

TEST(PausedTest, pausingAnEntityDoesNotChangeTheOrder) {
    World world;
    fillWithMovers(world, 2000);
    for (std::uint32_t i = 1; i < 2000; i += 3) world.add<Paused>(EntityId{i, 1});
    for (std::uint32_t i = 2; i < 2000; i += 3) world.destroy(EntityId{i, 1});
    const auto order = [&world] {
        std::vector<EntityId> ids;
        for (auto [entity, position] : std::as_const(world).query<const Position>(withPaused))
            ids.push_back(entity);
        return ids;
    };
    const std::vector<EntityId> before = order();
    world.beginTick();
    EXPECT_EQ(order(), before);
}

}  // namespace
}  // namespace plumb
