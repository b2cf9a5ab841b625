#include <array>

#include "tests/physics/support/world_of_bodies.hpp"

// Compliance of contacts under a load: Settings::contactStiffness.

namespace plumb::physics {
namespace {

/// Penetration of an effective mass under a load, with substeps of h seconds, m.
double pressedIn(const World& world, double load, double mass, double h) {
    const double turns = 2.0 * 3.14159265358979 * static_cast<double>(world.settings.contactStiffness);
    return load * h * h / (mass * turns * turns);
}

TEST(ContactStiffness, isTheSameOnTheGroundAndBetweenBodies) {
    for (const Quality quality : std::array<Quality, 3>{1, 2, 4}) {
        SCOPED_TRACE(int{quality});
        Playground scene;
        scene.world.settings.quality = quality;
        scene.world.settings.sleeping = false;
        scene.floor();
        const BodyId low = scene.ball({0.0, 0.5}), high = scene.ball({0.0, 1.5});
        scene.run(180);
        const double h = 1.0 / (60.0 * static_cast<double>(1 << quality));
        const double mass = static_cast<double>(scene.world.bodies.mass[low.index].mass);
        const double weight = 10.0 * mass;
        const double onGround = pressedIn(scene.world, 2.0 * weight, mass, h);
        const double between = pressedIn(scene.world, weight, 0.5 * mass, h);  // both bodies are compliant
        EXPECT_NEAR(0.5 - scene.y(low), onGround, 0.02 * onGround);
        EXPECT_NEAR(1.0 - (scene.y(high) - scene.y(low)), between, 0.02 * between);
    }
}

}  // namespace
}  // namespace plumb::physics
