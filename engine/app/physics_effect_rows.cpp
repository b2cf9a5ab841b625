#include "app/effect_rows.hpp"
#include "scene/components.hpp"

namespace plumb {
namespace {

using physics::Effect;

// Components that request an effect of the physics, for display only: the physics counts the requests itself.

bool falls(const RigidBody& body) { return body.gravityScale != 0.0f; }
bool turns(const RigidBody& body) { return !body.fixedRotation; }
bool slows(const RigidBody& body) { return body.linearDrag > 0.0f || body.angularDrag > 0.0f; }
bool sleeps(const RigidBody& body) { return body.canSleep; }
bool isLocked(const RigidBody& body) { return body.lockX || body.lockY; }
bool bouncesItself(const RigidBody& body) { return body.bounciness > 0.0f; }

template <class T>
bool isTrigger(const T& collider) {
    return collider.isTrigger;
}
template <class T>
bool isSolid(const T& collider) {
    return !collider.isTrigger;
}
template <class T>
bool isOneWay(const T& collider) {
    return collider.oneWay;
}
template <class T>
bool rubs(const T& collider) {
    return !collider.isTrigger && collider.friction != 0.0f;
}
template <class T>
bool bounces(const T& collider) {
    return !collider.isTrigger && collider.bounciness > 0.0f;
}
template <class T>
bool conveys(const T& collider) {
    return !collider.isTrigger && collider.surfaceSpeed != 0.0f;
}
template <class T>
bool hasMotor(const T& joint) {
    return joint.motor;
}

bool tilesRub(const TileCollider& tiles) { return tiles.friction > 0.0f; }
bool tilesBounce(const TileCollider& tiles) { return tiles.bounciness > 0.0f; }

template <class... Requesters>
EffectRow row(Effect effect, std::string_view doc, bool byDefault = false) {
    EffectRow made{physics::nameOf(effect), doc, {}, nullptr, effect, byDefault};
    if constexpr (sizeof...(Requesters) > 0) made.requesters = kRequestersOf<Requesters...>;
    return made;
}

constexpr bool kByDefault = true;

}  // namespace

std::vector<EffectRow> physicsEffectRows() {
    std::vector<EffectRow> rows;
    rows.push_back(row<Some<RigidBody, falls>, Rope, Cloth, Jelly>(Effect::Gravity, "Gravity acts on bodies.",
                                                                   kByDefault));
    rows.push_back(row<Some<RigidBody, turns>>(Effect::Rotation, "Bodies rotate.", kByDefault));
    rows.push_back(row<Some<BoxCollider, rubs>, Some<CircleCollider, rubs>, Some<CapsuleCollider, rubs>,
                       Some<PolygonCollider, rubs>, Some<ChainCollider, rubs>, Some<TileCollider, tilesRub>>(
        Effect::Friction, "Friction between touching bodies.", kByDefault));
    rows.push_back(
        row<Some<RigidBody, bouncesItself>, Some<BoxCollider, bounces>, Some<CircleCollider, bounces>,
            Some<CapsuleCollider, bounces>, Some<PolygonCollider, bounces>, Some<ChainCollider, bounces>,
            Some<TileCollider, tilesBounce>>(Effect::Restitution, "Bodies bounce."));
    rows.push_back(row(Effect::Rolling, "Rolling resistance slows round bodies."));
    rows.push_back(row<Some<RigidBody, slows>>(Effect::Drag, "Drag slows bodies."));
    rows.push_back(row<RevoluteJoint, DistanceJoint, PrismaticJoint, WeldJoint, WheelJoint, MouseJoint,
                       MotorJoint, PulleyJoint, GearJoint>(Effect::Joints, "Joints connect bodies."));
    rows.push_back(
        row<Some<RevoluteJoint, hasMotor>, Some<PrismaticJoint, hasMotor>, Some<WheelJoint, hasMotor>>(
            Effect::Motors, "Motors of joints drive bodies."));
    rows.push_back(row<RigidBody>(Effect::Continuous,
                                  "Continuous collision detection: fast bodies do not pass through others.",
                                  kByDefault));
    rows.push_back(row<Some<RigidBody, sleeps>>(Effect::Sleep, "Bodies at rest fall asleep and cost no time.",
                                                kByDefault));
    rows.push_back(
        row<Some<BoxCollider, isSolid>, Some<CircleCollider, isSolid>, Some<CapsuleCollider, isSolid>,
            Some<PolygonCollider, isSolid>, Some<ChainCollider, isSolid>, TileCollider>(
            Effect::Contacts, "Bodies collide.", kByDefault));
    rows.push_back(
        row<Some<BoxCollider, isTrigger>, Some<CircleCollider, isTrigger>, Some<CapsuleCollider, isTrigger>,
            Some<PolygonCollider, isTrigger>, Some<ChainCollider, isTrigger>>(
            Effect::Triggers, "Triggers detect overlapping colliders."));
    rows.push_back(
        row<BoxCollider, CircleCollider, CapsuleCollider, PolygonCollider, ChainCollider, TileCollider>(
            Effect::ContactEvents, "Contacts and overlaps emit events.", kByDefault));
    rows.push_back(
        row<Some<BoxCollider, isOneWay>, Some<CircleCollider, isOneWay>, Some<CapsuleCollider, isOneWay>,
            Some<PolygonCollider, isOneWay>, Some<ChainCollider, isOneWay>>(
            Effect::OneWay, "One-way colliders let bodies pass from below."));
    rows.push_back(
        row<Some<BoxCollider, conveys>, Some<CircleCollider, conveys>, Some<CapsuleCollider, conveys>,
            Some<PolygonCollider, conveys>, Some<ChainCollider, conveys>>(Effect::Conveyor,
                                                                          "Conveyor surfaces move bodies."));
    rows.push_back(
        row<KinematicBody, CharacterBody>(Effect::Kinematics, "Kinematic bodies push and carry others."));
    rows.push_back(row<Some<RigidBody, isLocked>>(Effect::Locks, "Bodies are locked along an axis."));
    rows.push_back(row<GravityField>(Effect::AreaGravity, "Regions have their own gravity."));
    rows.push_back(row<WindField>(Effect::Wind, "Wind blows in regions."));
    rows.push_back(row<BuoyancyField>(Effect::Buoyancy, "Bodies float in fluids."));
    rows.push_back(row<Attractor>(Effect::Attractor, "Attractors pull bodies or push them away."));
    rows.push_back(row<Explosion>(Effect::Explosion, "Explosions push bodies away."));
    rows.push_back(row(Effect::Springs, "Springs made by game code, integrated with the motion of bodies."));
    rows.push_back(row<Rope, Cloth, Jelly>(Effect::SoftBodies, "Ropes, cloth and jellies are simulated."));
    return rows;
}

}  // namespace plumb
