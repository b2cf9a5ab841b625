#pragma once

#include <cstdint>
#include <vector>

#include "physics/geometry.hpp"
#include "physics/terrain/edge_links.hpp"

namespace plumb::physics {

/// A straight part of an outline, all of one kind, as long as it is straight within its chunk. It stops what
/// comes from the side of its normal, see normalOfChain(). The ghosts are the far ends of the edges before
/// and after, also where the kind changes; beyond the chunk, the far end of the edge in the next cell. At a
/// free end they go straight on.
struct TerrainSegment {
    GridPoint a;
    GridPoint b;
    GridPoint before;
    GridPoint after;
    EdgeKind kind;

    friend bool operator==(const TerrainSegment&, const TerrainSegment&) = default;
};

/// Segments of one kind, each beginning where the one before ends.
struct TerrainChain {
    std::uint32_t first = 0;  ///< in the chunk's segments
    std::uint32_t count = 0;
    bool closed = false;  ///< the last ends where the first begins

    friend bool operator==(const TerrainChain&, const TerrainChain&) = default;
};

/// The edges of a chunk, merged: the same for the same cells, whatever was there before.
struct TerrainOutline {
    std::vector<TerrainSegment> segments;  ///< in the order of their chains
    std::vector<TerrainChain> chains;

    friend bool operator==(const TerrainOutline&, const TerrainOutline&) = default;
};

/// @param cellSize  m
/// @param origin    of the body's frame
Geometry geometryOf(const TerrainSegment& segment, Vec2 cellSize, GridPoint origin = {});

/// Makes outlines of chunks, and keeps its memory from one to the next.
/// One thread at a time.
class OutlineBuilder {
public:
    /// The outline of the cells of `rect`. It depends on these and on the ring of cells around them, nothing
    /// else.
    void build(const TileMask& mask, CellRect rect, TerrainOutline& outline);

private:
    struct Place {
        std::uint32_t before = kNone;  ///< ghosts
        std::uint32_t after = kNone;
        std::uint32_t outlineBefore = kNone;
        std::uint32_t outlineAfter = kNone;
        std::uint32_t segment = kNone;
    };

    void findPlaces();
    [[nodiscard]] bool joinsNext(std::uint32_t edge) const;
    [[nodiscard]] bool isStraightAfter(std::uint32_t edge) const;
    void walk(std::uint32_t start, TerrainOutline& outline);
    void setGhosts(TerrainOutline& outline) const;

    CellWindow window_;
    EdgeLinks links_;
    std::vector<TileEdge> edges_;  // the chunk's own, then those around it that touch its border
    std::uint32_t own_ = 0;
    std::vector<Place> places_;             // of the own edges
    std::vector<std::uint32_t> firstEdge_;  // by segment
    std::vector<std::uint32_t> lastEdge_;
};

}  // namespace plumb::physics
