#pragma once

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "physics/character/character_controller.hpp"
#include "physics/queries/shape_cast.hpp"
#include "physics/simulation.hpp"

namespace plumb::physics {

inline constexpr float kTick = 1.0f / 60.0f;  // time step, s
inline constexpr float kGap = 0.001f;         // default of CharacterDefinition::gap, m

enum class Figure { Box, RoundedBox, Circle, Capsule, Count };
inline constexpr Figure kFigures[] = {Figure::Box, Figure::RoundedBox, Figure::Circle, Figure::Capsule};

inline Geometry outlineOf(Figure figure, float size = 1.0f) {
    switch (figure) {
        case Figure::Box: return box({0.4f * size, 0.9f * size});
        case Figure::RoundedBox: return box({0.3f * size, 0.8f * size}, {}, {}, 0.1f * size);
        case Figure::Circle: return circle(0.5f * size);
        default: return capsule({0.0f, -0.5f * size}, {0.0f, 0.5f * size}, 0.4f * size);
    }
}
/// Returns the distance from the outline's origin down to its lowest point (y down), m.
inline float feetOf(const Geometry& outline) {
    return outline.kind == ShapeKind::Circle ? outline.radius : outline.b.y + outline.radius;
}

inline CharacterDefinition definitionOf(Figure figure) { return {.outline = outlineOf(figure)}; }

inline bool walkOn(CharacterController& character, float speed) {
    return character.setVelocity({speed, character.grounded() ? 0.0f : character.velocity().y}).ok();
}

/// A world with y down, with helpers to add bodies and to move a character.
struct Course {
    World world;

    BodyId body(BodyKind kind, WorldPosition position, float angle = 0.0f) {
        return *createBody(world, {.kind = kind, .position = position, .angle = angle});
    }
    BodyId block(BodyKind kind, WorldPosition centre, Vec2 half, const ShapeDefinition& definition = {}) {
        const BodyId made = body(kind, centre);
        EXPECT_TRUE(createShape(world, made, box(half), definition).ok());
        return made;
    }
    BodyId wall(WorldPosition centre, Vec2 half) { return block(BodyKind::Static, centre, half); }
    /// A platform that is solid only from above; `top` is the middle of its upper edge.
    BodyId shelf(BodyKind kind, WorldPosition top, float half = 2.0f) {
        return block(kind, {top.x, top.y + 0.125}, {half, 0.125f}, {.oneWay = true});
    }
    CharacterController character(const CharacterDefinition& definition, WorldPosition position) {
        return *CharacterController::create(definition, position);
    }
    CharacterMotion tick(CharacterController& character) {
        const CharacterMotion motion = character.update(world, kTick);
        step(world, kTick);
        return motion;
    }
    CharacterMotion run(CharacterController& character, int ticks) {
        CharacterMotion motion;
        for (int i = 0; i < ticks; ++i) motion = tick(character);
        return motion;
    }
    CharacterMotion walk(CharacterController& character, float speed, int ticks) {
        CharacterMotion motion;
        for (int i = 0; i < ticks; ++i) {
            EXPECT_TRUE(walkOn(character, speed));
            motion = tick(character);
        }
        return motion;
    }
    /// Distance from a character straight down to the next surface, m; 1 if there is none within 1 m.
    float heightOver(const CharacterController& character) {
        const QueryShape shape{character.definition().outline, character.position(), {}};
        const auto hit = castShape(world, shape, {0.0f, 1.0f});
        return hit ? hit->distance : 1.0f;
    }
};

/// Number of random runs of a test: the environment variable PLUMB_CHARACTER if set, otherwise `usual`.
inline int runsToTry(int usual) {
    const char* wanted = std::getenv("PLUMB_CHARACTER");
    return wanted != nullptr ? std::max(std::atoi(wanted), 1) : usual;
}

}  // namespace plumb::physics
