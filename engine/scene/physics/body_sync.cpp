#include "scene/physics/body_sync.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "ecs/paused.hpp"
#include "math/angle.hpp"
#include "physics/model/bodies.hpp"
#include "physics/model/checks.hpp"
#include "scene/components/bodies/character_body.hpp"
#include "scene/components/bodies/kinematic_body.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/bodies/static_body.hpp"
#include "scene/components/colliders/tile_collider.hpp"
#include "scene/components/drawing/tile_layer.hpp"
#include "scene/components/scene_physics.hpp"
#include "scene/physics/collider_shapes.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics/field_sync.hpp"
#include "scene/physics/joint_sync.hpp"
#include "scene/physics/soft_sync.hpp"
#include "scene/physics/tile_bodies.hpp"

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

PhysicsMembers membersOf(const World& world) {
    // A paused entity is in no query, so pausing counts as a membership change.
    const std::uint64_t paused = world.memberships<Paused>();
    PhysicsMembers members;
    members.bodies = world.memberships<Transform, RigidBody, StaticBody, KinematicBody, CharacterBody,
                                       TileLayer, TileCollider, Parent>() +
                     colliderMembers(world) + paused;
    members.joints = jointMembers(world) + paused;
    members.fields = fieldMembers(world) + paused;
    members.softBodies = softMembers(world) + paused;
    return members;
}

/// Adds an index to a sorted list, or removes it.
void setListed(std::vector<std::uint32_t>& list, std::uint32_t index, bool isListed) {
    const auto at = std::lower_bound(list.begin(), list.end(), index);
    const bool wasListed = at != list.end() && *at == index;
    if (isListed == wasListed) return;
    if (isListed) {
        list.insert(at, index);
    } else {
        list.erase(at);
    }
}

/// Updates the bodies of a world from its components.
class BodySync {
public:
    BodySync(World& world, PhysicsState& state)
        : world_{world}, reader_{world}, state_{state}, bodies_{state.world} {}

    /// Updates the bodies whose components were written since the mark; the cost depends on their number.
    /// Writes are found in an arbitrary order (tools may affect it), but bodies are updated in a fixed order.
    /// @param membersChanged  components were added or removed too
    /// @return true if a body was created or destroyed
    bool follow(std::uint64_t mark, bool membersChanged) {
        state_.arrived.clear();
        state_.departed.clear();
        state_.poses.clear();
        ++state_.follows;
        noteWrites(mark);
        if (membersChanged) noteMembers(mark);
        const bool cameOrWent = arriveAndDepart();
        followStale();
        return cameOrWent;
    }

private:
    // Bits of PhysicsState::stale: which components of a body's entity were written.
    static constexpr std::uint8_t kPose = 1, kRigid = 2, kColliders = 4, kAll = 7;

    void note(EntityId entity, std::uint8_t what) {
        if (const BodyId body = bodyOf(state_, entity)) note(body.index, what);
    }
    void note(std::uint32_t body, std::uint8_t what) {
        if (state_.stale.size() <= body) state_.stale.resize(bodies_.bodies.size());
        state_.stale[body] |= what;
        firstStale_ = std::min(firstStale_, body);
        endStale_ = std::max(endStale_, body + 1);
    }
    /// Marks the bodies of an entity's descendants, as they move with it.
    void noteBelow(EntityId entity) {
        if (!firstChildOf(reader_, entity) || !isFirstVisit(entity)) return;
        forEachBelow(reader_, entity, [this](EntityId below) {
            note(below, kPose);
            return isFirstVisit(below);
        });
    }
    /// False if the descendants of an entity are marked already in this sync.
    bool isFirstVisit(EntityId entity) {
        if (state_.below.size() <= entity.index) state_.below.resize(entity.index + 1);
        return std::exchange(state_.below[entity.index], state_.follows) != state_.follows;
    }

