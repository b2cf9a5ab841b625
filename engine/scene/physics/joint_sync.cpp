#include "scene/physics/joint_sync.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/text.hpp"
#include "ecs/paused.hpp"
#include "math/angle.hpp"
#include "physics/model/bodies.hpp"
#include "physics/model/joints.hpp"
#include "reflect/type_name.hpp"
#include "scene/components/joints/distance_joint.hpp"
#include "scene/components/joints/gear_joint.hpp"
#include "scene/components/joints/motor_joint.hpp"
#include "scene/components/joints/mouse_joint.hpp"
#include "scene/components/joints/prismatic_joint.hpp"
#include "scene/components/joints/pulley_joint.hpp"
#include "scene/components/joints/revolute_joint.hpp"
#include "scene/components/joints/weld_joint.hpp"
#include "scene/components/joints/wheel_joint.hpp"
#include "scene/physics/contact_events.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics/game_errors.hpp"

namespace plumb {

namespace {

using physics::BodyId;
using physics::JointDefinition;
using physics::JointKind;

/// Functions of a joint component type. In physics joints,
/// A is the body of JointLink::other, B that of the entity.
struct JointRow {
    std::string_view name;
    const JointLink* (*find)(const World& world, EntityId entity);
    void (*apply)(const JointLink& link, JointDefinition& joint, float metres);
    std::uint64_t (*members)(const World& world);
    bool (*changed)(const World& world, std::uint64_t mark);
    void (*remove)(World& world, EntityId entity);
    void (*forEach)(const World& world, void (*visit)(void*, EntityId), void* context);
};

template <class Component>
constexpr JointRow jointRow() {
    JointRow row{};
    row.name = shortTypeName<Component>();
    row.find = [](const World& world, EntityId entity) -> const JointLink* {
        return world.find<Component>(entity);
    };
    row.apply = [](const JointLink& link, JointDefinition& joint, float metres) {
        static_cast<const Component&>(link).apply(joint, metres);
    };
    row.members = [](const World& world) { return world.memberships<Component>(); };
    row.changed = [](const World& world, std::uint64_t mark) { return world.changedSince<Component>(mark); };
    row.remove = [](World& world, EntityId entity) { world.remove<Component>(entity); };
    row.forEach = [](const World& world, void (*visit)(void*, EntityId), void* context) {
        for (auto [entity, joint] : world.query<const Component>()) visit(context, entity.id());
    };
    return row;
}

// Gears are last, as they refer to two other joints.
constexpr JointRow kJoints[] = {
    jointRow<RevoluteJoint>(), jointRow<DistanceJoint>(), jointRow<PrismaticJoint>(),
    jointRow<WeldJoint>(),     jointRow<WheelJoint>(),    jointRow<MouseJoint>(),
    jointRow<MotorJoint>(),    jointRow<PulleyJoint>(),   jointRow<GearJoint>(),
};
constexpr std::uint8_t kRevolute = 0, kPrismatic = 2;  // indices in kJoints

/// Returns a hash of the values a joint is created from, except those that setters can change.
std::uint64_t jointHash(const JointDefinition& d, const JointLink& link) {
    Hasher hasher;
    const auto add = [&hasher](auto... values) { (hasher.add(values), ...); };
    add(static_cast<std::uint64_t>(d.kind), userOf(link.other), link.anchor.x, link.anchor.y,
        link.otherAnchor.x, link.otherAnchor.y, std::uint64_t{link.autoAnchor}, link.breakForce,
        std::uint64_t{link.collide}, static_cast<std::uint64_t>(qualityOf(link.quality)));
    add(d.axis.x, d.axis.y, d.referenceAngle, d.length, d.ratio, d.groundA.x, d.groundA.y, d.groundB.x,
        d.groundB.y, d.offset.x, d.offset.y);
    add(std::uint64_t{d.limit.on}, d.limit.lower, d.limit.upper, std::uint64_t{d.motor.on}, d.motor.maxForce);
    add(std::uint64_t{d.spring.on}, d.spring.hertz, d.spring.dampingRatio, d.spring.rest);
    add(d.maxForce, d.maxTorque, d.hertz, d.dampingRatio);
    return hasher.value() | 1;
}

class JointSync {
public:
    JointSync(World& world, PhysicsState& state) : world_{world}, state_{state}, bodies_{state.world} {}

