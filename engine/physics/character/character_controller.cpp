#include "physics/character/character_controller.hpp"

#include <algorithm>
#include <type_traits>

#include "physics/model/bodies.hpp"
#include "physics/model/checks.hpp"
#include "physics/model/shapes.hpp"
#include "physics/shapes/shape_types.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

static_assert(std::is_trivially_copyable_v<CharacterController>, "games copy it for snapshots");

namespace {

constexpr float kMaxTick = 1.0f;  // s

Result<Done> checkOutline(const Geometry& outline) {
    const bool known = outline.kind == ShapeKind::Box || outline.kind == ShapeKind::Circle ||
                       outline.kind == ShapeKind::Capsule;
    if (known) return checkGeometry(outline, {});
    return usageError("CharacterDefinition.outline",
                      "expected a box, a circle or a capsule, found another kind of shape",
                      "use physics::box(), circle() or capsule()");
}

Result<Done> checkUp(Vec2 up) {
    const float square = lengthSquared(up);
    if (square > 0.999f && square < 1.001f) return Done{};
    return usageError("CharacterDefinition.up", "expected a direction of length 1",
                      "use {0, -1} where y is down");
}

Result<Done> check(const CharacterDefinition& definition) {
    return firstOf(
        checkOutline(definition.outline), checkUp(definition.up),
        checkNumber("CharacterDefinition.steepest", definition.steepest, 0.0, 1.5),
        checkNumber("CharacterDefinition.stepHeight", definition.stepHeight, 0.0, kLargest),
        checkNumber("CharacterDefinition.snap", definition.snap, 0.0, kLargest),
        checkNumber("CharacterDefinition.cornerCorrection", definition.cornerCorrection, 0.0, kLargest),
        checkNumber("CharacterDefinition.gravityScale", definition.gravityScale, -kFastest, kFastest),
        checkNumber("CharacterDefinition.pushForce", definition.pushForce, 0.0, kStrongest),
        checkNumber("CharacterDefinition.pushMass", definition.pushMass, 0.0, kStrongest),
        checkNumber("CharacterDefinition.weight", definition.weight, 0.0, kStrongest),
        checkNumber("CharacterDefinition.gap", definition.gap, kSmallest, 0.1));
}

/// Rotates in double precision, so that a character on rotating ground does not drift from tick to tick.
WorldPosition turned(Rot rotation, WorldPosition arm) {
    const auto cosine = static_cast<double>(rotation.cos), sine = static_cast<double>(rotation.sin);
    return {cosine * arm.x - sine * arm.y, sine * arm.x + cosine * arm.y};
}

/// Returns ground that has moved up to a character in the air.
CharacterTouch caughtBy(CharacterMover& mover, const CharacterProbe::Pushes& pushes) {
    const CharacterDefinition& definition = mover.probe().definition();
    const WorldPosition place = mover.position();
    for (const CharacterProbe::Push& push : pushes) {
        if (!(dot(push.displacement, definition.up) > 0.0f)) continue;
        const CharacterTouch ground = mover.snapDown(4.0f * definition.gap);
        if (ground.body == push.body) return ground;
        mover.setPosition(place);
    }
    return {};
}

}  // namespace

Result<CharacterController> CharacterController::create(const CharacterDefinition& definition,
                                                        WorldPosition position) {
    const auto checked = firstOf(check(definition), checkPosition("CharacterController position", position));
    if (!checked) return checked.error();
    return CharacterController{definition, position};
}

Result<Done> CharacterController::setDefinition(const CharacterDefinition& definition) {
    const auto checked = check(definition);
    if (checked) definition_ = definition, placed_ = true;
    return checked;
}

Result<Done> CharacterController::setPosition(WorldPosition position) {
    const auto checked = checkPosition("CharacterController::setPosition", position);
    if (!checked) return checked;
    leaveGround();
    position_ = position;
    placed_ = true;
    return checked;
}

Result<Done> CharacterController::setVelocity(Vec2 velocity) {
    const auto checked = checkVector("CharacterController::setVelocity", velocity, kFastest);
    if (checked) velocity_ = velocity;
    return checked;
}

Result<Done> CharacterController::jump(float speed) {
    const auto checked = checkNumber("CharacterController::jump", speed, 0.0, kFastest);
    return checked ? setVelocity(velocity_ + definition_.up * speed) : checked;
}

bool CharacterController::dropThrough(World& world) {
    if (!ground_ || !alive(world, ground_.shape)) return false;
    CharacterMover mover{world, definition_, position_, 0.0f};
    mover.probe().oneWay = false;
    const float sink = 2.0f * definition_.gap;
    if (mover.standsOn(definition_.snap + sink)) return false;
    // A one-way shape does not support a character inside it.
    position_ = position_ + definition_.up * -sink;
    leaveGround();
    return true;
}

/// Returns the position to which the ground carries the character in the next step.
WorldPosition CharacterController::heldPlace(const CharacterProbe& probe) const {
    if (!ground_ || probe.world().bodies.info[ground_.body.index].kind == BodyKind::Static) return position_;
    const BodyPose pose = probe.poseOf(ground_.body.index);
    const WorldPosition arm = turned(pose.rotation, hold_);
    return WorldPosition{pose.centre.x + arm.x, pose.centre.y + arm.y} + definition_.up * height_;
}