    void noteWrites(std::uint64_t mark) {
        world_.eachChangedSince<Transform>(mark, [this](EntityId entity) {
            note(entity, kPose);
            if (contains(state_.unplaced, entity)) compare(entity);  // its position may be valid now
        });
        world_.eachChangedSince<RigidBody>(mark, [this](EntityId entity) { note(entity, kRigid); });
        const auto visit = [](void* sync, EntityId entity) {
            static_cast<BodySync*>(sync)->note(entity, kColliders);
        };
        forEachChangedCollider(reader_, mark, visit, this);
        if (state_.carried.empty()) return;
        // Transforms written since the last sync, including those written by the physics step.
        world_.eachChangedSince<Transform>(state_.carriedMark, [this](EntityId entity) {
            const BodyId body = bodyOf(state_, entity);
            if (body && linkOf(body).hasParent) note(body.index, kPose);
            noteBelow(entity);
        });
    }

    void noteMembers(std::uint64_t mark) {
        std::erase_if(state_.unplaced, [this](EntityId entity) { return !orderOf(entity); });
        for (const EntityId entity : state_.unplaced) compare(entity);
        const auto visit = [](void* sync, EntityId entity) { static_cast<BodySync*>(sync)->compare(entity); };
        forEachChangedCollider(reader_, mark, visit, this);
        compareChanged<Transform, RigidBody, StaticBody, KinematicBody, CharacterBody, Paused>(mark);
        const auto noteFamily = [this](EntityId entity) {
            compare(entity);
            const BodyId body = bodyOf(state_, entity);
            if (body) setParented(body, static_cast<bool>(parentOf(reader_, entity)));
            note(entity, kAll);
            if (!state_.carried.empty()) noteBelow(entity);
        };
        world_.eachChangedSince<Parent>(mark, noteFamily);
        world_.eachLossSince(mark, noteFamily);
        checkBodies(mark);
    }

    /// Checks the entities whose kind of body may have changed.
    void checkBodies(std::uint64_t mark) {
        const auto check = [this](EntityId entity) { checkBody(entity); };
        world_.eachChangedSince<RigidBody>(mark, [&](EntityId entity) {
            // Each step writes the RigidBodies that move, but the kind of a body is not written.
            const BodyId body = bodyOf(state_, entity);
            if (!body || bodies_.bodies.info[body.index].kind != BodyKind::Dynamic) checkBody(entity);
        });
        world_.eachChangedSince<StaticBody>(mark, check);
        world_.eachChangedSince<KinematicBody>(mark, check);
        world_.eachLossSince(mark, check);
    }

    template <class... Components>
    void compareChanged(std::uint64_t mark) {
        (world_.eachChangedSince<Components>(mark, [this](EntityId entity) { compare(entity); }), ...);
    }

    void followStale() {
        for (std::uint32_t index = firstStale_; index < endStale_; ++index) {
            const std::uint8_t stale = std::exchange(state_.stale[index], std::uint8_t{0});
            if (stale == 0) continue;
            const BodyId body = idAt(index);
            if ((stale & kPose) != 0) followPose(body);
            if ((stale & kRigid) != 0) followRigid(body);
            if ((stale & kColliders) != 0) followColliders(body);
        }
    }

    /// Returns the sort key for creating the body of an entity: the order of queries over colliders, kind by
    /// kind, then over bodies without collider. nullopt if the entity needs no body.
    [[nodiscard]] std::optional<std::uint64_t> orderOf(EntityId entity) const {
        if (!reader_.has<Transform>(entity) || reader_.has<Paused>(entity)) return std::nullopt;
        if (const auto order = colliderOrder(reader_, entity)) return order;
        constexpr std::uint64_t kFirstRigid = std::uint64_t{1} << 62,
                                kFirstKinematic = std::uint64_t{1} << 63;
        if (reader_.has<RigidBody>(entity)) return kFirstRigid | reader_.positionOf<RigidBody>(entity);
        if (reader_.has<KinematicBody>(entity))
            return kFirstKinematic | reader_.positionOf<KinematicBody>(entity);
        return std::nullopt;
    }

