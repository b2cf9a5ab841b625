// Scenes of bodies in a container that are stirred by a blade or by the rotation of the container.

#include "math/rot.hpp"
#include "tests/bench/physics/scenes.hpp"

namespace plumb::scenes {

namespace {

constexpr float kDrumSpin = 25.0f / 180.0f * kPi;  // rad/s

/// Returns points of a circle in clockwise order, so that a loop through them is free inside.
std::vector<Vec2> ringOf(int count, float radius, Vec2 centre) {
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
        const SinCos rotation = sinCos(-kTau * static_cast<float>(i) / static_cast<float>(count));
        points.push_back(centre + radius * Vec2{rotation.cos, rotation.sin});
    }
    return points;
}

void addBlade(SceneBuilder& world, BodyHandle ground) {
    constexpr Vec2 kCentre{0.0f, 12.0f};
    const BodyHandle blade = world.createBody({.position = kCentre, .canSleep = false});
    world.addShape(blade, box({0.4f, 20.0f}, {}, 0.2f), {.friction = 0.0f});
    world.addJoint({.a = ground, .b = blade, .anchorA = kCentre, .driven = true, .speed = 5.0f});
}

/// Returns the part of a ring between two radii and two angles, as a polygon.
Outline sector(float inner, float outer, float from, float to) {
    const SinCos a = sinCos(from);
    const SinCos b = sinCos(to);
    const Vec2 start{a.cos, a.sin};
    const Vec2 end{b.cos, b.sin};
    return polygon({{inner * start, outer * start, inner * end, outer * end}});
}

}  // namespace

BeforeStep buildSpinner(SceneBuilder& world, int bodies) {
    constexpr float kEdge = 23.0f;  // m
    constexpr float kPitch = 0.5f;  // m: less than their sizes, so they start well inside each other
    const BodyHandle ground = world.createBody({.motion = Motion::Static});
    world.addLoop(ground, ringOf(360, 40.0f, {0.0f, 32.0f}), {.friction = 0.1f});
    addBlade(world, ground);
    const Outline outlines[] = {capsule({-0.25f, 0.0f}, {0.25f, 0.0f}, 0.25f), circle(0.35f),
                                box({0.35f, 0.35f})};
    const Material material{.density = 0.25f, .friction = 0.1f, .bounciness = 0.1f};
    Vec2 place{-kEdge, 2.0f};
    for (int i = 0; i < bodies; ++i) {
        world.addShape(world.createBody({.position = place}), outlines[i % 3], material);
        place.x += kPitch;
        if (place.x >= kEdge) place = {-kEdge, place.y + kPitch};
    }
    return {};
}

BeforeStep buildTumbler(SceneBuilder& world, int side) {
    constexpr Vec2 kCentre{0.0f, 10.0f};
    constexpr float kPitch = 0.4f;  // m
    const BodyHandle ground = world.createBody({.motion = Motion::Static});
    const BodyHandle drum = world.createBody({.position = kCentre});
    const Material wall{.density = 50.0f};
    for (const float x : {10.0f, -10.0f}) world.addShape(drum, box({0.5f, 10.0f}, {x, 0.0f}), wall);
    for (const float y : {10.0f, -10.0f}) world.addShape(drum, box({10.0f, 0.5f}, {0.0f, y}), wall);
    world.addJoint(
        {.a = ground, .b = drum, .anchorA = kCentre, .driven = true, .speed = kDrumSpin, .maxForce = 1e8f});
    const float edge = -0.5f * kPitch * static_cast<float>(side);
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j)
            world.addShape(
                world.createBody({.position = {edge + kPitch * static_cast<float>(j),
                                               kCentre.y + edge + kPitch * static_cast<float>(i)}}),
                box({0.125f, 0.125f}));
    }
    return {};
}

BeforeStep buildWasher(SceneBuilder& world, int side) {
    constexpr Vec2 kCentre{0.0f, 10.0f};
    constexpr float kHalf = 0.1f;  // m
    constexpr int kSectors = 36;
    constexpr float kSector = kTau / kSectors;
    constexpr float kLap = 0.1f * kSector;  // rad: overlap of a sector on each side
    static_cast<void>(world.createBody({.motion = Motion::Static}));
    const BodyHandle drum = world.createBody(
        {.motion = Motion::Kinematic, .position = kCentre, .velocity = {0.001f, -0.002f}, .spin = kDrumSpin});
    for (int i = 0; i < kSectors; ++i) {
        const float from = kSector * static_cast<float>(i);
        const float to = from + kSector;
        world.addShape(drum, sector(16.0f, 18.0f, from - kLap, to + kLap));
        if (i % (kSectors / 4) == 0) world.addShape(drum, sector(14.0f, 16.0f, from, to));
    }
    const float edge = -1.1f * kHalf * static_cast<float>(side);
    constexpr float kPitch = 2.1f * kHalf;
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j)
            world.addShape(
                world.createBody({.position = {edge + kPitch * static_cast<float>(j),
                                               kCentre.y + edge + kPitch * static_cast<float>(i)}}),
                box({kHalf, kHalf}), {.reports = true});
    }
    return {};
}

}  // namespace plumb::scenes
