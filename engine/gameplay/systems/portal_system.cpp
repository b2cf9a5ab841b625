#include "gameplay/systems/portal_system.hpp"

#include "gameplay/components/triggers/portal.hpp"
#include "gameplay/touches.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/transform.hpp"

namespace plumb {

void PortalSystem::update(World& world, float) {
    forEachTouch<TriggerEntered, Portal, RigidBody>(world, [&world](EntityId id, EntityId traveller) {
        const Portal& portal = std::as_const(world).get<Portal>(id);
        Transform& transform = world.get<Transform>(traveller);
        teleport(transform, transform.position + portal.shift);
        if (portal.keepVelocity) return;
        RigidBody& body = world.get<RigidBody>(traveller);
        body.velocity = {};
        body.angularVelocity = 0.0f;
    });
}

}  // namespace plumb
