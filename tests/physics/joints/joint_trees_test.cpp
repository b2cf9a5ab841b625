#include <gtest/gtest.h>

#include "core/random.hpp"
#include "core/task_pool.hpp"
#include "physics/workspace.hpp"
#include "tests/physics/support/joint_world.hpp"

namespace plumb::physics {
namespace {

bool solvesTrees(JointWorld& scene) { return scene.world.work.get().joints.trees.some; }

/// Maximum distance between anchors that joints must hold together, m.
float worstGap(const JointWorld& scene, const std::vector<JointId>& joints) {
    float worst = 0.0f;
    for (const JointId id : joints) {
        const JointDefinition& definition = scene.world.joints.definition[id.index];
        const float gap = length(scene.gapOf(id));
        if (definition.kind == JointKind::Distance)
            worst = std::max(worst, std::fabs(gap - definition.length));
        if (definition.kind == JointKind::Revolute || definition.kind == JointKind::Weld)
            worst = std::max(worst, gap);
    }
    return worst;
}

TEST(JointTrees, holdAnyLoad) {
    for (const float ratio : {1.0f, 100.0f, 10000.0f}) {
        SCOPED_TRACE(ratio);
        JointWorld scene;
        BodyId above = scene.ground;
        std::vector<JointId> joints;
        for (int i = 0; i <= 20; ++i) {
            const BodyId link = scene.disc({0.0, -0.5 - i}, i < 20 ? 0.1f : 0.1f * ratio);
            joints.push_back(scene.join(scene.define(JointKind::Revolute, above, link, {0.0, -1.0 * i})));
            above = link;
        }
        scene.run(10.0f);
        EXPECT_NEAR(scene.place(above).y, -20.5f, 1.0e-4f);
        EXPECT_LT(worstGap(scene, joints), 1.0e-4f);
        const float load = JointWorld::kGravity * (2.0f + 0.1f * ratio);
        EXPECT_NEAR(jointForce(scene.world, joints[0]).y, load, 0.001f * load);
    }
}

TEST(JointTrees, ofAnyShapeAndKindKeepTheirGapsClosed) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        JointWorld scene;
        const std::vector<JointId> joints = growTree(scene, random, {0.0, 0.0}, true);
        scene.run(3.0f);
        EXPECT_TRUE(solvesTrees(scene));
        EXPECT_LT(worstGap(scene, joints), 0.005f);
    }
}

TEST(JointTrees, keepTheirEnergyForTenSeconds) {
    JointWorld scene;
    std::vector<BodyId> bodies;
    BodyId above = scene.ground;
    for (int i = 0; i < 5; ++i) {
        bodies.push_back(scene.disc({0.5 + i, 0.0}));
        (void)scene.join(scene.define(JointKind::Revolute, above, bodies.back(), {1.0 * i, 0.0}));
        above = bodies.back();
    }
    const auto energy = [&] {
        double sum = 0.0;
        for (const BodyId body : bodies) sum += scene.energyOf(body);
        return sum;
    };
    const double before = energy(), height = 12.5 * static_cast<double>(JointWorld::kGravity);
    for (int i = 0; i < 600; ++i) {
        scene.run(JointWorld::kDt);
        ASSERT_NEAR(energy(), before, 0.02 * height) << i;  // the end of the chain whips
    }
}

TEST(JointTrees, inFreeFlightConserveMomentumAndFallFreely) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        JointWorld scene;
        (void)growTree(scene, random, {0.0, 0.0}, false);
        const auto middle = [&] {
            Vec2 sum;
            float mass = 0.0f;
            for (std::uint32_t i = 1; i < scene.world.bodies.size(); ++i) {
                sum += scene.world.bodies.mass[i].mass * toVec2(scene.world.bodies.pose[i].centre);
                mass += scene.world.bodies.mass[i].mass;
            }
            return sum / mass;
        };
        scene.run(JointWorld::kDt);  // corrects initial errors
        const Vec2 before = middle();
        const float v = 0.5f * JointWorld::kGravity;
        scene.run(1.0f);
        EXPECT_NEAR(middle().x, before.x, 1.0e-3f);
        EXPECT_NEAR(middle().y, before.y - v * (1.0f + 2.0f * JointWorld::kDt), 2.0e-3f);
    }
}

