#include "physics/model/edits.hpp"

#include "physics/islands/sleeping.hpp"
#include "physics/model/bodies.hpp"
#include "physics/model/bounds.hpp"
#include "physics/model/checks.hpp"

namespace plumb::physics {

namespace {

bool canHold(const World& world, const Joint& joint, std::uint32_t body, BodyKind kind) {
    const auto kindOf = [&](std::uint32_t i) { return i == body ? kind : world.bodies.info[i].kind; };
    return canHold(joint.kind, kindOf(joint.bodyA), kindOf(joint.bodyB));
}

}  // namespace

Result<Done> setKind(World& world, BodyId id, BodyKind kind) {
    const auto checked = firstOf(checkAlive("setKind", world, id), checkKind("setKind", kind));
    if (!checked) return checked;
    const std::uint32_t body = id.index;
    BodyInfo& info = world.bodies.info[body];
    if (kind == info.kind) return Done{};
    bool holds = true;
    forJointsOf(world, body,
                [&](std::uint32_t j) { holds &= canHold(world, world.joints.hot[j], body, kind); });
    if (!holds)
        return wrong("setKind", "one of its joints would have no dynamic body to move",
                     "destroy that joint first");
    wakeTouching(world, body);
    forJointsOf(world, body, [&](std::uint32_t j) {
        releaseColour(world, j);
        world.joints.hot[j].colour = kNoColour;
        world.newJoints = true;
    });
    forShapesOf(world, body, [&](std::uint32_t s) { countEffectsOfShape(world, s, -1); });
    countEffectsOfBody(world, body, -1);
    removeAwake(world, body);
    info.kind = kind;
    info.flags &= static_cast<std::uint8_t>(~(kHasTarget | kMoved));
    info.owned &= kBodyOff;
    countEffectsOfBody(world, body, 1);
    forShapesOf(world, body, [&](std::uint32_t s) { countEffectsOfShape(world, s, 1); });
    updateMass(world, body);
    BodyMotion& motion = world.bodies.motion[body];
    if (kind == BodyKind::Static) motion = {};
    if (kind == BodyKind::Dynamic && (info.flags & kFixedRotation) != 0) motion.angularVelocity = 0.0f;
    motion.restTime = 0.0f;
    if (kind != BodyKind::Static && isEnabled(world, id)) addAwake(world, body);
    forShapesOf(world, body, [&](std::uint32_t s) { alter(world, s); });
    forJointsOf(world, body, [&](std::uint32_t j) { joinIslandsOf(world, world.joints.hot[j]); });
    world.islandsStale |= info.firstJoint != kNone;
    return Done{};
}

void setEnabled(World& world, BodyId id, bool enabled) {
    if (!mayChange(world, id) || enabled == isEnabled(world, id)) return;
    const std::uint32_t body = id.index;
    wakeTouching(world, body);
    if (!enabled) forJointsOf(world, body, [&](std::uint32_t j) { removeAwakeJoint(world, j); });
    removeAwake(world, body);
    BodyInfo& info = world.bodies.info[body];
    info.owned ^= kBodyOff;
    forShapesOf(world, body, [&](std::uint32_t s) { world.shapes.info[s].flags ^= kShapeOff; });
    if (enabled && info.kind != BodyKind::Static) addAwake(world, body);
    forShapesOf(world, body, [&](std::uint32_t s) { alter(world, s); });
    world.islandsStale |= info.firstJoint != kNone;
    if (!enabled) return;
    forJointsOf(world, body, [&](std::uint32_t j) {
        const Joint& joint = world.joints.hot[j];
        wake(world, joint.bodyA);
        wake(world, joint.bodyB);
        addAwakeJoint(world, j);
        joinIslandsOf(world, joint);
    });
    world.newJoints = true;
}

Result<Done> setMassData(World& world, BodyId body, const MassData& data) {
    const auto checked = firstOf(checkAlive("setMassData", world, body),
                                 checkNumber("MassData.mass", data.mass, 0.0, kStrongest),
                                 checkVector("MassData.centre", data.centre, kLargest),
                                 checkNumber("MassData.inertia", data.inertia, 0.0, kStrongest));
    if (!checked || !isDynamic(world, body.index)) return checked;
    if (data.mass == 0.0f) return setMass(world, body, 0.0f);
    wake(world, body.index);
    world.bodies.info[body.index].owned |= kSetMass | kSetMassData;
    world.bodies.mass[body.index].mass = data.mass;
    world.bodies.mass[body.index].inertia = data.inertia;
    moveCentre(world, body.index, data.centre);
    updateMass(world, body.index);
    return checked;
}

}  // namespace plumb::physics
