#include "scene/systems/camera_system.hpp"

#include <cmath>

#include "render/camera_motion.hpp"
#include "scene/camera_target.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/transform.hpp"

namespace plumb {
namespace {

/// True if a camera moves by more than half of its view in a tick. Such a motion is not interpolated.
bool isCut(Vec2 step, Vec2 seen) {
    return std::fabs(step.x) > seen.x * 0.5f || std::fabs(step.y) > seen.y * 0.5f;
}

}  // namespace

void CameraSystem::update(World& world, float dt) {
    const PictureSize picture = world.resource<PictureSize>();
    for (auto [entity, camera, transform] : world.query<Camera, Transform>()) {
        if (!camera.settled) camera.previousZoom = camera.zoom;
        if (camera.shakeTime < camera.shakeSeconds) camera.shakeTime += dt;
        if (!camera.enabled) continue;
        Vec2 center = transform.position;
        if (world.alive(camera.follow)) {
            const Vec2 target = cameraTarget(world, camera, center);
            center = camera.settled ? approached(center, keptInDeadZone(center, target, camera.deadZone),
                                                 camera.smoothing, dt)
                                    : target;
        }
        const Vec2 seen = picture.size / camera.zoom;
        center = keptInLimits(center, seen, camera.limits);
        if (camera.settled && !isCut(center - transform.previousPosition, seen)) {
            transform.position = center;
        } else {
            teleport(transform, center);  // jump without interpolation, e.g. in the first tick
            camera.settled = true;
        }
    }
}

}  // namespace plumb
