// Scenes of stacked boxes, and of single boxes.

#include "tests/bench/physics/scenes.hpp"

namespace plumb::scenes {

namespace {

constexpr Vec2 kUnitHalf{0.5f, 0.5f};  // m

void addBox(SceneBuilder& world, Vec2 position) {
    world.addShape(world.createBody({.position = position}), box(kUnitHalf));
}

void addGround(SceneBuilder& world, float halfWidth) {
    const BodyHandle ground = world.createBody({.motion = Motion::Static, .position = {0.0f, -1.0f}});
    world.addShape(ground, box({halfWidth, 1.0f}));
}

/// Adds a pyramid of unit boxes with `base` boxes in the lowest row. @param left  lower left corner, m
void addPyramid(SceneBuilder& world, int base, Vec2 left) {
    for (int i = 0; i < base; ++i) {
        const float y = left.y + static_cast<float>(i) + 0.5f;
        for (int j = i; j < base; ++j)
            addBox(world, {left.x + 0.5f * static_cast<float>(i + 1) + static_cast<float>(j - i), y});
    }
}

}  // namespace

BeforeStep buildLargePyramid(SceneBuilder& world, int base) {
    addGround(world, static_cast<float>(base));
    addPyramid(world, base, {-0.5f * static_cast<float>(base), 0.0f});
    return {};
}

BeforeStep buildManyPyramids(SceneBuilder& world, int side) {
    constexpr int kBase = 10;
    constexpr float kPitch = kBase + 1.0f;  // m between pyramids and between floors
    const float halfWidth = 0.5f * kPitch * static_cast<float>(side);
    const BodyHandle ground = world.createBody({.motion = Motion::Static});
    for (int i = 0; i < side; ++i) {
        const float y = kPitch * static_cast<float>(i);
        world.addShape(ground, segment({-halfWidth, y}, {halfWidth, y}));
    }
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j)
            addPyramid(
                world, kBase,
                {-halfWidth + kPitch * static_cast<float>(j) + kUnitHalf.x, kPitch * static_cast<float>(i)});
    }
    return {};
}

BeforeStep buildStacks(SceneBuilder& world, int boxes) {
    constexpr int kHeight = 10;
    constexpr float kPitch = 4.0f;  // m
    const int stacks = boxes / kHeight;
    const float halfWidth = 0.5f * kPitch * static_cast<float>(stacks);
    addGround(world, halfWidth);
    for (int i = 0; i < stacks; ++i) {
        const float x = kPitch * (static_cast<float>(i) + 0.5f) - halfWidth;
        for (int j = 0; j < kHeight; ++j) addBox(world, {x, static_cast<float>(j) + 0.5f});
    }
    return {};
}

BeforeStep buildBoxes(SceneBuilder& world, int boxes) {
    constexpr float kPitch = 3.0f;  // m
    const float halfWidth = 0.5f * kPitch * static_cast<float>(boxes);
    addGround(world, halfWidth);
    for (int i = 0; i < boxes; ++i)
        addBox(world, {kPitch * (static_cast<float>(i) + 0.5f) - halfWidth, 0.5f});
    return {};
}

}  // namespace plumb::scenes
