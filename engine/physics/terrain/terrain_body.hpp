#pragma once

#include "physics/terrain/terrain_outlines.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

struct TerrainDefinition {
    WorldPosition position;       ///< m: top-left corner of the terrain
    Vec2 cellSize{1.0f, 1.0f};    ///< m: width and height of a cell
    bool reportsContacts = true;  ///< true: contacts with the terrain produce events
    std::uint64_t user = 0;       ///< user data, stored in all bodies and shapes of the terrain
};

/// A tile terrain in a world: one static body per chunk, located at the chunk's top-left corner, so that all
/// chunks are equally accurate, however far from the terrain's corner. The whole terrain is one surface:
/// events report when a body begins and ends to touch the terrain, whatever seams of cells, materials or
/// chunks lie between.
///
/// A copy of a TerrainBody and a copy of its World together are a snapshot.
class TerrainBody {
public:
    TerrainBody() = default;
    /// Creates the bodies; update() creates their shapes.
    /// @error a number that is not finite, a cell size that is not positive or out of range
    static Result<TerrainBody> create(World& world, const TerrainOutlines& terrain,
                                      const TerrainDefinition& definition);

    /// Replaces the shapes of the changed chunks, and wakes the bodies that rest on these shapes.
    /// @param changed  the result of TerrainOutlines::update()
    /// @pre   the terrain has as many chunks as in create()
    Result<Done> update(World& world, const TerrainOutlines& terrain, std::span<const std::uint32_t> changed);
    void destroy(World& world);

    /// Writes or reads its state. @tparam Archive  as StateArchive
    template <class Archive>
    void archive(Archive& archive) {
        archive.value(definition_);
        archive.list(bodies_);
        archive.value(surface_);
    }

private:
    Result<Done> makeChunk(World& world, const TerrainOutlines& terrain, std::uint32_t chunk);

    TerrainDefinition definition_;
    std::vector<BodyId> bodies_;                // one per chunk
    std::uint32_t surface_ = 0;                 // ShapeDefinition::surface of all its shapes
    std::vector<Geometry> geometries_;          // scratch memory of makeChunk()
    std::vector<ShapeDefinition> definitions_;  // scratch memory of makeChunk()
};

}  // namespace plumb::physics
