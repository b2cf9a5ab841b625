#include "scene/physics/kinematics.hpp"

#include <cmath>
#include <utility>

#include "math/angle.hpp"
#include "physics/bounds.hpp"
#include "physics/model/bodies.hpp"
#include "physics/model/checks.hpp"
#include "scene/components/bodies/character_body.hpp"
#include "scene/components/bodies/kinematic_body.hpp"
#include "scene/physics/entity_bodies.hpp"

namespace plumb {

namespace {

/// Motion of a kinematic body in this tick.
struct Course {
    Pose pose;                     // px, current world pose of its entity
    bool driven = false;           // the Transform was changed in this tick
    bool jumps = false;            // the entity was teleported in this tick
    Vec2 velocity;                 // px/s, of the KinematicBody; used if not driven
    float angularVelocity = 0.0f;  // rad/s, of the KinematicBody; used if not driven
};

Course courseOf(const World& world, WorldPoses& poses, const BodyLink& link) {
    Course course;
    course.pose = poses.of(world, link.entity);
    course.driven = course.pose.position != link.pose.position || course.pose.rotation != link.pose.rotation;
    const Transform& transform = world.get<Transform>(link.entity);
    // teleport() sets the previous position too.
    course.jumps = course.driven && !link.hasParent && transform.previousPosition == transform.position &&
                   transform.previousRotation == transform.rotation;
    const KinematicBody* body = world.find<KinematicBody>(link.entity);
    if (body != nullptr) {
        course.velocity = body->velocity;
        course.angularVelocity = body->angularVelocity;
    }
    return course;
}

physics::BodyId idAt(const PhysicsState& state, std::uint32_t body) {
    return {body, state.world.bodies.info[body].generation};
}

/// Sets a character's body to its Transform at once, so that triggers detect it without delay. Other bodies
/// are pushed by the character's controller, not by the velocity of this body.
void follow(World& world, PhysicsState& state, std::uint32_t index) {
    BodyLink& link = state.links[index];
    const Pose pose = state.poses.of(world, link.entity);
    if (pose.position == link.pose.position && pose.rotation == link.pose.rotation) return;
    const physics::WorldPosition place = positionInMetres(pose.position, state.scale);
    if (!(std::abs(place.x) < physics::kFarthest && std::abs(place.y) < physics::kFarthest &&
          std::abs(pose.rotation) < 1e5f)) {
        logRefusal(world, state, link.entity,
                   {"Transform", "expected a finite position and rotation", "move it back into the scene"});
        placeEntity(world, state.poses, link.entity, link.pose);
        return;
    }
    link.pose.position = pose.position;
    link.pose.rotation = pose.rotation;
    physics::BodyPose& body = state.world.bodies.pose[index];
    body.rotation = link.rotation = rotFromAngle(wrapAngle(pose.rotation));
    body.centre = place + rotate(body.rotation, body.localCentre);
    physics::refreshBounds(state.world, index);
}

void drive(World& world, PhysicsState& state, std::uint32_t index, float dt) {
    BodyLink& link = state.links[index];
    if (std::as_const(world).has<CharacterBody>(link.entity)) {
        link.driven = true;
        return follow(world, state, index);
    }
    const physics::BodyId body = idAt(state, index);
    const Course course = courseOf(std::as_const(world), state.poses, link);
    // syncBodies() has already called moveTo() in this tick, for queries: keep that target.
    const bool sent = (state.world.bodies.info[index].flags & physics::kHasTarget) != 0;
    link.driven = course.driven || sent;
    if (sent && !course.driven) return;
    Result<Done> result = Done{};
    if (course.driven) {
        const physics::WorldPosition place = positionInMetres(course.pose.position, state.scale);
        const float angle = wrapAngle(course.pose.rotation);
        result = course.jumps ? physics::setPosition(state.world, body, place, angle)
                              : physics::moveTo(state.world, body, place, angle, dt);
        if (result) {
            link.pose.position = course.pose.position;
            link.pose.rotation = course.pose.rotation;
            link.rotation = rotFromAngle(angle);
        } else {
            placeEntity(world, state.poses, link.entity, link.pose);
        }
    }
    if (!course.driven || course.jumps) {
        const physics::BodyMotion motion = state.world.bodies.motion[index];
        const Vec2 velocity = toMetres(course.velocity, state.scale);
        if (result && motion.velocity != velocity) result = physics::setVelocity(state.world, body, velocity);
        if (result && motion.angularVelocity != course.angularVelocity)
            result = physics::setAngularVelocity(state.world, body, course.angularVelocity);
        if (!result) {
            if (auto* kinematic = world.find<KinematicBody>(link.entity)) {
                kinematic->velocity = toPixels(motion.velocity, state.scale);
                kinematic->angularVelocity = motion.angularVelocity;
            }
        }
    }
    if (!result) logRefusal(world, state, link.entity, result.error());
}

}  // namespace

void driveKinematics(World& world, PhysicsState& state, float dt) {
    state.poses.clear();
    for (const std::uint32_t body : state.driven) drive(world, state, body, dt);
}

}  // namespace plumb
