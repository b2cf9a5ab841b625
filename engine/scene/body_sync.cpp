#include "scene/body_sync.hpp"

#include <algorithm>
#include <utility>

#include "core/log.hpp"
#include "ecs/hierarchy.hpp"
#include "ecs/paused.hpp"
#include "math/angle.hpp"
#include "physics/model/bodies.hpp"
#include "physics/model/checks.hpp"
#include "scene/collider_shapes.hpp"
#include "scene/components/character_body.hpp"
#include "scene/components/kinematic_body.hpp"
#include "scene/components/name.hpp"
#include "scene/components/rigid_body.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/scene_physics.hpp"
#include "scene/components/static_body.hpp"
#include "scene/components/tile_collider.hpp"
#include "scene/components/tile_layer.hpp"
#include "scene/field_sync.hpp"
#include "scene/joint_sync.hpp"
#include "scene/soft_sync.hpp"
#include "scene/tile_bodies.hpp"

namespace plumb {

namespace {

using physics::BodyDefinition;
using physics::BodyId;
using physics::BodyKind;

BodyKind kindOf(const World& world, EntityId entity) {
    if (world.has<CharacterBody>(entity)) return BodyKind::Kinematic;
    if (world.has<RigidBody>(entity)) return BodyKind::Dynamic;
    return world.has<KinematicBody>(entity) ? BodyKind::Kinematic : BodyKind::Static;
}

bool hasFlag(const physics::World& bodies, BodyId body, physics::BodyFlag flag) {
    return (bodies.bodies.info[body.index].flags & flag) != 0;
}

bool contains(const std::vector<EntityId>& entities, EntityId entity) {
    return std::find(entities.begin(), entities.end(), entity) != entities.end();
}

std::uint64_t membersOf(const World& world) {
    return world.memberships<Transform, RigidBody, StaticBody, KinematicBody, CharacterBody, TileLayer,
                             TileCollider, Parent, Paused>() +
           colliderMembers(world) + jointMembers(world) + fieldMembers(world) + softMembers(world);
}

/// Brings the bodies of one world up to date with its components.
class BodySync {
public:
    BodySync(World& world, PhysicsState& state)
        : world_{world},
          reader_{world},
          state_{state},
          bodies_{state.world},
          collidersChanged_{plumb::collidersChanged(world, state.mark)} {}

    /// Looks at everybody: components came or went.
    void followAll() {
        ++state_.syncs;
        state_.unplaced.clear();
        state_.carried.clear();
        state_.driven.clear();
        const auto visit = [](void* sync, EntityId entity) { static_cast<BodySync*>(sync)->follow(entity); };
        forEachCollider(reader_, visit, this);
        // Bodies without any collider still fall and move.
        for (auto [entity, body] : reader_.query<const RigidBody>(with<Transform>)) follow(entity.id());
        for (auto [entity, body] : reader_.query<const KinematicBody>(with<Transform>)) follow(entity.id());
        removeUnseen();
        for (std::uint32_t i = 0; i < state_.links.size(); ++i) {
            if (!state_.links[i].entity) continue;
            if (state_.links[i].hasParent) state_.carried.push_back(i);
            if (bodies_.bodies.info[i].kind == BodyKind::Kinematic) state_.driven.push_back(i);
        }
    }

    void followChanged(std::uint64_t mark) {
        world_.eachChangedSince<Transform>(mark, [this](EntityId entity) {
            if (const BodyId body = bodyOf(state_, entity)) {
                followPose(body);
            } else if (contains(state_.unplaced, entity)) {
                tryAgain_ = true;
            }
        });
        if (!state_.carried.empty()) followCarried();
        world_.eachChangedSince<RigidBody>(mark, [this](EntityId entity) {
            if (const BodyId body = bodyOf(state_, entity)) followRigid(body);
        });
        const auto visit = [](void* sync, EntityId entity) {
            auto* self = static_cast<BodySync*>(sync);
            if (const BodyId body = bodyOf(self->state_, entity)) self->followColliders(body);
        };
        forEachChangedCollider(reader_, mark, visit, this);
        if (tryAgain_) followAll();
    }

private:
    [[nodiscard]] BodyId idAt(std::uint32_t body) const {
        return {body, bodies_.bodies.info[body].generation};
    }
    [[nodiscard]] BodyLink& linkOf(BodyId body) { return state_.links[body.index]; }