    /// Records if an entity's body is missing or has the wrong kind, or if a body is no longer needed.
    void compare(EntityId entity) {
        ++state_.visits;
        const std::uint32_t linked =
            entity.index < state_.bodyOf.size() ? state_.bodyOf[entity.index] : 0;  // index + 1
        const bool isOwn = linked != 0 && state_.links[linked - 1].entity == entity;
        const std::optional<std::uint64_t> order = orderOf(entity);
        if (linked != 0 && !(isOwn && order)) state_.departed.push_back(linked - 1);
        if (order && !(isOwn && bodies_.bodies.info[linked - 1].kind == kindOf(reader_, entity)))
            state_.arrived.push_back({*order, entity});
    }

    /// Reports components that give the entity no body, or another one than they say.
    void checkBody(EntityId entity) {
        const bool isRigid = reader_.has<RigidBody>(entity), isStatic = reader_.has<StaticBody>(entity),
                   isKinematic = reader_.has<KinematicBody>(entity);
        // A CharacterBody counts, whatever else the entity of a controller has.
        if (!(isRigid || isStatic || isKinematic) || reader_.has<CharacterBody>(entity)) return;
        const char* const body = isRigid ? "RigidBody" : isKinematic ? "KinematicBody" : "StaticBody";
        if (!reader_.has<Transform>(entity)) {
            logRefusal(world_, state_, entity,
                       {body, "the entity has no Transform, so it has no body", "add a Transform"});
        } else if ((isRigid && (isStatic || isKinematic)) || (isKinematic && isStatic)) {
            const char* const what = isRigid ? "it has no effect, as the entity has a RigidBody, too"
                                             : "it has no effect, as the entity has a KinematicBody, too";
            logRefusal(world_, state_, entity,
                       {isStatic ? "StaticBody" : "KinematicBody", what, "remove one of the two"});
        }
    }

    /// Creates bodies before destroying others, so that no new
    /// body reuses the index of one destroyed in the same tick.
    bool arriveAndDepart() {
        const auto sortOut = [](auto& list) {
            std::sort(list.begin(), list.end());
            list.erase(std::unique(list.begin(), list.end()), list.end());
        };
        sortOut(state_.arrived);
        sortOut(state_.departed);
        for (const BodyArrival& arrival : state_.arrived) {
            std::erase(state_.unplaced, arrival.entity);
            if (const BodyId ofOtherKind = bodyOf(state_, arrival.entity)) forget(ofOtherKind);
            create(arrival.entity, kindOf(reader_, arrival.entity));
        }
        // From the back of the lists, where erasing moves the least.
        for (auto body = state_.departed.rbegin(); body != state_.departed.rend(); ++body)
            unlist(idAt(*body));
        for (const std::uint32_t body : state_.departed) forget(idAt(body));
        return !state_.arrived.empty() || !state_.departed.empty();
    }

    [[nodiscard]] BodyId idAt(std::uint32_t body) const {
        return {body, bodies_.bodies.info[body].generation};
    }
    [[nodiscard]] BodyLink& linkOf(BodyId body) { return state_.links[body.index]; }

    void setParented(BodyId body, bool hasParent) {
        linkOf(body).hasParent = hasParent;
        setListed(state_.carried, body.index, hasParent);
    }