/// Attaches the character to the point of the ground below its center.
void CharacterController::holdOn(const CharacterProbe& probe) {
    const BodyPose pose = probe.poseOf(ground_.body.index);
    height_ = dot(position_ - ground_.point, ground_.normal) / rise(ground_.normal);
    const WorldPosition under = position_ + definition_.up * -height_;
    const WorldPosition arm{under.x - pose.centre.x, under.y - pose.centre.y};
    hold_ = turned(inverse(pose.rotation), arm);
}

bool CharacterController::ride(CharacterMover& mover, WorldPosition held) {
    CharacterProbe& probe = mover.probe();
    probe.carrier = ground_.body;
    const bool arrived = mover.carryTo(held);
    probe.carrier = {};
    if (probe.world().bodies.motion[ground_.body.index].angularVelocity == 0.0f) return arrived;
    const Vec2 extent = boundsOf(definition_.outline, {}, {}).size();
    const WorldPosition foot = held + definition_.up * -height_;
    mover.settle(0.1f * std::max(extent.x, extent.y) + definition_.snap);
    height_ = rise(mover.position() - foot);
    return arrived;
}

/// Stops the character at a wall; pushes light bodies with limited force.
void CharacterController::stopAt(World& world, const CharacterTouch& touch, float dt) {
    if (!touch) return;
    const Vec2 own = velocity_ + groundVelocity_;
    Vec2 theirs = velocityAt(world, touch.body, touch.point);
    float closing = dot(theirs - own, touch.normal);
    if (!(closing > 0.0f)) return;
    const BodyMass& mass = world.bodies.mass[touch.body.index];
    if (mass.inverseMass > 0.0f && mass.mass <= definition_.pushMass) {
        const float impulse = std::min(closing / mass.inverseMass, definition_.pushForce * dt);
        static_cast<void>(applyImpulse(world, touch.body, touch.normal * -impulse));
        closing -= impulse * mass.inverseMass;
    }
    velocity_ += touch.normal * closing;
}

CharacterMotion CharacterController::walk(CharacterMover& mover, float dx) const {
    CharacterMotion motion = mover.walkOnGround(dx, ground_.normal);
    if (motion.ground) return motion;
    const WorldPosition place = mover.position();
    // It may stand in a pit between two slopes.
    motion.ground = mover.fly(definition_.up * (-4.0f * definition_.gap)).ground;
    if (!motion.ground) mover.setPosition(place);
    return motion;
}

// NOLINTNEXTLINE(readability-function-size): one tick, in order
CharacterMotion CharacterController::update(World& world, float dt) {
    CharacterMotion motion;
    if (!(dt > 0.0f && dt <= kMaxTick)) return motion;
    const bool lostGround = ground_ && !alive(world, ground_.shape);
    if (lostGround) leaveGround();
    CharacterMover mover{world, definition_, position_, dt};
    if (placed_ && mover.pushOut()) mover.escape();
    position_ = mover.position();
    placed_ = false;

    // Adds the displacement by the ground and other moving bodies in this tick to the character's own.
    const bool stood = grounded();
    const bool walks = stood && !(rise(velocity_) > kTakeOff);
    const Vec2 gravity = world.settings.gravity * definition_.gravityScale;
    const WorldPosition held = heldPlace(mover.probe());
    const Vec2 taken = held - position_;
    groundVelocity_ = stood ? taken / dt : Vec2{};
    const Vec2 right = perpendicular(definition_.up);
    const auto conveyorSpeed = [&] { return world.shapes.extrasOf(ground_.shape.index).surfaceSpeed; };
    const float dx = walks ? (along(velocity_) + conveyorSpeed()) * dt : 0.0f;
    Vec2 own = walks ? right * dx : velocity_ * dt + gravity * (0.5f * dt * dt);
    mover.probe().floor = ground_.shape;
    const CharacterProbe::Pushes pushes = mover.probe().pushesAt(position_, taken, own, ground_.body);
    const bool arrived = !stood || held == position_ || ride(mover, held);
    const WorldPosition rode = mover.position();
    const Vec2 left = mover.giveWay(pushes, walks ? Vec2{} : own);
    const CharacterTouch squeezedBy = mover.pushOut();
    const WorldPosition start = mover.position();

    // Displacement by its own velocity.
    const CharacterTouch caught = walks ? CharacterTouch{} : caughtBy(mover, pushes);
    if (walks) {
        motion = walk(mover, dx);
    } else if (caught) {
        motion.wall = mover.walk(along(left), caught.normal).wall;
        motion.ground = caught;
    } else {
        motion = mover.fly(left);
        velocity_ += gravity * dt;
    }
    motion.squeezedBy = squeezedBy;
    motion.leftGround = lostGround;
    const BodyId before = ground_.body;
    position_ = mover.position();
    for (const CharacterTouch* touch : {&motion.slope, &motion.wall, &motion.ceiling})
        stopAt(world, *touch, dt);
    if (!walks) leaveGround();
    if (motion.ground) {
        motion.landed = !walks;
        const Vec2 theirs =
            walks ? groundVelocity_ : velocityAt(world, motion.ground.body, motion.ground.point);
        if (!walks) velocity_ -= theirs;
        groundVelocity_ = theirs;
        ground_ = motion.ground;
        velocity_ = right * along(velocity_);
        const bool stays = walks && arrived && start == rode && position_ == start && before == ground_.body;
        if (!stays) holdOn(mover.probe());
        if (definition_.weight > 0.0f) {
            static_cast<void>(
                applyImpulseAt(world, ground_.body, gravity * (definition_.weight * dt), ground_.point));
        }
    } else {
        if (walks) velocity_ = right * along(velocity_), leaveGround();
        motion.leftGround = lostGround || stood;
    }
    return motion;
}

}  // namespace plumb::physics
