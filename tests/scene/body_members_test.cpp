#include <algorithm>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "ecs/hierarchy.hpp"
#include "ecs/paused.hpp"
#include "scene/components/bodies/kinematic_body.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/bodies/static_body.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/colliders/circle_collider.hpp"
#include "scene/components/joints/revolute_joint.hpp"
#include "scene/components/transform.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/systems/physics_system.hpp"
#include "scene/world_transform.hpp"

// Bodies are created and destroyed with components. The cost of a change is proportional to the change, not
// to the world, and the result does not depend on other code that reads the world.

namespace plumb {
namespace {

constexpr float kTick = 1.0f / 60.0f;  // s

void run(World& world, int ticks) {
    for (int i = 0; i < ticks; ++i) {
        world.beginTick();
        world.update(kTick);
    }
}

void addResting(World& world, int count) {
    for (int i = 0; i < count; ++i) {
        Entity entity = world.createEntity();
        entity.addComponent<Transform>(20.0f * static_cast<float>(i), 0.0f);
        entity.addComponent<BoxCollider>(10.0f, 10.0f);
        entity.addComponent<RigidBody>().gravityScale = 0.0f;
    }
}

EntityId shoot(World& world, float x) {
    Entity bullet = world.createEntity();
    bullet.addComponent<Transform>(x, -500.0f);
    bullet.addComponent<CircleCollider>(2.0f);
    bullet.addComponent<RigidBody>().velocity = {0.0f, -300.0f};
    return bullet;
}

/// Returns how many entities the physics bridge compares for one spawn and one destruction in a world with
/// `resting` bodies at rest.
std::uint64_t visitsOfOneBullet(int resting) {
    World world;
    world.addSystem<PhysicsSystem>();
    addResting(world, resting);
    run(world, 60);
    PhysicsState& state = world.resource<PhysicsState>();
    EXPECT_TRUE(state.world.awake.empty());
    const std::uint64_t before = state.visits;
    const EntityId bullet = shoot(world, 0.0f);
    run(world, 1);
    EXPECT_TRUE(bodyOf(state, bullet));
    world.destroy(bullet);
    run(world, 1);
    EXPECT_FALSE(bodyOf(state, bullet));
    EXPECT_EQ(state.world.bodies.size(), static_cast<std::size_t>(resting) + 1);
    return state.visits - before;
}

TEST(BodyMembers, theCostOfASpawnDoesNotGrowWithTheWorld) {
    // Changes are recorded per block of 256 components: one block for each component type of the bullet.
    constexpr std::uint64_t kBlock = 1u << kStampShift, kTypes = 3, kTicks = 2;
    const std::uint64_t small = visitsOfOneBullet(1000), large = visitsOfOneBullet(16'000);
    EXPECT_GT(small, 0u);
    EXPECT_LE(small, kBlock * (kTypes + 1) * kTicks);
    EXPECT_LE(large, kBlock * (kTypes + 1) * kTicks);
}

/// Applies random changes to a world that affect which entities have bodies.
class Changes {
public:
    Changes(World& world, std::uint64_t seed) : world_{world}, random_{Random::seeded(seed)} {}

    void some() {
        for (std::uint32_t i = 1 + random_.below(12); i > 0; --i) one();
    }

private:
    EntityId any() { return made_[random_.below(static_cast<std::uint32_t>(made_.size()))]; }

    EntityId make() {
        Entity entity = world_.createEntity();
        made_.push_back(entity);
        if (random_.below(8) != 0)
            entity.addComponent<Transform>(random_.between(-400, 400), random_.between(-400, 400));
        if (random_.below(3) != 0) entity.addComponent<BoxCollider>(10.0f, 10.0f);
        if (random_.below(3) == 0) entity.addComponent<CircleCollider>(6.0f);
        if (random_.below(2) == 0) entity.addComponent<RigidBody>();
        if (random_.below(6) == 0) entity.addComponent<KinematicBody>();
        return entity;
    }

    template <class T>
    void toggle(EntityId id) {
        world_.has<T>(id) ? world_.remove<T>(id) : static_cast<void>(world_.add<T>(id));
    }

    void one() {
        if (made_.size() < 8 || random_.below(4) == 0) return static_cast<void>(make());
        const EntityId id = any();
        if (!world_.alive(id)) return;
        switch (random_.below(11)) {
            case 0: world_.destroy(id); break;
            case 1: toggle<Transform>(id); break;
            case 2: toggle<RigidBody>(id); break;
            case 3: toggle<KinematicBody>(id); break;
            case 4: toggle<StaticBody>(id); break;
            case 5: toggle<BoxCollider>(id); break;
            case 6: toggle<CircleCollider>(id); break;
            case 7: toggle<Paused>(id); break;
            case 8: setParent(world_, id, any()); break;
            case 9: setParent(world_, id, EntityId{}); break;
            default:
                if (auto* transform = world_.find<Transform>(id))
                    transform->position = {random_.between(-400, 400), random_.between(-400, 400)};
        }
    }

    World& world_;
    Random random_;
    std::vector<EntityId> made_;
};

bool needsBody(const World& world, EntityId id) {
    return world.has<Transform>(id) && !world.has<Paused>(id) &&
           (world.has<BoxCollider>(id) || world.has<CircleCollider>(id) || world.has<RigidBody>(id) ||
            world.has<KinematicBody>(id));
}

std::uint32_t shapesOf(const World& world, EntityId id) {
    return std::uint32_t{world.has<BoxCollider>(id)} + std::uint32_t{world.has<CircleCollider>(id)};
}

/// Compares all bodies with all entities, which the bridge itself does not do.
void expectBodiesOf(const World& world, const PhysicsState& state) {
    std::size_t bodies = 0;
    std::vector<std::uint32_t> carried, driven;
    for (const EntityId id : world.entities()) {
        const physics::BodyId body = bodyOf(state, id);
        ASSERT_EQ(static_cast<bool>(body), needsBody(world, id)) << id.index;
        if (!body) continue;
        ++bodies;
        const physics::BodyKind kind = state.world.bodies.info[body.index].kind;
        EXPECT_EQ(kind, world.has<RigidBody>(id)       ? physics::BodyKind::Dynamic
                        : world.has<KinematicBody>(id) ? physics::BodyKind::Kinematic
                                                       : physics::BodyKind::Static);
        std::uint32_t shapes = 0;
        for (std::uint32_t s = state.world.bodies.info[body.index].firstShape; s != physics::kNone;
             s = state.world.shapes.info[s].next)
            ++shapes;
        EXPECT_EQ(shapes, shapesOf(world, id)) << id.index;
        if (parentOf(world, id)) carried.push_back(body.index);
        if (kind == physics::BodyKind::Kinematic) driven.push_back(body.index);
    }
    std::sort(carried.begin(), carried.end());
    std::sort(driven.begin(), driven.end());
    EXPECT_EQ(state.carried, carried);
    EXPECT_EQ(state.driven, driven);
    const auto linked = std::count_if(state.links.begin(), state.links.end(),
                                      [](const BodyLink& link) { return static_cast<bool>(link.entity); });
    EXPECT_EQ(static_cast<std::size_t>(linked), bodies);
}

TEST(BodyMembers, afterRandomChangesBodiesMatchTheComponents) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        World world;
        world.addSystem<PhysicsSystem>();
        Changes changes{world, seed};
        for (int tick = 0; tick < 60; ++tick) {
            changes.some();
            run(world, 1);
            expectBodiesOf(world, world.resource<PhysicsState>());
            if (::testing::Test::HasFailure()) return;
        }
    }
}

/// Requests write access to all components without changing them, like a tool that queries without `const`.
void touchAll(World& world) {
    for (auto [entity, transform] : world.query<Transform>()) static_cast<void>(transform.position);
    for (auto [entity, body] : world.query<RigidBody>()) static_cast<void>(body.mass);
    for (auto [entity, box] : world.query<BoxCollider>()) static_cast<void>(box.width);
}

TEST(BodyMembers, observersChangeNoBit) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        World alone, watched;
        Changes first{alone, seed}, second{watched, seed};
        Random random = Random::seeded(seed);
        for (World* world : {&alone, &watched}) world->addSystem<PhysicsSystem>();
        for (int tick = 0; tick < 60; ++tick) {
            first.some(), second.some();
            if (random.below(3) == 0) touchAll(watched);
            if (random.below(6) == 0) watched.restore(watched.save());
            run(alone, 1), run(watched, 1);
            ASSERT_EQ(alone.hash(), watched.hash()) << tick;
        }
        EXPECT_GT(alone.resource<PhysicsState>().world.bodies.size(), 4u);
    }
}

TEST(BodyMembers, aJointIsCreatedOnceItsOtherBodyExists) {
    World world;
    world.addSystem<PhysicsSystem>();
    addResting(world, 2);
    const EntityId first{1, 1}, second{2, 1};
    world.remove<BoxCollider>(second);
    world.remove<RigidBody>(second);
    world.add<RevoluteJoint>(first).other = second;
    run(world, 2);
    const PhysicsState& state = world.resource<PhysicsState>();
    ASSERT_EQ(state.joints.size(), 1u);
    EXPECT_FALSE(physics::alive(state.world, state.joints[0].joint));
    world.add<BoxCollider>(second, 10.0f, 10.0f);
    run(world, 1);
    EXPECT_TRUE(physics::alive(state.world, state.joints[0].joint));
    world.add<Paused>(second);
    run(world, 1);
    EXPECT_FALSE(physics::alive(state.world, state.joints[0].joint));
    world.remove<Paused>(second);
    run(world, 1);
    EXPECT_TRUE(physics::alive(state.world, state.joints[0].joint));
}

}  // namespace
}  // namespace plumb
