#pragma once

#include <cstdint>
#include <vector>

#include "core/text_store.hpp"
#include "box_physics/simulation.hpp"
#include "reflect/entity_id.hpp"
#include "reflect/field_types.hpp"

namespace plumb {

/// How the physics of a world is set up. A resource; scenes and games change it.
struct PhysicsSettings {
    static constexpr Vec2 kGravity{0.0f, 980.0f};

    Vec2 gravity = kGravity;  ///< px/s^2
    /// Bits of box_physics::Effect; 0 takes what the systems, or else the components, call for.
    unsigned effects = 0;

    void addTo(Hasher& hasher) const {
        hasher.add(gravity.x), hasher.add(gravity.y), hasher.add(std::uint64_t{effects});
    }
};

/// What the bridge knows about the body of an entity.
struct BodyLink {
    EntityId entity;
    Vec2 place;              ///< px: where both sides last agreed the entity is
    Vec2 velocity;           ///< px/s: the same for its velocity
    std::uint64_t seen = 0;  ///< the last sync that found its components
    TilesId tiles;           ///< of a tile collider: what its field was made from
    std::uint32_t tilesVersion = 0;
    TilesetId tileset;
    Vec2 tileSize;               ///< px
    bool drivenByOwner = false;  ///< its Transform moves it, not its velocity
};

/// The simulated bodies of a world and whose they are. A resource: snapshots and the hash include it.
struct PhysicsState {
    box_physics::World world;
    std::vector<BodyLink> links;        ///< by body index
    std::vector<std::uint32_t> bodyOf;  ///< by entity index: body index + 1, 0 for none
    std::vector<EntityId> refused;      ///< whose numbers were bad, so that each is told once
    std::uint64_t syncs = 0;

    void addTo(Hasher& hasher) const { box_physics::addTo(hasher, world); }
};

}  // namespace plumb
