#pragma once

#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "physics/simulation.hpp"

namespace plumb::physics {

inline constexpr float kTick = 1.0f / 60.0f;  ///< s

/// A world with gravity (0, -10) that nobody falls asleep in, and short ways to fill it.
struct Playground {
    World world;

    Playground() {
        world.settings.gravity = {0.0f, -10.0f};
        world.settings.sleeping = false;
    }

    BodyId body(BodyKind kind, Place position, float angle = 0.0f) {
        const Result<BodyId> made = createBody(world, {.kind = kind, .position = position, .angle = angle});
        EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().text());
        return *made;
    }
    ShapeId shape(BodyId body, const Geometry& geometry, const ShapeDefinition& definition = {}) {
        const Result<ShapeId> made = createShape(world, body, geometry, definition);
        EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().text());
        return *made;
    }
    /// A static box whose top is at y = 0.
    BodyId floor(const ShapeDefinition& definition = {}, float half = 50.0f) {
        const BodyId ground = body(BodyKind::Static, {0.0, -1.0});
        shape(ground, box({half, 1.0f}), definition);
        return ground;
    }
    BodyId crate(Place position, Vec2 half = {0.5f, 0.5f}, const ShapeDefinition& definition = {}) {
        const BodyId made = body(BodyKind::Dynamic, position);
        shape(made, box(half), definition);
        return made;
    }
    BodyId ball(Place position, float radius = 0.5f, const ShapeDefinition& definition = {}) {
        const BodyId made = body(BodyKind::Dynamic, position);
        shape(made, circle(radius), definition);
        return made;
    }
    void run(int ticks, const StepOptions& options = {}) {
        for (int i = 0; i < ticks; ++i) step(world, kTick, options);
    }
    [[nodiscard]] double x(BodyId body) const { return centreOf(world, body).x; }
    [[nodiscard]] double y(BodyId body) const { return centreOf(world, body).y; }
    [[nodiscard]] Vec2 velocity(BodyId body) const { return velocityOf(world, body); }
};

/// All poses and motions, bit for bit: what determinism promises.
inline std::vector<std::uint64_t> bitsOf(const World& world) {
    std::vector<std::uint64_t> bits;
    const auto add = [&](const void* memory, std::size_t bytes) {
        const std::size_t at = bits.size();
        bits.resize(at + (bytes + 7) / 8);
        std::memcpy(&bits[at], memory, bytes);
    };
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        add(&world.bodies.pose[i], sizeof(BodyPose));
        add(&world.bodies.motion[i], sizeof(BodyMotion));
    }
    return bits;
}

/// Contacts that touch.
inline int touching(const World& world) {
    int count = 0;
    for (const Contact& contact : world.contacts) count += (contact.flags & kTouching) != 0 ? 1 : 0;
    return count;
}

}  // namespace plumb::physics
