// Tests that the five teaching scenes show what their texts state.

#include <cmath>

#include "physics/measure/measures.hpp"
#include "scene/drawing/plot_drawing.hpp"
#include "scene/lab.hpp"
#include "scene/number_field.hpp"
#include "tests/app/playground/playground.hpp"

namespace plumb {
namespace {

constexpr const char* kScenes[] = {"springs", "substeps", "masses", "bullets", "bits"};

struct Laboratory : Playground {
    explicit Laboratory(const std::string& scene) : Playground{scene, "physics-lab"} {}

    const PlotPast::Curve& curve(std::string_view plot, std::string_view ghost = {}) {
        const auto* curve =
            game.world.resource<PlotPast>().find(find(plot), ghost.empty() ? EntityId{} : find(ghost));
        EXPECT_NE(curve, nullptr) << plot << ": " << ghost;
        static const PlotPast::Curve kNone;
        return curve != nullptr ? *curve : kNone;
    }
    float last(std::string_view plot, std::string_view ghost = {}) {
        const auto& values = curve(plot, ghost).values;
        return values.empty() ? NAN : values.back();
    }
    /// Presses the mouse on a slider at the fraction `part` of its length and releases it after some ticks.
    void drag(std::string_view slider, float part, int ticks = 2) {
        const EntityId entity = find(slider);
        const Vec2 start = std::as_const(game.world).get<Transform>(entity).position;
        const float width = std::as_const(game.world).get<Slider>(entity).width;
        frame.setMouse(start + Vec2{width * part + 0.5f, 0.5f});
        frame.mouseButtons = 1u << static_cast<unsigned>(MouseButton::Left);
        run(ticks);
        frame.mouseButtons = 0;
        run(1);
    }
    const ScenePhysics& physics() { return std::as_const(game.world).get<ScenePhysics>(find("how exact")); }
};

TEST(PhysicsLab, springsShowTheEnergyErrorOfTheirIntegrator) {
    Laboratory lab{"springs"};
    lab.run(121);
    // 5053 px/s2 at 1 m = 128 px: omega^2 = 39.5/s2, so explicit Euler multiplies the energy by 1.011 per
    // tick.
    EXPECT_NEAR(lab.last("energy", "explicit Euler") / std::pow(1.0 + 5053.0 / 128.0 / 3600.0, 120), 1.0,
                0.02);
    EXPECT_NEAR(lab.last("energy"), 1.0f, 0.06f) << "semi-implicit Euler oscillates around 1";
    EXPECT_NEAR(lab.last("energy", "velocity Verlet"), 1.0f, 0.01f);
    EXPECT_NEAR(lab.last("energy", "Runge-Kutta 4"), 1.0f, 1e-4f);
}

TEST(PhysicsLab, ofThreeTowersOfEqualCostTheOneWithMostSubstepsStands) {
    Laboratory lab{"substeps"};
    lab.run(360);
    EXPECT_LT(lab.last("overlap", "8 x 1"), 3.0f);
    EXPECT_GT(lab.last("overlap", "2 x 4"), 2.0f * lab.last("overlap", "8 x 1"));
    const float highest = -lab.at("crate 14").y;
    EXPECT_LT(highest, -400.0f) << "the tower of one substep must fall";
}

TEST(PhysicsLab, moreSubstepsSinkLess) {
    Laboratory lab{"masses"};
    lab.run(300);
    EXPECT_GT(lab.last("overlap", "1 substep"), 5.0f * lab.last("overlap"));
    EXPECT_GT(lab.last("overlap"), 5.0f * lab.last("overlap", "16 substeps"));
    EXPECT_LT(lab.last("overlap", "automatic"), lab.last("overlap"));
}

TEST(PhysicsLab, onlyTheBallWithContinuousDetectionIsStoppedByTheWall) {
    Laboratory lab{"bullets"};
    for (const float part : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f}) {
        lab.drag("speed", part);
        lab.run(240);
        EXPECT_LT(lab.at("ball").x, 820.0f) << "slider at " << part << " of its length";
        EXPECT_GT(lab.at("ball").x, 40.0f);
    }
    EXPECT_GT(std::fabs(lab.last("place", "without") - 3.4f), 3.5f) << "the other ball must pass a wall";
}

TEST(PhysicsLab, equalStartsGiveEqualBitsAndDifferentStartsDoNot) {
    Laboratory lab{"bits"};
    std::size_t touched = 0;
    for (int i = 0; i < 300; ++i) {
        lab.run(1);
        touched += lab.game.world.resource<PhysicsState>().world.contacts.size();
        ASSERT_TRUE(lab.curve("distance", "the same again").same) << "tick " << i;
    }
    EXPECT_GT(touched, 1000u);
    EXPECT_FALSE(lab.curve("distance", "one ball moved").same);
    EXPECT_GT(lab.last("distance", "one ball moved"), 1.0f) << "mm, after a start that differs by 1e-7 px";
}

TEST(PhysicsLab, releasingASliderRestartsTheExperiment) {
    Laboratory lab{"masses"};
    lab.run(100);
    EXPECT_GT(lab.curve("overlap").values.size(), 90u);
    const Vec2 began = lab.game.world.resource<Lab>().starts.back().transform.position;
    lab.drag("quality", 1.0f, 5);
    EXPECT_EQ(lab.physics().quality, 6);
    EXPECT_EQ(lab.curve("overlap").values.size(), 1u);
    EXPECT_LT(length(lab.at("heavy") - began), 1.0f);
    lab.drag("weight", 0.0f);
    EXPECT_FLOAT_EQ(std::as_const(lab.game.world).get<RigidBody>(lab.find("heavy")).mass, 1.0f);
    lab.drag("weight", 1.0f);
    EXPECT_NEAR(std::as_const(lab.game.world).get<RigidBody>(lab.find("heavy")).mass, 1e4f, 1.0f);
    lab.hold(Key::R, 1);
    EXPECT_NEAR(std::as_const(lab.game.world).get<RigidBody>(lab.find("heavy")).mass, 1e4f, 1.0f)
        << "a reset (R) keeps the values of sliders";
    EXPECT_EQ(lab.physics().quality, 6);
}

TEST(PhysicsLab, ghostsChangeNoBitOfTheScene) {
    for (const char* scene : kScenes) {
        Laboratory with{scene}, without{scene};
        for (const EntityId ghost : without.all("")) {
            if (without.game.world.has<Ghost>(ghost)) without.game.world.remove<Ghost>(ghost);
        }
        with.run(120), without.run(120);
        EXPECT_EQ(physics::hashOf(with.game.world.resource<PhysicsState>().world),
                  physics::hashOf(without.game.world.resource<PhysicsState>().world))
            << scene;
        EXPECT_TRUE(without.game.world.resource<GhostWorlds>().all.empty() ||
                    without.game.world.findResource<GhostWorlds>() != nullptr);
    }
}

TEST(PhysicsLab, labSystemsExistOnlyInScenesThatUseThem) {
    Playground pyramid{"pyramid"};
    pyramid.run(10);
    EXPECT_EQ(pyramid.game.world.findResource<Lab>(), nullptr);
    EXPECT_EQ(pyramid.game.world.findResource<GhostWorlds>(), nullptr);
    EXPECT_EQ(pyramid.game.world.findResource<PlotPast>(), nullptr);
}

TEST(PhysicsLab, aRestoredSnapshotContinuesEqually) {
    Laboratory lab{"bits"};
    lab.run(60);
    const Snapshot past = lab.game.world.save();
    lab.run(60);
    const std::uint64_t hash = lab.game.world.hash();
    const float distance = lab.last("distance", "one ball moved");
    lab.game.world.restore(past);
    lab.run(60);
    EXPECT_EQ(lab.game.world.hash(), hash);
    EXPECT_EQ(lab.last("distance", "one ball moved"), distance) << "ghosts are restored too";
}

TEST(NumberFields, areFoundReadAndWrittenByName) {
    TypeRegistry types;
    types.add<ScenePhysics>();
    types.add<RigidBody>();
    ScenePhysics physics;
    const auto set = [&](std::string_view path, float value) {
        const auto number = NumberField::find(types, "ScenePhysics", path);
        ASSERT_TRUE(number) << path;
        number->write(&physics, value);
    };
    set("gravity.y", 12.5f), set("quality", 9.0f), set("iterations", 2.6f), set("sleeping", 0.0f),
        set("integrator", 3.0f);
    EXPECT_EQ(physics.gravity, (Vec2{0.0f, 12.5f}));
    EXPECT_EQ(physics.quality, 6) << "clamped to the field's maximum";
    EXPECT_EQ(physics.iterations, 3);
    EXPECT_FALSE(physics.sleeping);
    EXPECT_EQ(physics.integrator, physics::IntegratorKind::Rk4);
    EXPECT_EQ(NumberField::find(types, "ScenePhysics", "integrator")->read(&physics), 3.0f);
    for (const char* path : {"gravity", "gravity.z", "quality.x", "nothing", ""})
        EXPECT_FALSE(NumberField::find(types, "ScenePhysics", path)) << path;
    EXPECT_FALSE(NumberField::find(types, "Nothing", "quality"));
    struct Signs {
        std::int8_t below = -3;
        std::uint32_t bits = 0xfffffff0u;
        static void describe(TypeBuilder<Signs>& type) {
            type.name("Signs");
            type.field<&Signs::below>("below");
            type.field<&Signs::bits>("bits");
        }
    };
    types.add<Signs>();
    Signs signs;
    EXPECT_EQ(NumberField::find(types, "Signs", "below")->read(&signs), -3.0f);
    EXPECT_GT(NumberField::find(types, "Signs", "bits")->read(&signs), 4.0e9f);
    NumberField::find(types, "Signs", "below")->write(&signs, -7.0f);
    EXPECT_EQ(signs.below, -7);
}

TEST(RoughNumbers, haveThreeDigits) {
    for (const auto& [value, text] : {std::pair{0.0f, "0"},
                                      {1.0f, "1"},
                                      {12.34f, "12.3"},
                                      {0.01234f, "0.0123"},
                                      {1250.0f, "1250"},
                                      {3e-7f, "3e-7"},
                                      {2.5e7f, "2.5e7"},
                                      {-4.0f, "-4"},
                                      {100.0f, "100"}})
        EXPECT_EQ(roughNumber(value), text);
}

}  // namespace
}  // namespace plumb