    void followAll() {
        for (kind_ = 0; kind_ < std::size(kJoints); ++kind_) {
            kJoints[kind_].forEach(
                std::as_const(world_),
                [](void* sync, EntityId entity) { static_cast<JointSync*>(sync)->follow(entity); }, this);
        }
        std::erase_if(state_.joints, [this](const JointLinkage& linkage) {
            if (linkage.seen == state_.syncs) return false;
            physics::destroyJoint(bodies_, linkage.joint);
            return true;
        });
    }

    void followChanged(std::uint64_t mark) {
        for (JointLinkage& linkage : state_.joints) {
            const JointRow& row = kJoints[linkage.kind];
            if (!row.changed(std::as_const(world_), mark)) continue;
            const JointLink* link = row.find(std::as_const(world_), linkage.entity);
            if (link != nullptr) bring(linkage, *link);
        }
    }

private:
    void follow(EntityId entity) {
        const JointLink& link = *kJoints[kind_].find(std::as_const(world_), entity);
        JointLinkage& linkage = find(entity);
        linkage.seen = state_.syncs;
        bring(linkage, link);
    }

    /// Finds or adds the linkage of an entity. The search starts
    /// after the last result, as the order is mostly the same.
    JointLinkage& find(EntityId entity) {
        std::vector<JointLinkage>& joints = state_.joints;
        for (std::size_t i = 0; i < joints.size(); ++i) {
            finger_ = finger_ < joints.size() ? finger_ : 0;
            JointLinkage& linkage = joints[finger_++];
            if (linkage.entity == entity && linkage.kind == kind_) return linkage;
        }
        JointLinkage& linkage = joints.emplace_back();
        linkage.entity = entity;
        linkage.kind = static_cast<std::uint8_t>(kind_);
        return linkage;
    }

    /// Creates, recreates or changes the joint of a component.
    void bring(JointLinkage& linkage, const JointLink& link) {
        JointDefinition definition;
        kJoints[linkage.kind].apply(link, definition, state_.scale.metres);
        const std::uint64_t made = jointHash(definition, link);
        const bool lives = physics::alive(bodies_, linkage.joint);
        if (made == linkage.made && lives) {
            change(linkage, definition);
            return;
        }
        // A recreated joint keeps its anchors and initial angle
        // and length, unless its bodies or anchors changed.
        const JointDefinition before =
            lives ? bodies_.joints.definition[linkage.joint.index] : JointDefinition{};
        const bool sameEnds = lives && linkage.other == link.other && before.kind == definition.kind &&
                              before.anchorB == toMetres(link.anchor, state_.scale);
        physics::destroyJoint(bodies_, linkage.joint);
        linkage.joint = {};
        linkage.made = made;
        linkage.other = link.other;
        if (!findBodies(linkage, link, definition)) return;
        setAnchors(link, definition);
        if (sameEnds && link.autoAnchor) definition.anchorA = before.anchorA;
        if (!sameEnds) noteStart(linkage, definition);
        finish(linkage, link, definition);
        const auto joint = physics::createJoint(bodies_, definition);
        if (joint) {
            linkage.joint = *joint;
        } else {
            report(linkage, joint.error());
        }
    }

    void change(JointLinkage& linkage, const JointDefinition& definition) {
        const JointDefinition& known = bodies_.joints.definition[linkage.joint.index];
        Result<Done> set = Done{};
        if (known.motor.speed != definition.motor.speed)
            set = physics::setMotorSpeed(bodies_, linkage.joint, definition.motor.speed);
        if (known.kind == JointKind::Mouse && !(known.target == definition.target))
            set = physics::setTarget(bodies_, linkage.joint, definition.target);
        if (!set) report(linkage, set.error());
    }

    void report(const JointLinkage& linkage, const Error& error) {
        const std::string_view component = kJoints[linkage.kind].name;
        logRefusal(world_, state_, linkage.entity, gameError(error, component, state_.scale));
    }

    /// Reports an end without a body, unless its entity was destroyed, which ends the joint, or has no body
    /// for now because it is paused.
    void reportMissing(const JointLinkage& linkage, const char* field, EntityId end) {
        if (!std::as_const(world_).has<Transform>(end) || std::as_const(world_).has<Paused>(end)) return;
        report(linkage, {format("{}{}", kJoints[linkage.kind].name, field),
                         format("{} has no body to join", describedEntity(world_, end)),
                         "add a RigidBody, a KinematicBody or a StaticBody to it; without `other` the joint "
                         "connects to the world"});
    }

