#include "physics/effects/forces.hpp"

namespace plumb::physics {

Acceleration accelerationAt(const FieldView& view, std::span<const std::uint32_t> fields, std::uint32_t body,
                            const BodyState& state) {
    Acceleration sum;
    for (const std::uint32_t f : fields) {
        const FieldDefinition& field = view.world.fields.all[f].definition;
        if (!view.withSteady && isConstant(field)) continue;
        if (const auto acceleration = fieldTypeOf(field.kind).acceleration; acceleration != nullptr) {
            sum += acceleration(view, field, body, state);
        }
    }
    const std::uint8_t flags = view.world.bodies.info[body].flags;
    if ((flags & kLockX) != 0) sum.linear.x = 0.0f;
    if ((flags & kLockY) != 0) sum.linear.y = 0.0f;
    return sum;
}

BodyState stateAtStart(const World& world, std::uint32_t body) {
    const BodyPose& pose = world.bodies.pose[body];
    const BodyMotion& motion = world.bodies.motion[body];
    return {pose.centre, pose.rotation, motion.velocity, motion.angularVelocity};
}

}  // namespace plumb::physics
