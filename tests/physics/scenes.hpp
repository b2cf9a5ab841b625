#pragma once

#include <array>

#include "core/random.hpp"
#include "physics/simulation.hpp"

namespace plumb::physics {

// Worlds for tests of whole steps. y points up here: gravity is (0, -10).

inline BodyId addBody(World& world, BodyKind kind, Place position, float angle = 0.0f) {
    BodyDefinition definition;
    definition.kind = kind;
    definition.position = position;
    definition.angle = angle;
    return *createBody(world, definition);
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

/// A floor and two walls, and things of all kinds in between that fall on each other.
inline World makePit(int bodies, std::uint64_t seed) {
    World world;
    world.settings.gravity = {0.0f, -10.0f};
    Random random = Random::seeded(seed);
    const BodyId pit = addBody(world, BodyKind::Static, {0.0, -1.0});
    static_cast<void>(createShape(world, pit, box({12.0f, 1.0f})));
    for (const float side : {-1.0f, 1.0f})
        static_cast<void>(createShape(world, pit, box({1.0f, 30.0f}, {11.0f * side, 30.0f})));
    for (int i = 0; i < bodies; ++i) {
        const Place place{-9.0 + 1.2 * (i % 16) + 0.1 * random.unit(), 0.7 + 1.2 * (i / 16)};
        const BodyId body = addBody(world, BodyKind::Dynamic, place, random.between(-3.0f, 3.0f));
        addRandomShape(world, body, random, 0.5f);
    }
    return world;
}

}  // namespace plumb::physics
