#include <plumb.hpp>

using namespace plumb;

/// Lets the camera follow an entity in a level of this size, px.
void follow(World& world, EntityId target, Vec2 level) {
    for (auto [entity, camera] : world.query<Camera>()) {
        camera.follow = target;
        camera.smoothing = 0.3f;           // s
        camera.deadZone = {40.0f, 24.0f};  // px: small movements do not move the camera
        camera.lookAhead = {0.25f, 0.0f};  // s: it is ahead of a target that runs
        camera.limits = {0.0f, 0.0f, level.x, level.y};
    }
}