TEST(JointTrees, giveTheSameBitsForAnyNumberOfThreadsAndFromASnapshot) {
    std::uint64_t hashes[2];
    for (const bool threads : {false, true}) {
        Random random = Random::seeded(3);
        JointWorld scene;
        for (int i = 0; i < 40; ++i) (void)growTree(scene, random, {20.0 * i, 0.0}, i % 3 != 0);
        TaskPool pool{3};
        if (threads) scene.options = {.pool = &pool, .minimumWork = 0};
        scene.run(0.5f);
        const World saved = scene.world;
        scene.run(0.5f);
        hashes[threads ? 1 : 0] = hashOf(scene.world);
        scene.world = saved;
        scene.run(0.5f);
        EXPECT_EQ(hashOf(scene.world), hashes[threads ? 1 : 0]);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(JointTrees, leaveNoTraceWhenDestroyed) {
    JointWorld scene;
    Random random = Random::seeded(9);
    for (const JointId joint : growTree(scene, random, {0.0, 0.0}, true)) {
        scene.run(0.1f);
        destroyJoint(scene.world, joint);
    }
    std::vector<BodyId> discs;
    for (int i = 0; i < 100; ++i) discs.push_back(scene.disc({100.0 + i, 0.0}));
    scene.run(1.0f);
    for (const BodyId disc : discs) EXPECT_NEAR(scene.place(disc).y, -0.5f * JointWorld::kGravity, 1.0e-4f);
}

TEST(JointTrees, doNotRequireMoreSubsteps) {
    JointWorld scene;
    scene.world.settings.automaticQuality = true;
    BodyId above = scene.ground;
    for (int i = 0; i < 40; ++i) {
        const BodyId link = scene.disc({0.5 + i, 0.0}, i < 39 ? 0.1f : 100.0f);
        (void)scene.join(scene.define(JointKind::Revolute, above, link, {1.0 * i, 0.0}));
        above = link;
    }
    scene.run(0.1f);
    EXPECT_TRUE(solvesTrees(scene));
    EXPECT_EQ(scene.world.work.get().groups.front().quality, scene.world.settings.quality);
}

TEST(JointTrees, hangFromMovingBodies) {
    JointWorld scene;
    BodyDefinition definition;
    definition.kind = BodyKind::Kinematic;
    definition.velocity = {2.0f, 1.0f};
    definition.angularVelocity = 3.0f;
    const BodyId crane = *createBody(scene.world, definition);
    BodyId above = crane;
    std::vector<JointId> joints;
    for (int i = 0; i < 6; ++i) {
        const BodyId link = scene.disc({0.5 + i, 0.0});
        joints.push_back(scene.join(scene.define(JointKind::Revolute, above, link, {0.3 + i, 0.0})));
        above = link;
    }
    scene.run(5.0f);
    EXPECT_TRUE(solvesTrees(scene));
    EXPECT_NEAR(scene.place(crane).x, 10.0f, 0.01f);
    EXPECT_LT(worstGap(scene, joints), 0.002f);
}

TEST(JointTrees, excludeLoopsAndSprings) {
    for (const bool loop : {false, true}) {
        JointWorld scene;
        const BodyId a = scene.disc({0.5, 0.0}), b = scene.disc({0.5, -1.0}), c = scene.disc({1.5, -1.0});
        const auto tie = [&](BodyId one, BodyId other, WorldPosition at) {
            JointDefinition definition = scene.define(JointKind::Revolute, one, other, at);
            definition.spring = {!loop, 2.0f, 0.5f};
            (void)scene.join(definition);
        };
        tie(scene.ground, a, {0.0, 0.0});
        tie(a, b, {0.5, -0.5});
        tie(b, c, {1.0, -1.0});
        if (loop) tie(c, a, {1.0, -0.5});
        scene.run(0.1f);
        EXPECT_FALSE(solvesTrees(scene));
    }
}

TEST(JointTrees, useTheIterativeSolverWhileInContact) {
    JointWorld scene;
    BodyId above = scene.ground;
    std::vector<BodyId> discs;
    for (int i = 0; i < 4; ++i) {
        BodyDefinition definition;
        definition.position = {0.5 + i, 0.0};
        discs.push_back(*createBody(scene.world, definition));
        (void)createShape(scene.world, discs.back(), circle(0.4f));
        (void)scene.join(scene.define(JointKind::Revolute, above, discs.back(), {1.0 * i, 0.0}));
        above = discs.back();
    }
    scene.run(0.1f);
    EXPECT_TRUE(solvesTrees(scene));
    BodyDefinition floor;
    floor.kind = BodyKind::Static;
    floor.position = {0.0, -3.0};
    (void)createShape(scene.world, *createBody(scene.world, floor), box({20.0f, 1.0f}));
    scene.run(5.0f);
    EXPECT_FALSE(solvesTrees(scene));
    for (const BodyId disc : discs) EXPECT_GT(scene.place(disc).y, -1.7f);
}

TEST(JointTrees, gainNoEnergyWhenTheyWhip) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        JointWorld scene;
        scene.world.settings.quality = static_cast<Quality>(seed % 4);
        std::vector<BodyId> discs;
        BodyId above = scene.ground;
        for (int i = 0; i < 10; ++i) {
            discs.push_back(scene.disc({0.5 + i, 0.0}, random.below(4) == 0 ? 20.0f : 0.2f));
            (void)scene.join(scene.define(JointKind::Revolute, above, discs.back(), {1.0 * i, 0.0}));
            above = discs.back();
        }
        double mass = 0.0;
        for (const BodyId disc : discs) mass += static_cast<double>(scene.world.bodies.mass[disc.index].mass);
        for (int i = 0; i < 600; ++i) {
            scene.run(JointWorld::kDt);
            double energy = 0.0;
            for (const BodyId disc : discs) energy += scene.energyOf(disc);
            ASSERT_LT(energy, 0.05 * mass * static_cast<double>(JointWorld::kGravity) * 10.0) << i;
        }
    }
}

