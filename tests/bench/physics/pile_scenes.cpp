// Scenes of boxes and circles that are piled up in a container, or fall on floors in any number.

#include <algorithm>

#include "tests/bench/physics/scenes.hpp"

namespace plumb::scenes {

namespace {

constexpr float kHalf = 0.25f;  // m: half of the side of a box, radius of a circle

Outline outlineOf(bool isCircle) { return isCircle ? circle(kHalf) : box({kHalf, kHalf}); }

/// Maximum number of bodies per floor, so that the density of bodies is the same in scenes of every size.
constexpr int kFloor = 2000;
constexpr float kFloorHalfWidth = 105.0f;  // m
constexpr float kStorey = 30.0f;           // m

/// Returns the initial position of body `i` of a floor, m from the middle of the floor.
using Place = Vec2 (*)(int i);

/// Returns positions in ten rows of 200, 1 m apart.
Vec2 uniformPlace(int i) {
    constexpr int kColumns = 200;
    return {static_cast<float>(i % kColumns) - 99.5f, 1.0f + static_cast<float>(i / kColumns)};
}

/// Returns positions in five towers of 20 by 20 bodies that almost touch.
Vec2 clusteredPlace(int i) {
    constexpr int kSide = 20;
    constexpr float kPitch = 0.51f;  // m
    const int tower = i / (kSide * kSide);
    const int rest = i % (kSide * kSide);
    return {40.0f * static_cast<float>(tower - 2) + kPitch * static_cast<float>(rest % kSide),
            0.5f + kPitch * static_cast<float>(rest / kSide)};
}

BeforeStep buildFalling(SceneBuilder& world, int bodies, bool circles, Place placeOf) {
    const BodyHandle ground = world.createBody({.motion = Motion::Static});
    for (int first = 0; first < bodies; first += kFloor) {
        const float y = kStorey * static_cast<float>(first / kFloor);
        world.addShape(ground, box({kFloorHalfWidth, 0.5f}, {0.0f, y - 0.5f}));
        for (int i = 0; i < std::min(kFloor, bodies - first); ++i)
            world.addShape(world.createBody({.position = placeOf(i) + Vec2{0.0f, y}}), outlineOf(circles));
    }
    return {};
}

}  // namespace

BeforeStep buildPile(SceneBuilder& world, int bodies) {
    const bool large = bodies > 1000;
    const int perRow = large ? 70 : 19;
    const float wall = large ? 26.0f : 8.0f;  // m from the middle
    constexpr float kPitch = 0.7f;            // m
    constexpr float kShift = 0.1f;            // m: rows are shifted alternately to the left and right
    const BodyHandle ground = world.createBody({.motion = Motion::Static});
    world.addShape(ground, box({wall + 4.0f, 1.0f}, {0.0f, -1.0f}));
    for (const float x : {-wall, wall}) world.addShape(ground, box({1.0f, 60.0f}, {x, 60.0f}));
    const float left = -0.5f * kPitch * static_cast<float>(perRow - 1);
    for (int i = 0; i < bodies; ++i) {
        const int row = i / perRow;
        const Vec2 place{left + kPitch * static_cast<float>(i % perRow) + (row % 2 == 0 ? kShift : -kShift),
                         1.0f + kPitch * static_cast<float>(row)};
        world.addShape(world.createBody({.position = place}), outlineOf(i % 2 == 1));
    }
    return {};
}

BeforeStep buildUniformBoxes(SceneBuilder& world, int bodies) {
    return buildFalling(world, bodies, false, &uniformPlace);
}
BeforeStep buildUniformCircles(SceneBuilder& world, int bodies) {
    return buildFalling(world, bodies, true, &uniformPlace);
}
BeforeStep buildClusteredBoxes(SceneBuilder& world, int bodies) {
    return buildFalling(world, bodies, false, &clusteredPlace);
}
BeforeStep buildClusteredCircles(SceneBuilder& world, int bodies) {
    return buildFalling(world, bodies, true, &clusteredPlace);
}

/// Builds boxes at rest that do not touch each other, 250 per floor.
BeforeStep buildSleepers(SceneBuilder& world, int bodies) {
    constexpr int kPerFloor = 250;
    constexpr float kPitch = 0.8f;   // m
    constexpr float kHeight = 5.0f;  // m
    const BodyHandle ground = world.createBody({.motion = Motion::Static});
    for (int i = 0; i < bodies; ++i) {
        const float y = kHeight * static_cast<float>(i / kPerFloor);
        if (i % kPerFloor == 0) world.addShape(ground, box({kFloorHalfWidth, 0.5f}, {0.0f, y - 0.5f}));
        const float x = kPitch * (static_cast<float>(i % kPerFloor) - 0.5f * kPerFloor);
        world.addShape(world.createBody({.position = {x, y + kHalf}}), outlineOf(false));
    }
    return {};
}

}  // namespace plumb::scenes
