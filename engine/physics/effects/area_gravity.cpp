#include "physics/effects/field_types.hpp"

namespace plumb::physics {

Acceleration areaGravity(const FieldView& view, const FieldDefinition& field, std::uint32_t body,
                         const BodyState& state) {
    const float scale = view.world.bodies.driveOf(body).gravityScale;
    Vec2 pull = field.acceleration;
    if (field.strength != 0.0f) pull += field.strength * normalized(field.place - state.centre);
    if (field.replacesGravity && view.world.manifest.runs(Effect::Gravity))
        pull -= view.world.settings.gravity;
    return {scale * pull, 0.0f};
}

}  // namespace plumb::physics
