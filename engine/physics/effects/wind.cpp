#include <algorithm>

#include "core/hash.hpp"
#include "physics/effects/field_types.hpp"

namespace plumb::physics {

namespace {

/// -1..1: gust number `turn` of a seed.
float gustAt(std::uint32_t seed, std::uint64_t turn) {
    const auto bits = static_cast<std::uint32_t>(mixBits(mixBits(seed) ^ turn) >> 40);
    return static_cast<float>(bits) * 0x1p-23f - 1.0f;
}

/// -1..1: smooth interpolation between consecutive gusts. Depends only on the step number, so a repeated step
/// gets the same wind.
float gustiness(const FieldDefinition& field, std::uint64_t step) {
    const std::uint64_t turn = step / field.gustSteps;
    const float t = static_cast<float>(step % field.gustSteps) / static_cast<float>(field.gustSteps);
    const float smooth = t * t * (3.0f - 2.0f * t);
    return lerp(gustAt(field.seed, turn), gustAt(field.seed, turn + 1), smooth);
}

}  // namespace

Vec2 airOf(const FieldDefinition& field, std::uint64_t step) {
    if (!(field.gust > 0.0f)) return field.velocity;
    const Vec2 along = lengthSquared(field.velocity) > 0.0f ? normalized(field.velocity) : Vec2{1.0f, 0.0f};
    return field.velocity + (field.gust * gustiness(field, step)) * along;
}

/// F = density * width * speed^2, along the apparent wind.
Acceleration wind(const FieldView& view, const FieldDefinition& field, std::uint32_t body,
                  const BodyState& state) {
    const Vec2 felt = airOf(field, view.world.steps) - state.velocity;
    const float speed = length(felt);
    if (speed <= 0.0f) return {};
    const float width = widthAcross(view.world, body, state.rotation, felt / speed);
    const float rate = field.density * width * speed * view.world.bodies.mass[body].inverseMass;  // 1/s
    return {std::min(rate, 1.0f / view.h) * felt, 0.0f};
}

}  // namespace plumb::physics
