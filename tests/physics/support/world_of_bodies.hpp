#pragma once

#include <array>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "physics/simulation.hpp"

namespace plumb::physics {

// Worlds for tests of whole steps. y points up here, unlike the default: gravity is (0, -10).

inline constexpr float kTick = 1.0f / 60.0f;  ///< time step, s

inline BodyId addBody(World& world, BodyKind kind, WorldPosition position, float angle = 0.0f) {
    const Result<BodyId> made = createBody(world, {.kind = kind, .position = position, .angle = angle});
    EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().text());
    return *made;
}

inline ShapeId addRandomShape(World& world, BodyId body, Random& random, float size,
                              const ShapeDefinition& definition = {}) {
    const Vec2 half{size * random.between(0.5f, 1.0f), size * random.between(0.5f, 1.0f)};
    switch (random.below(4)) {
        case 0: return *createShape(world, body, circle(half.x), definition);
        case 1: return *createShape(world, body, box(half), definition);
        case 2:
            return *createShape(world, body, capsule({-half.x, 0.0f}, {half.x, 0.0f}, half.y), definition);
        default: {
            const std::array<Vec2, 5> points{Vec2{-half.x, -half.y}, Vec2{half.x, -half.y},
                                             Vec2{half.x, 0.0f}, Vec2{0.0f, half.y},
                                             Vec2{-half.x, 0.5f * half.y}};
            return *createPolygon(world, body, points, 0.0f, definition);
        }
    }
}

/// Builds a floor and two walls with dynamic bodies of random shapes between them that fall on each other.
inline World makePit(int bodies, std::uint64_t seed) {
    World world;
    world.settings.gravity = {0.0f, -10.0f};
    Random random = Random::seeded(seed);
    const BodyId pit = addBody(world, BodyKind::Static, {0.0, -1.0});
    static_cast<void>(createShape(world, pit, box({12.0f, 1.0f})));
    for (const float side : {-1.0f, 1.0f})
        static_cast<void>(createShape(world, pit, box({1.0f, 30.0f}, {11.0f * side, 30.0f})));
    for (int i = 0; i < bodies; ++i) {
        const WorldPosition place{-9.0 + 1.2 * (i % 16) + 0.1 * random.unit(), 0.7 + 1.2 * (i / 16)};
        const BodyId body = addBody(world, BodyKind::Dynamic, place, random.between(-3.0f, 3.0f));
        addRandomShape(world, body, random, 0.5f);
    }
    return world;
}

/// A world in which no body falls asleep, with helpers to fill it.
struct Playground {
    World world;

    Playground() {
        world.settings.gravity = {0.0f, -10.0f};
        world.settings.sleeping = false;
    }

    BodyId body(BodyKind kind, WorldPosition position, float angle = 0.0f) {
        return addBody(world, kind, position, angle);
    }
    ShapeId shape(BodyId body, const Geometry& geometry, const ShapeDefinition& definition = {}) {
        const Result<ShapeId> made = createShape(world, body, geometry, definition);
        EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().text());
        return *made;
    }
    /// Adds a static box whose top is at y = 0.
    BodyId floor(const ShapeDefinition& definition = {}, float half = 50.0f) {
        const BodyId ground = body(BodyKind::Static, {0.0, -1.0});
        shape(ground, box({half, 1.0f}), definition);
        return ground;
    }
    BodyId crate(WorldPosition position, Vec2 half = {0.5f, 0.5f}, const ShapeDefinition& definition = {}) {
        const BodyId made = body(BodyKind::Dynamic, position);
        shape(made, box(half), definition);
        return made;
    }
    BodyId ball(WorldPosition position, float radius = 0.5f, const ShapeDefinition& definition = {}) {
        const BodyId made = body(BodyKind::Dynamic, position);
        shape(made, circle(radius), definition);
        return made;
    }
    /// Adds a floor and a crate that sleeps on it.
    BodyId sleeper() {
        world.settings.sleeping = true;
        floor();
        const BodyId made = crate({0.0, 0.5});
        run(120);
        EXPECT_TRUE(world.awake.empty());
        return made;
    }
    void run(int ticks, const StepOptions& options = {}) {
        for (int i = 0; i < ticks; ++i) step(world, kTick, options);
    }
    [[nodiscard]] double x(BodyId body) const { return centreOf(world, body).x; }
    [[nodiscard]] double y(BodyId body) const { return centreOf(world, body).y; }
    [[nodiscard]] Vec2 velocity(BodyId body) const { return velocityOf(world, body); }
};

/// Returns all bits of all poses and velocities: the state that must be deterministic.
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

/// Returns the number of contacts whose shapes touch.
inline int touching(const World& world) {
    int count = 0;
    for (const Contact& contact : world.contacts) count += (contact.flags & kTouching) != 0 ? 1 : 0;
    return count;
}

}  // namespace plumb::physics
