#include "tests/bench/physics/scenes.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "tests/bench/physics/report.hpp"
#include "tests/bench/physics/scene_error.hpp"

namespace plumb::scenes {
namespace {

/// An engine without simulation: its objects can be counted and stay at their initial positions.
class StillWorld final : public SceneBuilder {
public:
    void moveTo(BodyHandle, Vec2, float, float) override {}
    void setPosition(BodyHandle, Vec2, float) override {}
    void setSpin(BodyHandle, float) override {}
    void setMass(BodyHandle, float) override {}
    void setVelocity(BodyHandle, Vec2) override {}
    void step(float) override {}
    [[nodiscard]] Pose poseOf(BodyHandle body) const override { return poses_[body.index]; }
    [[nodiscard]] Vec2 velocityOf(BodyHandle) const override { return {}; }
    [[nodiscard]] float spinOf(BodyHandle) const override { return 0.0f; }
    [[nodiscard]] std::size_t contactCount() const override { return 0; }

protected:
    void makeBody(BodyHandle, const BodySetup& setup) override {
        poses_.push_back({static_cast<double>(setup.position.x), static_cast<double>(setup.position.y)});
    }
    void makeShape(BodyHandle, const Outline&, const Material&) override {}
    void makeLoop(BodyHandle, std::span<const Vec2>, const Material&) override {}
    void makeJoint(const JointSetup&) override {}
    void dropBody(BodyHandle) override {}

private:
    std::vector<Pose> poses_;
};

struct Counts {
    std::size_t bodies = 0;
    std::size_t dynamic = 0;
    std::size_t shapes = 0;
    std::size_t hinges = 0;
    friend bool operator==(const Counts&, const Counts&) = default;
};

void PrintTo(const Counts& counts, std::ostream* out) {
    *out << counts.bodies << " bodies, " << counts.dynamic << " dynamic, " << counts.shapes << " shapes, "
         << counts.hinges << " hinges";
}

Counts countsOf(const SceneBuilder& world) {
    Counts counts;
    for (const auto& body : world.bodies()) {
        counts.bodies += body.alive ? 1 : 0;
        counts.dynamic += body.alive && body.motion == Motion::Dynamic ? 1 : 0;
    }
    for (const auto& shape : world.shapes()) counts.shapes += world.alive(shape.body) ? 1 : 0;
    for (const auto& hinge : world.joints())
        counts.hinges += world.alive(hinge.a) && world.alive(hinge.b) ? 1 : 0;
    return counts;
}

void play(const Scene& scene, SceneBuilder& world, int steps) {
    const BeforeStep before = scene.build(world, scene.size);
    for (int step = 0; step < steps && before; ++step) before(world, step);
}

// The ten benchmark scenes must have the published numbers of objects, after all steps.
TEST(Scenes, theTenScenesHaveTheirPublishedCounts) {
    const std::map<std::string, Counts> published{{"joint_grid", {10000, 9993, 10000, 19800}},
                                                  {"large_pyramid", {5051, 5050, 5051, 0}},
                                                  {"many_pyramids", {22001, 22000, 22020, 0}},
                                                  {"rain", {11001, 11000, 15505, 10000}},
                                                  {"smash", {9601, 9601, 9601, 0}},
                                                  {"spinner", {6078, 6077, 6437, 1}},
                                                  {"tumbler", {2027, 2026, 2029, 1}},
                                                  {"washer", {8102, 8100, 8140, 0}},
                                                  {"junkyard", {8002, 8000, 8262, 0}},
                                                  {"compounds", {3001, 3000, 6282, 0}}};
    for (const auto& [name, counts] : published) {
        SCOPED_TRACE(name);
        const Scene* scene = findScene(name);
        ASSERT_NE(scene, nullptr);
        StillWorld world;
        play(*scene, world, scene->steps);
        EXPECT_EQ(countsOf(world), counts);
    }
}

TEST(Scenes, namesAreUnique) {
    std::map<std::string, int> names;
    for (const Scene& scene : allScenes()) ++names[scene.name];

    for (const auto& [name, count] : names) EXPECT_EQ(count, 1) << name;
    EXPECT_GE(names.size(), 30u);
}

TEST(Scenes, scalableScenesHaveTheStatedNumberOfDynamicBodies) {
    for (const Scene& scene : allScenes()) {
        if (scene.group != SceneGroup::Scaling || scene.size > 10000) continue;
        SCOPED_TRACE(scene.name);
        StillWorld world;
        play(scene, world, 1);
        EXPECT_EQ(countsOf(world).dynamic, static_cast<std::size_t>(scene.size));
    }
}

// Stacks must start exactly in contact and grids exactly joined; otherwise the error of the scene would be
// attributed to the engines.
TEST(Scenes, stacksAndJointsStartWithoutError) {
    for (const char* name : {"joint_grid", "large_pyramid", "many_pyramids", "tumbler", "washer", "pile500",
                             "stacks200", "boxes20", "boxes_clustered_1000", "circles_uniform_1000"}) {
        SCOPED_TRACE(name);
        const Scene* scene = findScene(name);
        ASSERT_NE(scene, nullptr);
        StillWorld world;
        play(*scene, world, 1);
        const SceneError error = errorOf(world);
        EXPECT_LE(error.maxPenetration, kNoticed);
        EXPECT_LE(error.maxJointError, 1e-5);
    }
}

TEST(Scenes, aFallingRagdollIsBuiltWithItsJointsClosed) {
    StillWorld world;
    play(*findScene("rain"), world, 1);

    EXPECT_EQ(countsOf(world).hinges, 250u);
    EXPECT_LE(errorOf(world).maxJointError, 2e-5);  // rounding of floats 220 m above the origin
}

TEST(SceneError, detectsOverlapsOpenJointsAndInvalidNumbers) {
    StillWorld world;
    const BodyHandle a = world.createBody({});
    const BodyHandle b = world.createBody({.position = {0.9f, 0.0f}});
    world.addShape(a, box({0.5f, 0.5f}));
    world.addShape(b, box({0.5f, 0.5f}));

    SceneError error = errorOf(world);
    EXPECT_NEAR(error.maxPenetration, 0.1, 1e-6);
    EXPECT_EQ(error.overlaps, 1u);

    world.addJoint({.a = a, .b = b, .anchorA = {0.5f, 0.0f}, .anchorB = {-0.5f, 0.3f}});
    error = errorOf(world);
    EXPECT_EQ(error.overlaps, 0u);  // overlaps of joined bodies are not counted
    EXPECT_NEAR(error.maxJointError, std::hypot(0.1, 0.3), 1e-6);
    EXPECT_TRUE(error.holds());

    world.addJoint({.a = a, .b = b, .anchorA = {0.0f, 5.0f}});
    EXPECT_FALSE(errorOf(world).holds());

    world.createBody({.position = {NAN, 0.0f}});
    EXPECT_FALSE(errorOf(world).finite);
}

TEST(Report, theExponentOfAPowerLawIsItsPower) {
    for (const double power : {0.5, 1.0, 1.07, 2.0}) {
        std::vector<Measurement> rows;
        for (const int size : {100, 1000, 10000, 100000}) {
            Measurement row;
            row.size = size;
            row.quietMs = 0.003 * std::pow(size, power);
            rows.push_back(row);
        }
        EXPECT_NEAR(exponentOf(rows), power, 1e-9);
    }
}

}  // namespace
}  // namespace plumb::scenes
