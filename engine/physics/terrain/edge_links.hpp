#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/ids.hpp"
#include "physics/terrain/tile_edges.hpp"

namespace plumb::physics {

/// What follows an edge at one of its ends.
struct EdgeLink {
    std::uint32_t outline = kNone;  ///< the edge with which the outline goes on
    std::uint32_t ghost = kNone;    ///< the edge that a body slides on to; kNone: the end is free
};

/// Finds how edges follow each other.
///
/// Plain edges form closed outlines. Where solids touch in a single point, the outline turns within the open
/// side: no body fits through there, so each pocket is a plain inner corner. If their layers differ each
/// solid keeps its own corner, as a body may meet only one.
///
/// A one-way edge goes on with one-way edges of its direction. At a solid that it meets its ghost is that
/// solid's edge, and where a solid's outline bends away from it, it is the ghost of the solid's, so that
/// bodies slide over the joint in both directions. An inner edge goes on along its own solid.
class EdgeLinks {
public:
    /// @param edges  starts and ends lie within `cells`; they stay in place while this is used
    void connect(const std::vector<TileEdge>& edges, CellRect cells);

    [[nodiscard]] EdgeLink after(std::uint32_t edge) const { return find(edge, true); }
    [[nodiscard]] EdgeLink before(std::uint32_t edge) const { return find(edge, false); }

private:
    [[nodiscard]] EdgeLink find(std::uint32_t edge, bool after) const;
    [[nodiscard]] bool hasOneLayer(GridPoint place) const;
    [[nodiscard]] std::size_t bucketOf(GridPoint point) const;

    const std::vector<TileEdge>* edges_ = nullptr;
    CellRect cells_;
    std::size_t rowLength_ = 0;  // of buckets
    // Edges by the cell in which they start, and in which they end: the first of each, then by `next`.
    std::vector<std::uint32_t> firstStart_;
    std::vector<std::uint32_t> nextStart_;
    std::vector<std::uint32_t> firstEnd_;
    std::vector<std::uint32_t> nextEnd_;
};

}  // namespace plumb::physics
