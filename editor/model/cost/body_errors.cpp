#include "editor/model/cost/body_errors.hpp"

#include <algorithm>
#include <cmath>

#include "physics/contacts/contacts.hpp"
#include "physics/islands/quality.hpp"
#include "physics/measure/measures.hpp"

namespace plumb::editor {
namespace {

bool isDynamicBody(const physics::World& world, std::uint32_t body) {
    return world.bodies.info[body].kind == physics::BodyKind::Dynamic;
}

/// Returns the force at a contact point in the last substep, N. The number of substeps depends on the quality
/// of the island, which may be higher than that of the world.
float forceOf(const physics::World& world, const physics::Contact& contact, int point) {
    const float impulse = std::abs(point == 0 ? contact.impulse0 : contact.impulse1);
    const auto& info = world.bodies.info;
    const physics::Quality quality =
        std::max({world.settings.quality, info[contact.bodyA].quality, info[contact.bodyB].quality});
    return impulse * static_cast<float>(physics::substepsOf(quality)) / world.stepLength;
}

}  // namespace

std::vector<float> bodyErrors(const physics::World& world) {
    std::vector<float> errors(world.bodies.size());
    const auto take = [&](std::uint32_t body, float error) {
        if (isDynamicBody(world, body)) errors[body] = std::max(errors[body], error);
    };
    forContacts(world, [&](const physics::Contact& contact) {
        const float overlap = physics::overlapOf(contact);
        take(contact.bodyA, overlap), take(contact.bodyB, overlap);
    });
    for (std::uint32_t j = 0; j < world.joints.size(); ++j) {
        const physics::Joint& joint = world.joints.hot[j];
        if (joint.bodyA >= errors.size() || joint.bodyB >= errors.size()) continue;  // the slot is free
        const float opening = physics::openingOf(world, j);
        take(joint.bodyA, opening), take(joint.bodyB, opening);
    }
    return errors;
}

std::vector<ContactPush> contactPushes(const physics::World& world) {
    std::vector<ContactPush> pushes;
    const float gravity = std::max(length(world.settings.gravity), 1.0e-3f);
    forContacts(world, [&](const physics::Contact& contact) {
        if ((contact.flags & (physics::kTouching | physics::kTriggered)) != physics::kTouching) return;
        const auto& masses = world.bodies.mass;
        const float inverse = std::max(masses[contact.bodyA].inverseMass, masses[contact.bodyB].inverseMass);
        const physics::BodyPose& pose = world.bodies.pose[contact.bodyA];
        for (int point = 0; point < contact.count; ++point) {
            const float force = forceOf(world, contact, point);
            if (force <= 0.0f) continue;
            const Vec2 arm = rotate(pose.rotation, physics::pointOf(world, contact, point));
            pushes.push_back(
                {contact.bodyA, contact.bodyB, pose.centre + arm, force, force * inverse / gravity});
        }
    });
    return pushes;
}

}  // namespace plumb::editor