    /// @return false if one of the bodies does not exist yet
    bool findBodies(JointLinkage& linkage, const JointLink& link, JointDefinition& definition) {
        definition.b = bodyOf(std::as_const(state_), linkage.entity);
        definition.a = link.other ? bodyOf(std::as_const(state_), link.other) : ground();
        if (definition.a && definition.b) return true;
        definition.b ? reportMissing(linkage, ".other", link.other)
                     : reportMissing(linkage, "", linkage.entity);
        linkage.made = 0;  // retry when bodies are created
        return false;
    }

    BodyId ground() {
        if (!physics::alive(bodies_, state_.ground)) {
            const auto made = physics::createBody(bodies_, {.kind = physics::BodyKind::Static});
            if (made) state_.ground = *made;
        }
        return state_.ground;
    }

    void setAnchors(const JointLink& link, JointDefinition& definition) {
        definition.anchorB = toMetres(link.anchor, state_.scale);
        definition.anchorA = toMetres(link.otherAnchor, state_.scale);
        if (!link.autoAnchor) return;
        const physics::WorldPosition place =
            positionOf(bodies_, definition.b) + rotate(rotationOf(bodies_, definition.b), definition.anchorB);
        definition.anchorA =
            unrotate(rotationOf(bodies_, definition.a), place - positionOf(bodies_, definition.a));
    }

    [[nodiscard]] physics::WorldPosition placeOf(BodyId body, Vec2 anchor) const {
        return positionOf(bodies_, body) + rotate(rotationOf(bodies_, body), anchor);
    }

    /// Stores the initial angle and length of a joint.
    void noteStart(JointLinkage& linkage, const JointDefinition& d) const {
        const physics::WorldPosition a = placeOf(d.a, d.anchorA), b = placeOf(d.b, d.anchorB);
        linkage.startAngle = angleOf(between(rotationOf(bodies_, d.a), rotationOf(bodies_, d.b)));
        linkage.startLength = d.kind == JointKind::Pulley
                                  ? length(a - physics::WorldPosition{d.groundA}) +
                                        d.ratio * length(b - physics::WorldPosition{d.groundB})
                                  : length(b - a);
    }

    /// Sets the values of the definition that depend on the bodies.
    void finish(const JointLinkage& linkage, const JointLink& link, JointDefinition& d) const {
        d.referenceAngle += linkage.startAngle;
        d.collideConnected = link.collide;
        d.quality = qualityOf(link.quality);
        if (link.breakForce > 0.0f) d.breakForce = link.breakForce * state_.scale.metres;
        d.user = userOf(linkage.entity);
        if (d.kind == JointKind::Distance && d.length == 0.0f)
            d.length = d.spring.rest = d.limit.upper = linkage.startLength;
        if (d.kind == JointKind::Pulley && d.length == 0.0f) d.length = linkage.startLength;
        if (d.kind == JointKind::Gear) {
            d.jointA = geared(link.other);
            d.jointB = geared(linkage.entity);
        }
    }

    /// Returns the RevoluteJoint or PrismaticJoint of an entity, for a gear.
    [[nodiscard]] physics::JointId geared(EntityId entity) const {
        for (const JointLinkage& linkage : state_.joints) {
            const bool fits = linkage.kind == kRevolute || linkage.kind == kPrismatic;
            if (linkage.entity == entity && fits) return linkage.joint;
        }
        return {};
    }

    World& world_;
    PhysicsState& state_;
    physics::World& bodies_;
    std::size_t kind_ = 0;
    std::size_t finger_ = 0;  // index at which find() continues its search
};

}  // namespace

void followJoints(World& world, PhysicsState& state, bool membersChanged, bool bodiesCameOrWent,
                  std::uint64_t mark) {
    JointSync sync{world, state};
    const auto waits = [&](const JointLinkage& linkage) {
        return !physics::alive(state.world, linkage.joint);
    };
    if (membersChanged ||
        (bodiesCameOrWent && std::any_of(state.joints.begin(), state.joints.end(), waits))) {
        sync.followAll();
    } else if (!state.joints.empty()) {
        sync.followChanged(mark);
    }
}

void publishBroken(World& world, PhysicsState& state) {
    for (const physics::JointId broken : state.world.brokenJoints) {
        const auto linkage = std::find_if(state.joints.begin(), state.joints.end(),
                                          [&](const JointLinkage& known) { return known.joint == broken; });
        if (linkage == state.joints.end()) continue;
        world.emit(JointBroke{linkage->entity, linkage->other});
        kJoints[linkage->kind].remove(world, linkage->entity);
    }
}

std::uint64_t jointMembers(const World& world) {
    std::uint64_t members = 0;
    for (const JointRow& row : kJoints) members += row.members(world);
    return members;
}

}  // namespace plumb
