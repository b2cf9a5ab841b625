#pragma once

#include "physics/queries/query.hpp"
#include "world_of_bodies.hpp"

namespace plumb::physics {

// Worlds for tests of queries, and the shapes that a query is expected to consider.

/// Distance from the origin, 2^20 m: the sum with a position on a grid of 1/128 m is exact.
inline constexpr double kFar = 1048576.0;

/// Scatters bodies and shapes of all kinds over 20 x 20 m around (origin, 0).
inline World scatterShapes(std::uint64_t seed, double origin) {
    World world;
    world.settings.gravity = {};
    Random random = Random::seeded(seed);
    constexpr BodyKind kKinds[] = {BodyKind::Static, BodyKind::Kinematic, BodyKind::Dynamic};
    for (int i = 0; i < 60; ++i) {
        const WorldPosition place{origin + static_cast<double>(random.below(2560)) / 128.0 - 10.0,
                                  static_cast<double>(random.below(2560)) / 128.0 - 10.0};
        const BodyId body = addBody(world, kKinds[random.below(3)], place, random.between(-3.0f, 3.0f));
        ShapeDefinition definition;
        definition.layers = 1u << random.below(3);
        definition.isTrigger = random.below(6) == 0;
        addRandomShape(world, body, random, random.between(0.1f, 1.5f), definition);
        if (random.below(4) == 0) {
            const Vec2 end{random.between(-2.0f, 2.0f), 1.0f};
            static_cast<void>(createShape(world, body, segment({}, end), definition));
        }
    }
    return world;
}

inline bool wanted(const World& world, std::uint32_t shape, const QueryFilter& filter) {
    const bool fixed = world.bodies.info[world.shapes.info[shape].body].kind == BodyKind::Static;
    const bool trigger = (world.shapes.info[shape].flags & kTrigger) != 0;
    return (world.shapes.filter[shape].layers & filter.mask) != 0 && (filter.triggers || !trigger) &&
           (fixed ? filter.fixed : filter.movers) && world.shapes.info[shape].body != filter.except.index;
}

inline QueryFilter randomFilter(const World& world, Random& random) {
    QueryFilter filter;
    filter.mask = 1u + random.below(7);
    filter.triggers = random.below(2) == 0;
    filter.movers = random.below(4) != 0;
    filter.fixed = random.below(4) != 0;
    const std::uint32_t body = random.below(60);
    filter.except = {body, world.bodies.info[body].generation};
    return filter;
}

inline Frame frameAt(const World& world, std::uint32_t shape, WorldPosition origin) {
    const BodyPose& pose = world.bodies.pose[world.shapes.info[shape].body];
    return {(pose.centre - origin) - rotate(pose.rotation, pose.localCentre), pose.rotation};
}

}  // namespace plumb::physics
