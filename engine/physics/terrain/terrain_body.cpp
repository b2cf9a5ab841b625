#include "physics/terrain/terrain_body.hpp"

#include "physics/model/bodies.hpp"
#include "physics/model/checks.hpp"
#include "physics/model/shapes.hpp"

namespace plumb::physics {

namespace {

/// Bit that distinguishes the surface numbers of terrains from those of chains.
constexpr std::uint32_t kTerrainBit = kOwnSurfaces << 1;

WorldPosition placeOf(const TerrainOutlines& terrain, const TerrainDefinition& definition,
                      std::uint32_t chunk) {
    const CellRect cells = terrain.cellsOf(chunk);
    return {definition.position.x + cells.x0 * static_cast<double>(definition.cellSize.x),
            definition.position.y + cells.y0 * static_cast<double>(definition.cellSize.y)};
}

Vec2 toVec2(GridPoint point) { return {static_cast<float>(point.x), static_cast<float>(point.y)}; }

ShapeDefinition definitionOf(const TilePalette& palette, EdgeKind kind, const TerrainDefinition& terrain) {
    const TileMaterial& material = palette.material(kind.material);
    const TileLayers& layers = palette.layers(kind.layers);
    ShapeDefinition shape{.density = 0.0f,
                          .friction = material.friction,
                          .bounciness = material.bounciness,
                          .surfaceSpeed = material.surfaceSpeed,
                          .layers = layers.layers,
                          .mask = layers.mask,
                          .oneWay = kind.oneWay != OneWay::No,
                          .oneWayDirection = toVec2(directionOf(kind.oneWay)),
                          .reportsContacts = terrain.reportsContacts,
                          .user = terrain.user};
    if (kind.isInner()) {
        const TileLayers& front = palette.layers(static_cast<std::uint8_t>(kind.behind - 1));
        shape.frontLayers = front.layers;
        shape.frontMask = front.mask;
    }
    return shape;
}

}  // namespace

Result<TerrainBody> TerrainBody::create(World& world, const TerrainOutlines& terrain,
                                        const TerrainDefinition& definition) {
    const auto checked =
        firstOf(checkPosition("TerrainDefinition.position", definition.position),
                checkNumber("TerrainDefinition.cellSize.x", definition.cellSize.x, kSmallest, kLargest),
                checkNumber("TerrainDefinition.cellSize.y", definition.cellSize.y, kSmallest, kLargest));
    if (!checked) return checked.error();
    TerrainBody body;
    body.definition_ = definition;
    for (std::uint32_t chunk = 0; chunk < terrain.chunks().size(); ++chunk) {
        const Result<BodyId> made = createBody(world, {.kind = BodyKind::Static,
                                                       .position = placeOf(terrain, definition, chunk),
                                                       .user = definition.user});
        if (!made) {
            body.destroy(world);
            return made.error();
        }
        body.bodies_.push_back(*made);
    }
    if (!body.bodies_.empty()) body.surface_ = kTerrainBit | body.bodies_.front().index;
    return body;
}

Result<Done> TerrainBody::makeChunk(World& world, const TerrainOutlines& terrain, std::uint32_t chunk) {
    const CellRect cells = terrain.cellsOf(chunk);
    const GridPoint origin = cornerOfCell(cells.x0, cells.y0);
    geometries_.clear();
    definitions_.clear();
    for (const TerrainSegment& segment : terrain.chunks()[chunk]) {
        geometries_.push_back(geometryOf(segment, definition_.cellSize, origin));
        definitions_.push_back(definitionOf(terrain.mask().palette, segment.kind, definition_));
        definitions_.back().surface = surface_;
    }
    destroyShapes(world, bodies_[chunk]);
    return createShapes(world, bodies_[chunk], geometries_, definitions_);
}

Result<Done> TerrainBody::update(World& world, const TerrainOutlines& terrain,
                                 std::span<const std::uint32_t> changed) {
    for (const std::uint32_t chunk : changed) {
        if (chunk >= bodies_.size()) continue;
        if (const auto made = makeChunk(world, terrain, chunk); !made) return made;
    }
    return Done{};
}

void TerrainBody::destroy(World& world) {
    for (const BodyId body : bodies_) destroyBody(world, body);
    bodies_.clear();
}

}  // namespace plumb::physics
