#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "math/tile_grid.hpp"
#include "physics/character/character_controller.hpp"
#include "physics/queries/query.hpp"
#include "physics/simulation.hpp"
#include "physics/terrain/terrain_body.hpp"
#include "reflect/entity_id.hpp"
#include "reflect/field_types.hpp"
#include "scene/physics/physics_units.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

/// How the physics of a world is set up. A resource; games change it. A ScenePhysics component goes before
/// it.
struct PhysicsSettings {
    static constexpr Vec2 kGravity{0.0f, 980.0f};

    Vec2 gravity = kGravity;       ///< px/s^2
    float pixelsPerMetre = 64.0f;  ///< px
    physics::Settings tolerances;  ///< all but gravity and stayEvents; metres
    bool stayEvents = true;        ///< ContactStayed and TriggerStayed in each tick that a contact goes on
    std::uint32_t effectsOff = 0;  ///< bits of physics::Manifest that never run

    void addTo(Hasher& hasher) const {
        hasher.add(gravity.x), hasher.add(gravity.y), hasher.add(pixelsPerMetre);
        hasher.add(std::uint64_t{effectsOff});
    }
};

/// What the bridge knows about the body of an entity.
struct BodyLink {
    EntityId entity;
    Pose pose;                     ///< px, rad, in the world: where both sides last agreed that it is
    Rot rotation;                  ///< of the body, the same
    Vec2 velocity;                 ///< px/s: the same for its velocity
    float angularVelocity = 0.0f;  ///< rad/s
    std::uint64_t outlines = 0;    ///< what its shapes were made from
    bool hasParent = false;        ///< moves when another one does
    bool driven = false;           ///< its Transform moves it in this tick, not its velocity
};

/// An entity that needs a body.
struct BodyArrival {
    std::uint64_t order = 0;  ///< arrivals get their bodies in this order
    EntityId entity;

    friend bool operator==(const BodyArrival&, const BodyArrival&) = default;
    friend bool operator<(const BodyArrival& a, const BodyArrival& b) { return a.order < b.order; }
};

/// The bodies of a tile layer.
struct TileTerrain {
    EntityId entity;
    // Both are shared with snapshots, so copied before a change.
    std::shared_ptr<physics::TerrainOutlines> outlines;
    std::shared_ptr<TileGrid> cells;  ///< as they were looked at
    physics::TerrainBody body;
    std::uint64_t made = 0;     ///< what all of it was made from, but for the cells
    std::uint32_t version = 0;  ///< of the grid
    std::uint64_t seen = 0;
};

struct JointLinkage {
    EntityId entity;
    EntityId other;
    std::uint8_t kind = 0;  ///< row of the table of joints
    bool broken = false;
    physics::JointId joint;
    float startAngle = 0.0f;   ///< rad, between the bodies when it was made
    float startLength = 0.0f;  ///< m, the same from end to end
    std::uint64_t made = 0;    ///< what it was made from
    std::uint64_t seen = 0;
};

struct FieldLinkage {
    EntityId entity;
    std::uint8_t kind = 0;  ///< row of the table of fields
    physics::FieldId field;
    std::uint64_t made = 0;
    std::uint64_t seen = 0;
};

/// A character that its controller moves.
struct CharacterLinkage {
    EntityId entity;
    Vec2 middle;             ///< px: where both sides last agreed that it is
    std::uint64_t made = 0;  ///< what it was made from
    physics::CharacterController controller;
};

struct SoftLinkage {
    EntityId entity;
    std::uint8_t kind = 0;  ///< row of the table of soft bodies
    physics::SoftBodyId body;
    std::uint64_t made = 0;
    std::uint64_t seen = 0;
};

/// Counters that grow whenever an entity gets or loses a component of a group (World::memberships).
struct PhysicsMembers {
    std::uint64_t bodies = 0;
    std::uint64_t joints = 0;
    std::uint64_t fields = 0;
    std::uint64_t softBodies = 0;

    friend bool operator==(const PhysicsMembers&, const PhysicsMembers&) = default;
};

/// The simulated bodies of a world and whose they are. A resource: snapshots and the hash include it.
struct PhysicsState {
    physics::World world;
    PixelScale scale;
    std::vector<BodyLink> links;         ///< by body index; empty for bodies that belong to no entity
    std::vector<std::uint32_t> bodyOf;   ///< by entity index: body index + 1, 0 for none
    std::vector<std::uint32_t> carried;  ///< bodies of entities that have a parent
    std::vector<std::uint8_t> stale;     ///< by body: of the sync in hand, what differs from its entity
    std::vector<std::uint32_t> driven;   ///< kinematic bodies
    std::vector<std::uint32_t> stepped;  ///< bodies that were awake before the step
    std::vector<std::uint8_t> grounded;  ///< by body, in the last step
    std::vector<TileTerrain> terrains;
    std::vector<JointLinkage> joints;
    std::vector<FieldLinkage> fields;
    std::vector<CharacterLinkage> characters;
    std::vector<SoftLinkage> softBodies;
    std::vector<physics::CastHit> hits;  ///< of the query in hand
    std::vector<physics::ShapeId> found;
    physics::BodyId ground;               ///< what joints with one entity are tied to
    std::vector<EntityId> refused;        ///< whose numbers were bad, so that each is reported once
    std::vector<EntityId> unplaced;       ///< of these, those without a body
    std::vector<BodyArrival> arrived;     ///< of the sync in hand
    std::vector<std::uint32_t> departed;  ///< of the sync in hand: bodies whose entities need none any more
    std::uint64_t syncs = 0;              ///< those for which an entity had got or lost a component
    std::uint64_t visits = 0;       ///< entities compared because components came or went, since the start
    PhysicsMembers members;         ///< at the last sync
    std::uint64_t mark = 0;         ///< what was written before it is known
    std::uint64_t carriedMark = 0;  ///< the same for bodies with a parent: includes what the step moved

    void addTo(Hasher& hasher) const { physics::addTo(hasher, world); }
};

}  // namespace plumb
