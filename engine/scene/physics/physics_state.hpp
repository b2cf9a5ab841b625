#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/state_archive.hpp"
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

/// Physics settings of a world. A world resource that games
/// may change; a ScenePhysics component overrides it.
struct PhysicsSettings {
    static constexpr Vec2 kGravity{0.0f, 980.0f};

    Vec2 gravity = kGravity;       ///< px/s^2
    float pixelsPerMetre = 64.0f;  ///< px in a metre of the physics
    physics::Settings tolerances;  ///< in metres; gravity and stayEvents are ignored
    bool stayEvents = true;        ///< emit ContactStayed and TriggerStayed in every tick of a contact
    std::uint32_t effectsOff = 0;  ///< bits of physics::Manifest: effects that never run

    void addTo(Hasher& hasher) const {
        hasher.add(gravity.x), hasher.add(gravity.y), hasher.add(pixelsPerMetre);
        hasher.add(std::uint64_t{effectsOff});
    }
};

/// State of the body of an entity at the last synchronization with its components.
struct BodyLink {
    EntityId entity;
    Pose pose;                     ///< px, rad: world pose at the last synchronization
    Rot rotation;                  ///< rotation of the body at the last synchronization
    Vec2 velocity;                 ///< px/s: velocity at the last synchronization
    float angularVelocity = 0.0f;  ///< rad/s, at the last synchronization
    std::uint64_t outlines = 0;    ///< outlinesOf() that its shapes were created from
    bool hasParent = false;        ///< the entity has a parent and moves with it
    bool driven = false;           ///< kinematic: moved by its Transform in this tick, not by its velocity
};

/// An entity for which a body must be created.
struct BodyArrival {
    std::uint64_t order = 0;  ///< bodies are created in ascending order
    EntityId entity;

    friend bool operator==(const BodyArrival&, const BodyArrival&) = default;
    friend bool operator<(const BodyArrival& a, const BodyArrival& b) { return a.order < b.order; }
};

/// The terrain bodies of a tile layer.
struct TileTerrain {
    EntityId entity;
    // outlines and cells are shared with snapshots, so they are copied before a change.
    std::shared_ptr<physics::TerrainOutlines> outlines;
    std::shared_ptr<TileGrid> cells;  ///< cells at the last synchronization
    physics::TerrainBody body;
    std::uint64_t made = 0;      ///< hash of everything except cells and tileset that it was created from
    std::uint32_t revision = 0;  ///< of the tileset that it was created from, in this program
    std::uint32_t version = 0;   ///< version of the grid at the last synchronization
    std::uint64_t seen = 0;      ///< value of PhysicsState::syncs when its entity was last found
};

/// Connects a joint component with its joint.
struct JointLinkage {
    EntityId entity;
    EntityId other;
    std::uint8_t kind = 0;  ///< index of the joint type in joint_sync.cpp
    bool broken = false;
    physics::JointId joint;
    float startAngle = 0.0f;   ///< rad, angle between the bodies when the joint was created
    float startLength = 0.0f;  ///< m, distance of the anchors when the joint was created
    std::uint64_t made = 0;    ///< hash of the values it was created from
    std::uint64_t seen = 0;    ///< PhysicsState::syncs of the last visit
};

/// Connects a field component with its field.
struct FieldLinkage {
    EntityId entity;
    std::uint8_t kind = 0;  ///< index of the field type in field_sync.cpp
    physics::FieldId field;
    std::uint64_t made = 0;  ///< hash of the values it was created from
    std::uint64_t seen = 0;  ///< PhysicsState::syncs of the last visit
};

/// Connects a CharacterController component with its controller in the physics.
struct CharacterLinkage {
    EntityId entity;
    Vec2 middle;             ///< px, center at the last synchronization
    std::uint64_t made = 0;  ///< hash of the values it was created from
    physics::CharacterController controller;
};

/// Connects a rope, cloth or jelly component with its soft body.
struct SoftLinkage {
    EntityId entity;
    std::uint8_t kind = 0;  ///< index of the soft body type in soft_sync.cpp
    physics::SoftBodyId body;
    std::uint64_t made = 0;  ///< hash of the values it was created from
    std::uint64_t seen = 0;  ///< PhysicsState::syncs of the last visit
};

/// Counters that are incremented whenever an entity gains
/// or loses a component of a group (World::memberships).
struct PhysicsMembers {
    std::uint64_t bodies = 0;
    std::uint64_t joints = 0;
    std::uint64_t fields = 0;
    std::uint64_t softBodies = 0;

    friend bool operator==(const PhysicsMembers&, const PhysicsMembers&) = default;
};

/// The physics world of a world and its links to entities. A world resource, included in snapshots and hash.
struct PhysicsState {
    physics::World world;
    PixelScale scale;
    std::vector<BodyLink> links;         ///< indexed by body; entity is empty for bodies without an entity
    std::vector<std::uint32_t> bodyOf;   ///< indexed by EntityId::index: body index + 1, 0 for none
    std::vector<std::uint32_t> carried;  ///< indices of bodies whose entities have a parent, sorted
    std::vector<std::uint64_t> below;    ///< indexed by entity: `follows` when its descendants were marked
    std::uint64_t follows = 0;           ///< number of syncs
    WorldPoses poses;                    ///< within a sync or a publication
    std::vector<std::uint8_t> stale;     ///< indexed by body, during a sync: bits of the changed components
    std::vector<std::uint32_t> driven;   ///< indices of kinematic bodies, sorted
    std::vector<std::uint32_t> stepped;  ///< indices of bodies that were awake before the step
    std::vector<std::uint8_t> grounded;  ///< indexed by body: 1 if it rested on a body in the last step
    std::vector<TileTerrain> terrains;
    std::vector<JointLinkage> joints;
    std::vector<FieldLinkage> fields;
    std::vector<CharacterLinkage> characters;
    std::vector<SoftLinkage> softBodies;
    std::vector<physics::CastHit> hits;   ///< results of the current cast; a member to reuse its memory
    std::vector<physics::ShapeId> found;  ///< results of the current overlap query; reused likewise
    physics::BodyId ground;               ///< static body for joints that connect to the world
    std::vector<EntityId> unplaced;       ///< entities whose body could not be created
    std::vector<BodyArrival> arrived;     ///< during a sync: bodies to create
    std::vector<std::uint32_t> departed;  ///< during a sync: indices of bodies to destroy
    std::uint64_t syncs = 0;              ///< number of syncs in which component memberships had changed
    std::uint64_t visits = 0;             ///< number of entities compared because of membership changes
    PhysicsMembers members;               ///< counters at the last sync
    std::uint64_t mark = 0;               ///< change mark: writes before it are synchronized
    std::uint64_t carriedMark = 0;        ///< change mark before the last step, for bodies with a parent

    void addTo(Hasher& hasher) const { physics::addTo(hasher, world); }
    /// In a saved game of another version of the physics it becomes empty: bodies are made anew from the
    /// components.
    void archive(StateArchive& archive);
};

}  // namespace plumb
