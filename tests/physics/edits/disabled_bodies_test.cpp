#include <functional>

#include "physics/model/joints.hpp"
#include "tests/physics/support/effect_worlds.hpp"

namespace plumb::physics {
namespace {

using namespace test;

/// Changes body `which` of a crowd while it is disabled. @return its height after it was enabled again and
/// fell, m
double heightAfter(int crowd, int which, const std::function<void(World&, BodyId, ShapeId)>& change) {
    World world = makeWorld();
    addFloor(world);
    std::vector<BodyId> bodies;
    std::vector<ShapeId> shapes;
    for (int i = 0; i < crowd; ++i) {
        bodies.push_back(*createBody(world, {.position = {2.0 * (i % 5), -2.0 - 2.0 * (i / 5)}}));
        shapes.push_back(*createShape(world, bodies.back(), circle(0.3f)));
    }
    const auto at = static_cast<std::size_t>(which);
    step(world, kStep);
    setEnabled(world, bodies[at], false);
    step(world, kStep);
    change(world, bodies[at], shapes[at]);
    step(world, kStep);
    setEnabled(world, bodies[at], true);
    run(world, 300);
    return heightOf(world, bodies[at]);
}

TEST(DisabledBodies, collideAgainAfterAnyChange) {
    const auto change = [](World& world, BodyId body, ShapeId shape) {
        setFilter(world, shape, 2, 1, 0);
        EXPECT_TRUE(setPosition(world, body, positionOf(world, body), 0.5f).ok());
        setFilter(world, shape, 1, ~0u, 0);
    };
    for (const int crowd : {4, 12, 24}) {
        for (int which = 0; which < crowd; ++which)
            EXPECT_GT(heightAfter(crowd, which, change), 0.0) << which << " of " << crowd;
    }
}

TEST(DisabledBodies, areNotInTheIslandsOfJointedBodies) {
    for (const bool swapped : {false, true}) {
        World world = makeWorld();
        world.settings.tolerance = 0.001f;
        addFloor(world);
        const BodyId a = addBody(world, BodyKind::Dynamic, {0.0, -5.0}, circle(0.5f));
        const BodyId b = addBody(world, BodyKind::Dynamic, {3.0, -0.5}, box({0.5f, 0.5f}));
        ShapeDefinition heavy;
        heavy.density = 300.0f;
        // This heavy body on b makes the island of b require many substeps.
        addBody(world, BodyKind::Dynamic, {3.0, -1.5}, box({0.5f, 0.5f}), heavy);
        run(world, 30);
        setEnabled(world, b, false);
        step(world, kStep);
        ASSERT_TRUE(
            createJoint(world, {.kind = JointKind::Weld, .a = swapped ? b : a, .b = swapped ? a : b}).ok());
        World copy = world;
        for (int i = 0; i < 60; ++i) {
            step(world, kStep);
            step(copy, kStep);
            ASSERT_TRUE(sameState(world, copy)) << i;
        }
    }
}

}  // namespace
}  // namespace plumb::physics