    /// What is below somebody who was put elsewhere goes with him.
    void stirBelow(EntityId entity) {
        const Children* family = reader_.find<Children>(entity);
        EntityId child = family == nullptr ? EntityId{} : family->first;
        for (const Parent* link = nullptr; child; child = link->next) {
            if (const BodyId body = bodyOf(state_, child)) state_.stirred.push_back(body.index);
            stirBelow(child);
            link = reader_.find<Parent>(child);
        }
    }
    /// Those who have a parent, in the order of the bodies; only where somebody above them, or they
    /// themselves, are elsewhere since the last look, be it that the physics moved them.
    void followCarried() {
        constexpr std::size_t kFew = 8;  // fewer than one in so many are worth sorting
        state_.stirred.clear();
        world_.eachChangedSince<Transform>(state_.carriedMark, [this](EntityId entity) {
            const BodyId body = bodyOf(state_, entity);
            if (body && linkOf(body).hasParent) state_.stirred.push_back(body.index);
            stirBelow(entity);
        });
        if (state_.stirred.size() * kFew < state_.carried.size()) {
            std::sort(state_.stirred.begin(), state_.stirred.end());
            for (const std::uint32_t body : state_.stirred) followPose(idAt(body));
        } else if (!state_.stirred.empty()) {
            for (const std::uint32_t body : state_.carried) followPose(idAt(body));
        }
        state_.stirred.clear();
    }

    void follow(EntityId entity) {
        const BodyKind kind = kindOf(reader_, entity);
        BodyId body = bodyOf(state_, entity);
        if (body && linkOf(body).seen == state_.syncs) return;
        if (body && bodies_.bodies.info[body.index].kind != kind) {
            forget(body);
            body = {};
        }
        if (!body) {
            create(entity, kind);
            return;
        }
        BodyLink& link = linkOf(body);
        link.seen = state_.syncs;
        link.hasParent = static_cast<bool>(parentOf(reader_, entity));
        followPose(body);
        if (collidersChanged_) followColliders(body);
        followRigid(body);
    }

    void create(EntityId entity, BodyKind kind) {
        const Pose pose = worldPose(reader_, entity);
        BodyDefinition definition;
        definition.kind = kind;
        definition.position = placeInMetres(pose.position, state_.scale);
        definition.angle = wrapAngle(pose.rotation);
        definition.user = userOf(entity);
        const auto made = physics::createBody(bodies_, definition);
        if (!made) {
            tellRefusal(world_, state_, entity, made.error());
            state_.unplaced.push_back(entity);
            return;
        }
        adopt(*made, entity, pose);
        followRigid(*made);
        followColliders(*made);
    }

    void adopt(BodyId body, EntityId entity, const Pose& pose) {
        if (state_.links.size() <= body.index) state_.links.resize(bodies_.bodies.size());
        if (state_.bodyOf.size() <= entity.index) state_.bodyOf.resize(entity.index + 1);
        BodyLink& link = linkOf(body);
        link = {};
        link.entity = entity;
        link.pose = pose;
        link.rotation = rotationOf(bodies_, body);
        link.seen = state_.syncs;
        link.hasParent = static_cast<bool>(parentOf(reader_, entity));
        state_.bodyOf[entity.index] = body.index + 1;
    }

    void forget(BodyId body) {
        BodyLink& link = linkOf(body);
        if (state_.bodyOf[link.entity.index] == body.index + 1) state_.bodyOf[link.entity.index] = 0;
        physics::destroyBody(bodies_, body);
        link = {};
    }

    void removeUnseen() {
        for (std::uint32_t i = 0; i < state_.links.size(); ++i) {
            const BodyLink& link = state_.links[i];
            if (link.entity && link.seen != state_.syncs) forget(idAt(i));
        }
    }

    /// Somebody put the entity elsewhere: the body goes there without a way. Kinematic ones are led (see
    /// kinematics.hpp).
    void followPose(BodyId body) {
        BodyLink& link = linkOf(body);
        const Pose pose = worldPose(reader_, link.entity);
        if (!(pose.scale == link.pose.scale)) {
            link.pose.scale = pose.scale;
            followColliders(body);
        }
        if (bodies_.bodies.info[body.index].kind == BodyKind::Kinematic) return;
        if (pose.position == link.pose.position && pose.rotation == link.pose.rotation) return;
        const auto moved = physics::setPosition(bodies_, body, placeInMetres(pose.position, state_.scale),
                                                wrapAngle(pose.rotation));
        if (accept(moved, link.entity)) {
            link.pose = pose;
            link.rotation = rotationOf(bodies_, body);
        } else {
            placeEntity(world_, link.entity, link.pose);
        }
    }

    void followColliders(BodyId body) {
        BodyLink& link = linkOf(body);
        const std::uint64_t outlines = outlinesOf(reader_, link.entity, link.pose.scale);
        if (outlines != link.outlines) {
            link.outlines = outlines;
            const auto made = makeShapes(bodies_, body, reader_, link.entity, link.pose.scale, state_.scale);
            accept(made, link.entity);
            return;
        }
        updateSurface(body, reader_.find<RigidBody>(link.entity));
    }

