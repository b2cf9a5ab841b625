#include "scene/systems/camera_system.hpp"

#include "render/camera_motion.hpp"
#include "scene/components/camera.hpp"
#include "scene/components/rigid_body.hpp"
#include "scene/world_transform.hpp"

namespace plumb {
namespace {

/// Where the camera would like to be: on what it follows, and ahead of it.
Vec2 targetOf(const World& world, const Camera& camera, Vec2 followed) {
    Vec2 target = followed + camera.offset;
    if (const auto* body = world.find<RigidBody>(camera.follow))
        target += scaled(body->velocity, camera.lookAhead);
    return target;
}

}  // namespace

void CameraSystem::update(World& world, float dt) {
    const PictureSize picture = world.resource<PictureSize>();
    for (auto [entity, camera, transform] : world.query<Camera, Transform>()) {
        camera.previousZoom = camera.settled ? camera.previousZoom : camera.zoom;
        if (camera.shakeTime < camera.shakeSeconds) camera.shakeTime += dt;
        if (!camera.enabled) continue;
        Vec2 center = transform.position;
        if (world.alive(camera.follow)) {
            const Vec2 target = targetOf(world, camera, worldPose(world, camera.follow).position);
            center = camera.settled ? approached(center, keptInDeadZone(center, target, camera.deadZone),
                                                 camera.smoothing, dt)
                                    : target;
        }
        center = keptInLimits(center, picture.size / camera.zoom, camera.limits);
        if (camera.settled) {
            transform.position = center;
        } else {
            teleport(transform, center);  // the first tick cuts to the target instead of sweeping there
            camera.settled = true;
        }
    }
}

}  // namespace plumb
