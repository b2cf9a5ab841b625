#include "app/effect_rows.hpp"
#include "scene/components.hpp"

namespace plumb {
namespace {

using physics::Effect;

// Which components call for an effect of the physics. The physics counts its callers by itself; this list is
// for people to read.

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

template <class... Callers>
EffectRow row(Effect effect, std::string_view doc, bool byDefault = false) {
    EffectRow made{physics::nameOf(effect), doc, {}, nullptr, effect, byDefault};
    if constexpr (sizeof...(Callers) > 0) made.callers = kCallersOf<Callers...>;
    return made;
}

constexpr bool kByDefault = true;

}  // namespace

std::vector<EffectRow> physicsEffectRows() {
    std::vector<EffectRow> rows;
    rows.push_back(
        row<Some<RigidBody, falls>, Rope, Cloth, Jelly>(Effect::Gravity, "Bodies fall.", kByDefault));
    rows.push_back(row<Some<RigidBody, turns>>(Effect::Rotation, "Bodies turn.", kByDefault));
    rows.push_back(row<Some<BoxCollider, rubs>, Some<CircleCollider, rubs>, Some<CapsuleCollider, rubs>,
                       Some<PolygonCollider, rubs>, Some<ChainCollider, rubs>, Some<TileCollider, tilesRub>>(
        Effect::Friction, "What touches rubs.", kByDefault));
    rows.push_back(
        row<Some<RigidBody, bouncesItself>, Some<BoxCollider, bounces>, Some<CircleCollider, bounces>,
            Some<CapsuleCollider, bounces>, Some<PolygonCollider, bounces>, Some<ChainCollider, bounces>,
            Some<TileCollider, tilesBounce>>(Effect::Restitution, "What touches bounces off."));
    rows.push_back(row(Effect::Rolling, "Round things roll out."));
    rows.push_back(row<Some<RigidBody, slows>>(Effect::Drag, "The air slows bodies."));
    rows.push_back(row<RevoluteJoint, DistanceJoint, PrismaticJoint, WeldJoint, WheelJoint, MouseJoint,
                       MotorJoint, PulleyJoint, GearJoint>(Effect::Joints, "Bodies are tied together."));
    rows.push_back(
        row<Some<RevoluteJoint, hasMotor>, Some<PrismaticJoint, hasMotor>, Some<WheelJoint, hasMotor>>(
            Effect::Motors, "Joints drive what they tie."));
    rows.push_back(row<RigidBody>(Effect::Continuous, "Fast bodies pass through nothing.", kByDefault));
    rows.push_back(row<Some<RigidBody, sleeps>>(Effect::Sleep, "What rests costs nothing.", kByDefault));
    rows.push_back(
        row<Some<BoxCollider, isSolid>, Some<CircleCollider, isSolid>, Some<CapsuleCollider, isSolid>,
            Some<PolygonCollider, isSolid>, Some<ChainCollider, isSolid>, TileCollider>(
            Effect::Contacts, "Bodies collide.", kByDefault));
    rows.push_back(
        row<Some<BoxCollider, isTrigger>, Some<CircleCollider, isTrigger>, Some<CapsuleCollider, isTrigger>,
            Some<PolygonCollider, isTrigger>, Some<ChainCollider, isTrigger>>(
            Effect::Triggers, "Colliders notice what is inside them."));
    rows.push_back(
        row<BoxCollider, CircleCollider, CapsuleCollider, PolygonCollider, ChainCollider, TileCollider>(
            Effect::ContactEvents, "Systems hear what touches what.", kByDefault));
    rows.push_back(
        row<Some<BoxCollider, isOneWay>, Some<CircleCollider, isOneWay>, Some<CapsuleCollider, isOneWay>,
            Some<PolygonCollider, isOneWay>, Some<ChainCollider, isOneWay>>(
            Effect::OneWay, "Planks let through from below."));
    rows.push_back(
        row<Some<BoxCollider, conveys>, Some<CircleCollider, conveys>, Some<CapsuleCollider, conveys>,
            Some<PolygonCollider, conveys>, Some<ChainCollider, conveys>>(Effect::Conveyor,
                                                                          "Surfaces carry along."));
    rows.push_back(row<KinematicBody, CharacterBody>(Effect::Kinematics, "Platforms push and carry."));
    rows.push_back(row<Some<RigidBody, isLocked>>(Effect::Locks, "Bodies keep to a line."));
    rows.push_back(row<GravityField>(Effect::AreaGravity, "Regions with a gravity of their own."));
    rows.push_back(row<WindField>(Effect::Wind, "Wind blows in regions."));
    rows.push_back(row<BuoyancyField>(Effect::Buoyancy, "Things swim."));
    rows.push_back(row<Attractor>(Effect::Attractor, "Points pull or push away."));
    rows.push_back(row<Explosion>(Effect::Explosion, "Blasts throw bodies about."));
    rows.push_back(row(Effect::Springs, "Springs of game code, integrated with the bodies."));
    rows.push_back(row<Rope, Cloth, Jelly>(Effect::SoftBodies, "Ropes, cloth and jellies."));
    return rows;
}

}  // namespace plumb
