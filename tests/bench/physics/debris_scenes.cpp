// Scenes of many loose bodies that are hit by a heavy body, pushed, or fall on each other.

#include "math/portable.hpp"
#include "tests/bench/physics/scenes.hpp"

namespace plumb::scenes {

namespace {

/// Adds a floor at height 0 and walls above it, made of boxes of about 1 m that overlap slightly.
BodyHandle addTrough(SceneBuilder& world, int halfWidth, int height) {
    const BodyHandle ground = world.createBody({.motion = Motion::Static});
    for (int i = -halfWidth; i <= halfWidth; ++i)
        world.addShape(ground, box({0.55f, 0.5f}, {static_cast<float>(i), 0.0f}));
    for (const int x : {-halfWidth, halfWidth}) {
        for (int i = 1; i <= height; ++i)
            world.addShape(ground, box({0.5f, 0.55f}, {static_cast<float>(x), static_cast<float>(i)}));
    }
    return ground;
}

}  // namespace

BeforeStep buildSmash(SceneBuilder& world, int columns) {
    constexpr float kSide = 0.4f;  // m
    constexpr int kRows = 80;
    const BodyHandle ball = world.createBody({.position = {-20.0f, 0.0f}, .velocity = {40.0f, 0.0f}});
    world.addShape(ball, box({4.0f, 4.0f}), {.density = 8.0f});
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < kRows; ++j) {
            const Vec2 place{30.0f + kSide * static_cast<float>(i),
                             kSide * static_cast<float>(j - kRows / 2)};
            world.addShape(world.createBody({.position = place, .awake = false}),
                           box({0.5f * kSide, 0.5f * kSide}));
        }
    }
    return {};
}

BeforeStep buildJunkyard(SceneBuilder& world, int rows) {
    constexpr int kColumns = 200;
    constexpr float kRadius = 0.25f;                    // m
    constexpr float kTurn = 1.2360679774997897f * kPi;  // (sqrt(5) - 1) * pi: makes an irregular polygon
    constexpr float kReach = 60.0f;                     // m
    addTrough(world, 80, 50);
    std::array<Vec2, 5> points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SinCos rotation = sinCos(kTurn * static_cast<float>(i));
        points[i] = kRadius * Vec2{rotation.cos, rotation.sin};
    }
    const Outline scrap = polygon(points);
    float side = -0.1f;
    for (int i = 0; i < kColumns; ++i) {
        for (int j = 0; j < rows; ++j) {
            const Vec2 place{0.75f * static_cast<float>(i) - 75.0f + side, 15.0f + static_cast<float>(j)};
            side = -side;
            world.addShape(world.createBody({.position = place}), scrap);
        }
    }
    const BodyHandle pusher = world.createBody({.motion = Motion::Kinematic});
    world.addShape(pusher, box({2.0f, 4.0f}, {0.0f, 4.0f}));
    return [pusher](SceneBuilder& in, int step) {
        in.moveTo(pusher, {kReach * sine(0.2f * kStep * static_cast<float>(step)), 0.0f}, 0.0f, kStep);
    };
}

BeforeStep buildCompounds(SceneBuilder& world, int rows) {
    constexpr int kColumns = 20;
    const BodyHandle ground = addTrough(world, 40, 100);
    world.addShape(ground, segment({-800.0f, -80.0f}, {800.0f, -80.0f}));
    const Outline left = polygon({{{-1.0f, 0.0f}, {0.5f, 1.0f}, {0.0f, 2.0f}}});
    const Outline right = polygon({{{1.0f, 0.0f}, {-0.5f, 1.0f}, {0.0f, 2.0f}}});
    const Material material{.friction = 0.5f};
    float side = 0.25f;
    for (int i = 0; i < kColumns; ++i) {
        for (int j = 0; j < rows; ++j) {
            const Vec2 place{2.0f * static_cast<float>(i) - 19.0f + side,
                             2.25f * static_cast<float>(j) + 5.575f};
            side = -side;
            const BodyHandle body = world.createBody({.position = place});
            world.addShape(body, left, material);
            world.addShape(body, right, material);
        }
    }
    return {};
}

}  // namespace plumb::scenes