/// Adds a plank of the bridge or a crate; planks do not collide with each other.
BodyId addBox(JointWorld& scene, WorldPosition at, Vec2 half, float angle, float density,
              std::int16_t group) {
    BodyDefinition definition;
    definition.position = at;
    definition.angle = angle;
    const BodyId body = *createBody(scene.world, definition);
    ShapeDefinition shape;
    shape.density = density;
    shape.group = group;
    (void)*createShape(scene.world, body, box(half), shape);
    return body;
}

/// Builds a bridge of thirty planks of 1 m between two posts 29.8 m apart, initially in the shape of a V.
void buildBridge(JointWorld& scene) {
    const float across = 14.9f, down = std::sqrt(15.0f * 15.0f - across * across);
    const Vec2 left = Vec2{across, -down} / 15.0f, right = Vec2{across, down} / 15.0f;
    BodyId last = scene.ground;
    Vec2 at{-across, 0.0f};
    for (int i = 0; i < 30; ++i) {
        const Vec2 along = i < 15 ? left : right;
        const float slope = arcTangent(along.y, along.x);
        const BodyId plank = addBox(scene, WorldPosition{at + 0.5f * along}, {0.5f, 0.125f}, slope, 1.0f, -1);
        JointDefinition definition = scene.define(JointKind::Revolute, last, plank, WorldPosition{at});
        definition.anchorA = i == 0 ? at : Vec2{0.5f, 0.0f};
        definition.anchorB = {-0.5f, 0.0f};
        (void)scene.join(definition);
        last = plank;
        at += along;
    }
    JointDefinition end = scene.define(JointKind::Revolute, last, scene.ground, WorldPosition{at});
    end.anchorA = {0.5f, 0.0f};
    (void)scene.join(end);
}

TEST(JointTrees, doNotEjectBodiesThatFallOnABridge) {
    JointWorld scene;
    buildBridge(scene);
    scene.run(3.0f);
    EXPECT_TRUE(solvesTrees(scene));
    std::vector<BodyId> crates;
    for (int i = 0; i < 8; ++i)
        crates.push_back(addBox(scene, {-7.0 + 2.0 * i, 1.5}, {0.4f, 0.4f}, 0.0f, 20.0f, 0));
    for (int i = 0; i < 600; ++i) {
        scene.run(JointWorld::kDt);
        for (const BodyId crate : crates) {
            ASSERT_LT(length(velocityOf(scene.world, crate)), 20.0f) << i;
            ASSERT_GT(scene.place(crate).y, -10.0f) << i;
        }
    }
}

TEST(JointTrees, breakAtTheOverloadedJoint) {
    for (const float strength : {0.98f, 1.02f}) {
        SCOPED_TRACE(strength);
        JointWorld scene;
        const BodyId top = scene.disc({0.0, -1.0}), low = scene.disc({0.0, -2.0}, 9.0f);
        (void)scene.join(scene.define(JointKind::Revolute, scene.ground, top, {0.0, -0.5}));
        JointDefinition definition = scene.define(JointKind::Revolute, top, low, {0.0, -1.5});
        definition.breakForce = strength * 9.0f * JointWorld::kGravity;
        const JointId joint = scene.join(definition);
        scene.run(1.0f);
        EXPECT_EQ(alive(scene.world, joint), strength > 1.0f);
    }
}

}  // namespace
}  // namespace plumb::physics