    void updateSurface(BodyId body, const RigidBody* rigid) {
        const EntityId entity = linkOf(body).entity;
        accept(updateSurfaces(bodies_, body, reader_, entity, rigid, state_.scale), entity);
    }

    /// Each value that differs is handed on, or put back when it is refused.
    void followRigid(BodyId body) {
        if (bodies_.bodies.info[body.index].kind != BodyKind::Dynamic) return;
        BodyLink& link = linkOf(body);
        const RigidBody& rigid = *reader_.find<RigidBody>(link.entity);
        followVelocity(body, link, rigid);
        followDrive(body, rigid);
        followMass(body, rigid);
        const bool locked = hasFlag(bodies_, body, physics::kLockX) == rigid.lockX &&
                            hasFlag(bodies_, body, physics::kLockY) == rigid.lockY;
        if (!locked) setLocks(bodies_, body, rigid.lockX, rigid.lockY);
        if (hasFlag(bodies_, body, physics::kFixedRotation) != rigid.fixedRotation)
            setFixedRotation(bodies_, body, rigid.fixedRotation);
        if (hasFlag(bodies_, body, physics::kBullet) != rigid.bullet) setBullet(bodies_, body, rigid.bullet);
        if (hasFlag(bodies_, body, physics::kCanSleep) != rigid.canSleep)
            setCanSleep(bodies_, body, rigid.canSleep);
        updateSurface(body, &rigid);
    }

    void followVelocity(BodyId body, BodyLink& link, const RigidBody& rigid) {
        if (rigid.velocity != link.velocity) {
            if (accept(setVelocity(bodies_, body, toMetres(rigid.velocity, state_.scale)), link.entity)) {
                link.velocity = rigid.velocity;
            } else {
                world_.get<RigidBody>(link.entity).velocity = link.velocity;
            }
        }
        if (rigid.angularVelocity == link.angularVelocity) return;
        if (accept(setAngularVelocity(bodies_, body, rigid.angularVelocity), link.entity)) {
            link.angularVelocity = rigid.angularVelocity;
        } else {
            world_.get<RigidBody>(link.entity).angularVelocity = link.angularVelocity;
        }
    }

    void followDrive(BodyId body, const RigidBody& rigid) {
        const physics::BodyDrive drive = bodies_.bodies.driveOf(body.index);
        const EntityId entity = linkOf(body).entity;
        const Vec2 acceleration = toMetres(rigid.acceleration, state_.scale);
        if (drive.acceleration != acceleration &&
            !accept(setAcceleration(bodies_, body, acceleration), entity))
            world_.get<RigidBody>(entity).acceleration = toPixels(drive.acceleration, state_.scale);
        if (drive.gravityScale != rigid.gravityScale &&
            !accept(setGravityScale(bodies_, body, rigid.gravityScale), entity))
            world_.get<RigidBody>(entity).gravityScale = drive.gravityScale;
        if ((drive.linearDrag != rigid.linearDrag || drive.angularDrag != rigid.angularDrag) &&
            !accept(setDrag(bodies_, body, rigid.linearDrag, rigid.angularDrag), entity)) {
            world_.get<RigidBody>(entity).linearDrag = drive.linearDrag;
            world_.get<RigidBody>(entity).angularDrag = drive.angularDrag;
        }
        const physics::Quality quality = qualityOf(rigid.quality);
        if (bodies_.bodies.info[body.index].quality != quality)
            accept(setQuality(bodies_, body, quality), entity);
    }

    /// kg; 0: it goes by its shapes.
    [[nodiscard]] float setMassOf(BodyId body) const {
        return (bodies_.bodies.info[body.index].owned & physics::kSetMass) != 0 ? massOf(bodies_, body)
                                                                                : 0.0f;
    }

    void followMass(BodyId body, const RigidBody& rigid) {
        const float known = setMassOf(body);
        if (rigid.mass == known) return;
        const EntityId entity = linkOf(body).entity;
        const Result<Done> set = rigid.mass > 0.0f
                                     ? setMass(bodies_, body, rigid.mass)
                                     : Result<Done>{Error{"RigidBody.mass", "expected a mass above 0",
                                                          "use a StaticBody for what never moves"}};
        if (accept(set, entity)) return;
        if (!(known > 0.0f)) static_cast<void>(setMass(bodies_, body, RigidBody{}.mass));
        world_.get<RigidBody>(entity).mass = setMassOf(body);
    }

    bool accept(const Result<Done>& result, EntityId entity) {
        if (!result) tellRefusal(world_, state_, entity, result.error());
        return result.ok();
    }

