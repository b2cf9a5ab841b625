#pragma once

#include <vector>

#include "core/result.hpp"
#include "physics/terrain/terrain_outlines.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

/// Where a terrain is and how its shapes behave.
struct TerrainDefinition {
    Place position;             ///< m, of its top-left corner
    Vec2 cellSize{1.0f, 1.0f};  ///< m
    bool reportsContacts = true;
    std::uint64_t user = 0;  ///< the owner's number of its bodies and shapes
};

/// A tile terrain in a world: one static body for each chunk, at its top-left corner, so that a chunk is as
/// exact far from the terrain's corner as near it. All of it is one surface: events tell who begins to touch
/// the terrain and who ends, whatever seams of cells, materials or chunks lie between.
///
/// Plain to copy: with its world it is a snapshot.
class TerrainBody {
public:
    TerrainBody() = default;
    /// Makes the bodies; their shapes come with update().
    /// @error a number that is not finite, a cell size that is not positive or absurd
    static Result<TerrainBody> create(World& world, const TerrainOutlines& terrain,
                                      const TerrainDefinition& definition);

    /// Makes the shapes of some chunks anew, and wakes who rests on them.
    /// @param changed  what TerrainOutlines::update() returned
    /// @pre   the terrain has as many chunks as at create()
    Result<Done> update(World& world, const TerrainOutlines& terrain, std::span<const std::uint32_t> changed);
    /// Removes all bodies.
    void destroy(World& world);

    /// By chunk.
    [[nodiscard]] const std::vector<BodyId>& bodies() const { return bodies_; }
    [[nodiscard]] bool has(const World& world, BodyId body) const;

private:
    Result<Done> makeChunk(World& world, const TerrainOutlines& terrain, std::uint32_t chunk);

    TerrainDefinition definition_;
    std::vector<BodyId> bodies_;
    std::uint32_t surface_ = 0;
    std::vector<Geometry> geometries_;
    std::vector<ShapeDefinition> definitions_;
};

}  // namespace plumb::physics
