#include "scene/camera_target.hpp"

#include "scene/components/bodies/rigid_body.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

Vec2 cameraTarget(const World& world, const Camera& camera, Vec2 center) {
    if (!world.alive(camera.follow)) return center;
    const Vec2 target = worldPose(world, camera.follow).position + camera.offset;
    const auto* body = world.find<RigidBody>(camera.follow);
    return body != nullptr ? target + scaled(body->velocity, camera.lookAhead) : target;
}

}  // namespace plumb
