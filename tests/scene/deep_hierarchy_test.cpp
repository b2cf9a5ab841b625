#include <cmath>
#include <ctime>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "ecs/hierarchy.hpp"
#include "scene/world_transform.hpp"
#include "tests/scene/physics_scene.hpp"
#include "tests/support/allocations.hpp"

namespace plumb {
namespace {

/// Entities with Transforms, the parent of each a random one before it; some without a Transform.
std::vector<Entity> randomTree(World& world, Random& random, std::uint32_t count) {
    std::vector<Entity> all;
    for (std::uint32_t i = 0; i < count; ++i) {
        Entity entity = all.emplace_back(world.createEntity());
        if (random.below(8) != 0) {
            Transform& transform =
                entity.addComponent<Transform>(random.between(-9.0f, 9.0f), random.between(-9.0f, 9.0f));
            transform.rotation = random.between(-3.0f, 3.0f);
            transform.scale = {random.between(0.5f, 2.0f), 1.0f};
            transform.previousPosition = transform.position - Vec2{1.0f, 2.0f};
        }
        if (i > 0 && random.below(10) != 0) setParent(world, entity, all[random.below(i)]);
    }
    return all;
}

/// The definition of a world pose.
Pose composedAlong(const World& world, EntityId entity, float alpha) {
    const auto* transform = world.find<Transform>(entity);
    const Pose own = transform != nullptr ? interpolated(*transform, alpha) : Pose{};
    const EntityId parent = parentOf(world, entity);
    return parent ? composed(composedAlong(world, parent, alpha), own) : own;
}

TEST(WorldPosesProperty, posesHaveTheBitsOfTheDefinitionInAnyOrder) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        World world;
        const std::vector<Entity> all = randomTree(world, random, 60);
        const World& reader = world;
        WorldPoses poses;
        for (int i = 0; i < 500; ++i) {
            const Entity entity = all[random.below(60)];
            const float alpha = random.below(50) == 0 ? 0.25f : 1.0f;
            ASSERT_EQ(poses.of(reader, entity, alpha), composedAlong(reader, entity, alpha));
            ASSERT_EQ(worldPose(reader, entity, alpha), composedAlong(reader, entity, alpha));
            if (random.below(5) != 0) continue;
            const Entity moved = all[random.below(60)];
            if (auto* transform = moved.find<Transform>()) transform->position.x += 1.0f;
            poses.forget(moved);
        }
        EXPECT_EQ(WorldPoses{poses}.of(reader, all[59]), composedAlong(reader, all[59], 1.0f));
    }
}

TEST(WorldPosesProperty, posesNeedNoMemoryOnceTheyHaveEnough) {
    Random random = Random::seeded(1);
    World world;
    const std::vector<Entity> all = randomTree(world, random, 200);
    WorldPoses poses;
    float sum = 0.0f;
    const auto read = [&] {
        poses.clear();
        for (const Entity entity : all)
            sum += poses.of(world, entity).position.x + worldPose(world, entity).position.x;
    };
    read();
    const std::size_t before = test::allocations().made;
    read();
    EXPECT_EQ(test::allocations().made, before);
    EXPECT_TRUE(std::isfinite(sum));
}

/// A chain of entities, each the child of the one before and 1 px to its right.
std::vector<Entity> chainOf(World& world, std::size_t count) {
    std::vector<Entity> chain(count);
    for (std::size_t i = 0; i < count; ++i) {
        chain[i] = world.createEntity();
        chain[i].addComponent<Transform>(1.0f, 0.0f);
        if (i > 0) setParent(world, chain[i], chain[i - 1]);
    }
    return chain;
}

double secondsSince(std::clock_t start) { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; }

// For both: a function that recurses along the chain exhausts the stack; one that walks
// along it for each entity takes more than 10 s.

TEST(DeepHierarchy, theWorldPosesOf100000EntitiesInAChainAreComputedInTime) {
    const std::clock_t start = std::clock();
    World world;
    const std::vector<Entity> chain = chainOf(world, 100'000);
    EXPECT_EQ(worldPose(world, chain.back()).position, (Vec2{100'000.0f, 0.0f}));
    WorldPoses poses;
    for (std::size_t i = 0; i < chain.size(); ++i)
        ASSERT_EQ(poses.of(world, chain[i]).position.x, static_cast<float>(i + 1));
    EXPECT_LT(secondsSince(start), 5.0);
}

TEST(DeepHierarchy, bodiesInAChainAreCreatedMovedPublishedAndDestroyedInTime) {
    constexpr std::size_t kCount = 50'000;
    PhysicsScene scene;
    const std::vector<Entity> chain = chainOf(scene.world, kCount);
    const std::clock_t start = std::clock();
    for (std::size_t i = 0; i < kCount; ++i) {
        if (i % 2 == 0) {
            chain[i].addComponent<KinematicBody>();
        } else {
            chain[i].addComponent<RigidBody>().gravityScale = 0.0f;
        }
    }
    scene.run(1);
    for (int tick = 0; tick < 3; ++tick) {
        for (const Entity entity : chain) entity.get<Transform>().rotation += 0.0f;  // all are written
        chain[0].get<Transform>().position.y += 1.0f;
        scene.run(1);
    }
    for (const Entity entity : chain) {
        if (auto* body = entity.find<RigidBody>()) body->velocity = {0.0f, 60.0f};
    }
    scene.run(2);  // the poses of all dynamic bodies are published
    EXPECT_NEAR(worldPose(scene.world, chain[kCount - 1]).position.y, 5.0f, 0.5f);
    chain[1].destroy();
    scene.run(1);
    EXPECT_EQ(scene.world.entityCount(), 1u);
    EXPECT_LT(secondsSince(start), 10.0);
}

}  // namespace
}  // namespace plumb