    void create(EntityId entity, BodyKind kind) {
        const Pose pose = state_.poses.of(reader_, entity);
        BodyDefinition definition;
        definition.kind = kind;
        definition.position = positionInMetres(pose.position, state_.scale);
        definition.angle = wrapAngle(pose.rotation);
        definition.user = userOf(entity);
        const auto made = physics::createBody(bodies_, definition);
        if (!made) {
            logRefusal(world_, state_, entity, made.error());
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
        setParented(body, static_cast<bool>(parentOf(reader_, entity)));
        setListed(state_.driven, body.index, bodies_.bodies.info[body.index].kind == BodyKind::Kinematic);
        state_.bodyOf[entity.index] = body.index + 1;
    }

    void unlist(BodyId body) {
        setParented(body, false);
        setListed(state_.driven, body.index, false);
    }

    void forget(BodyId body) {
        BodyLink& link = linkOf(body);
        if (state_.bodyOf[link.entity.index] == body.index + 1) state_.bodyOf[link.entity.index] = 0;
        unlist(body);
        if (body.index < state_.stale.size()) state_.stale[body.index] = 0;
        physics::destroyBody(bodies_, body);
        link = {};
    }

    /// Teleports the body to the pose of its entity if that was
    /// moved. Kinematic bodies are moved in driveKinematics().
    void followPose(BodyId body) {
        BodyLink& link = linkOf(body);
        const Pose pose = state_.poses.of(reader_, link.entity);
        if (!(pose.scale == link.pose.scale)) {
            link.pose.scale = pose.scale;
            followColliders(body);
        }
        if (bodies_.bodies.info[body.index].kind == BodyKind::Kinematic) return;
        if (pose.position == link.pose.position && pose.rotation == link.pose.rotation) return;
        const auto moved = physics::setPosition(bodies_, body, positionInMetres(pose.position, state_.scale),
                                                wrapAngle(pose.rotation));
        if (accept(moved, link.entity)) {
            link.pose = pose;
            link.rotation = rotationOf(bodies_, body);
        } else {
            placeEntity(world_, state_.poses, link.entity, link.pose);
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

    /// Applies changed values of the RigidBody to the body; invalid ones are reset in the component.
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

    /// Returns the mass set for the body, kg; 0 if it follows from its shapes.
    [[nodiscard]] float setMassOf(BodyId body) const {
        return (bodies_.bodies.info[body.index].owned & physics::kSetMass) != 0 ? massOf(bodies_, body)
                                                                                : 0.0f;
    }

    void followMass(BodyId body, const RigidBody& rigid) {
        const float known = setMassOf(body);
        if (rigid.mass == known && known > 0.0f) return;
        const EntityId entity = linkOf(body).entity;
        const Result<Done> set =
            rigid.mass > 0.0f ? setMass(bodies_, body, rigid.mass)
                              : Result<Done>{Error{"RigidBody.mass",
                                                   format("expected a mass above 0, found {}", rigid.mass),
                                                   "use a StaticBody for a body that never moves"}};
        if (accept(set, entity)) return;
        if (!(known > 0.0f)) static_cast<void>(setMass(bodies_, body, RigidBody{}.mass));
        world_.get<RigidBody>(entity).mass = setMassOf(body);
    }

    bool accept(const Result<Done>& result, EntityId entity) {
        if (!result) logRefusal(world_, state_, entity, result.error());
        return result.ok();
    }

    World& world_;
    const World& reader_;
    PhysicsState& state_;
    physics::World& bodies_;
    std::uint32_t firstStale_ = physics::kNone,
                  endStale_ = 0;  // first body index with a mark in `stale`, and the last one + 1
};

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
            logRefusal(world, world.resource<PhysicsState>(), entity, checked.error());
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
    const PhysicsMembers members = membersOf(world);
    const PhysicsMembers known = state.members;
    const std::uint64_t mark = state.mark;
    const bool isFirst = state.syncs == 0;
    if (isFirst || members != known) ++state.syncs;
    BodySync sync{world, state};
    state.mark = world.markChanges();
    const bool bodiesDiffer = isFirst || members.bodies != known.bodies;
    const bool bodiesCameOrWent = sync.follow(mark, bodiesDiffer);
    state.carriedMark = state.mark;
    followTiles(world, state, bodiesDiffer);
    followJoints(world, state, members.joints != known.joints, bodiesCameOrWent, mark);
    followFields(world, state, isFirst || members.fields != known.fields);
    followSoftBodies(world, state, isFirst || members.softBodies != known.softBodies);
    state.members = membersOf(world);
}

}  // namespace plumb
