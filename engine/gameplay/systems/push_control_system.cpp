#include "gameplay/systems/push_control_system.hpp"

#include <cmath>

#include "ecs/world.hpp"
#include "gameplay/components/actors/push_control.hpp"
#include "gameplay/sound_cue.hpp"
#include "input/input.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/scene_stack.hpp"

namespace plumb {

namespace {

/// Returns the acceleration along an axis (px/s^2); 0 if the
/// body already has the maximum speed in that direction.
float pushOf(const PushControl& control, float axis, float velocity) {
    const bool fastEnough = axis * velocity > 0.0f && std::abs(velocity) >= control.maxSpeed;
    return fastEnough ? 0.0f : axis * control.acceleration;
}

}  // namespace

void PushControlSystem::update(World& world, float) {
    for (auto [entity, control, known] : world.query<const PushControl, const RigidBody>()) {
        const Input& input = inputFor(world, entity);
        const float up = control.flies ? input.getAxis(Axis::Vertical) : 0.0f;
        const Vec2 push{pushOf(control, input.getAxis(Axis::Horizontal), known.velocity.x),
                        pushOf(control, up, known.velocity.y)};
        const bool jumps = control.jumpSpeed > 0.0f && known.grounded && input.isPressed(Action::Jump);
        if (!jumps && push == known.acceleration) continue;
        RigidBody& body = world.get<RigidBody>(entity);
        body.acceleration = push;
        if (!jumps) continue;
        body.velocity.y = -control.jumpSpeed;
        playCue(world, entity, &SoundCues::jump);
    }
}

}  // namespace plumb