    World& world_;
    const World& reader_;
    PhysicsState& state_;
    physics::World& bodies_;
    bool collidersChanged_;
    bool tryAgain_ = false;  // somebody without a body may have found a place for it
};

std::string nameOf(const World& world, EntityId entity) {
    const Name* name = world.find<Name>(entity);
    const SceneEntity* part = world.find<SceneEntity>(entity);
    const std::string words{name == nullptr ? std::string_view{} : world.texts().find(name->text)};
    if (part == nullptr) return words.empty() ? format("entity {}", entity.index) : words;
    return format("{} @{}", words.empty() ? "entity" : words, hexText(part->id));
}

void takeSettings(World& world, PhysicsState& state, const physics::Settings& settings) {
    const auto& wanted = world.resource<PhysicsSettings>();
    const PixelScale scale = pixelScale(wanted.pixelsPerMetre);
    if (!(scale == state.scale)) {
        state = {};
        state.scale = scale;
    }
    const bool stirred = settings.gravity != state.world.settings.gravity && state.syncs > 0;
    state.world.settings = settings;
    if (!stirred) return;
    for (std::uint32_t i = 0; i < state.world.bodies.size(); ++i)
        physics::setAwake(state.world, {i, state.world.bodies.info[i].generation}, true);
}

}  // namespace

BodyId bodyOf(const PhysicsState& state, EntityId entity) {
    if (entity.index >= state.bodyOf.size() || state.bodyOf[entity.index] == 0) return {};
    const std::uint32_t index = state.bodyOf[entity.index] - 1;
    if (state.links[index].entity != entity) return {};
    return {index, state.world.bodies.info[index].generation};
}

void placeEntity(World& world, EntityId entity, const Pose& pose) {
    Transform* transform = world.find<Transform>(entity);
    if (transform == nullptr) return;
    const EntityId parent = parentOf(std::as_const(world), entity);
    if (!parent) {
        transform->position = pose.position;
        transform->rotation = pose.rotation;
        return;
    }
    const Pose local = relativeTo(worldPose(world, parent), {pose.position, pose.rotation, {1.0f, 1.0f}});
    transform->position = local.position;
    transform->rotation = local.rotation;
}

void tellRefusal(const World& world, PhysicsState& state, EntityId entity, const Error& error) {
    if (contains(state.refused, entity)) return;
    state.refused.push_back(entity);
    logWarning("Physics",
               Error{format("{}: {}", nameOf(world, entity), error.where), error.what, error.remedy});
}

physics::Settings physicsSettingsOf(World& world) {
    const auto& project = world.resource<PhysicsSettings>();
    const PixelScale scale = pixelScale(project.pixelsPerMetre);
    physics::Settings settings = project.tolerances;
    settings.gravity = toMetres(PhysicsSettings::kGravity, scale);
    settings.stayEvents = project.stayEvents;
    const auto takeGravity = [&](EntityId entity, const char* where, Vec2 pixels) {
        const Vec2 gravity = toMetres(pixels, scale);
        const Result<Done> checked = physics::checkVector(where, gravity, physics::kFastest);
        if (checked) {
            settings.gravity = gravity;
        } else {
            tellRefusal(world, world.resource<PhysicsState>(), entity, checked.error());
        }
    };
    takeGravity({}, "PhysicsSettings.gravity", project.gravity);
    for (auto [entity, scene] : std::as_const(world).query<const ScenePhysics>()) {
        takeGravity(entity.id(), "ScenePhysics.gravity", scene.gravity);
        settings.quality = static_cast<physics::Quality>(std::clamp(scene.quality, 0, 6));
        settings.integrator = scene.integrator;
        settings.iterations = static_cast<std::uint8_t>(std::clamp(scene.iterations, 1, 64));
        settings.automaticQuality = scene.automaticQuality;
        settings.tolerance = scene.tolerance * scale.metres;
        settings.continuous = scene.continuous;
        settings.sleeping = scene.sleeping;
        break;
    }
    return settings;
}

void followComponents(World& world, PhysicsState& state, const physics::Settings& settings) {
    takeSettings(world, state, settings);
    const std::uint64_t members = membersOf(world);
    const std::uint64_t mark = state.mark;
    const bool all = members != state.members || state.syncs == 0;
    BodySync sync{world, state};
    state.mark = world.markChanges();
    all ? sync.followAll() : sync.followChanged(mark);
    state.carriedMark = state.mark;
    followTiles(world, state, all);
    followJoints(world, state, all, mark);
    followFields(world, state, all);
    followSoftBodies(world, state, all);
    state.members = membersOf(world);
}

}  // namespace plumb
