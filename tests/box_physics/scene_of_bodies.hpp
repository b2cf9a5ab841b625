#pragma once

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "box_physics/queries/cast.hpp"
#include "box_physics/simulation.hpp"

// Short ways to make worlds for the physics tests. y points down, as on screen.

namespace plumb::box_physics {

inline constexpr float kTick = 1.0f / 60.0f;  // s

struct Stage60 {
    World world;
    Settings settings;

    BodyId add(const BodyDefinition& definition) {
        const Result<BodyId> body = createBody(world, definition);
        EXPECT_TRUE(body.ok());
        return *body;
    }
    BodyId box(BodyKind kind, Vec2 centre, Vec2 half, Vec2 velocity = {}) {
        BodyDefinition d;
        d.kind = kind;
        d.position = centre;
        d.velocity = velocity;
        d.shape = Shape::box(half);
        return add(d);
    }
    BodyId ball(Vec2 centre, float radius, Vec2 velocity = {}, float bounciness = 0.0f) {
        BodyDefinition d;
        d.position = centre;
        d.velocity = velocity;
        d.shape = Shape::circle(radius);
        d.bounciness = bounciness;
        return add(d);
    }
    BodyId tiles(Vec2 corner, TileField field) {
        field.finish();
        const std::uint32_t number = addField(world, std::make_shared<const TileField>(std::move(field)));
        BodyDefinition d;
        d.kind = BodyKind::Static;
        d.position = corner;
        d.shape = shapeOfField(world, number);
        return add(d);
    }
    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) step(world, settings, kTick);
    }
    Vec2 position(BodyId id) const { return world.bodies.position[id.index]; }
    Vec2 velocity(BodyId id) const { return world.bodies.velocity[id.index]; }
    int count(ContactPhase phase, BodyId id) const {
        int n = 0;
        for (const ContactEvent& e : world.events) n += e.phase == phase && (e.a == id || e.b == id) ? 1 : 0;
        return n;
    }
};

}  // namespace plumb::box_physics
