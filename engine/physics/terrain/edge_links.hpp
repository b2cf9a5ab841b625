#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/ids.hpp"
#include "physics/terrain/tile_edges.hpp"

namespace plumb::physics {

/// The successors of an edge at one of its ends.
struct EdgeLink {
    std::uint32_t outline = kNone;  ///< the next edge of the outline
    std::uint32_t ghost = kNone;    ///< the edge that bodies slide on to; kNone: the end is free
};

/// Finds how edges are connected.
///
/// Plain edges form closed outlines. Where solids touch in a single point, the outline bends within the open
/// side: no body fits through there, so each pocket becomes a plain concave corner. If their layers differ,
/// each solid keeps its own corner, as a body may collide with only one of them.
///
/// A one-way edge continues with one-way edges of the same direction. Where it ends at a solid, its ghost is
/// the solid's edge; and where the outline of a solid bends away from it, the one-way edge is the ghost of
/// the solid's edge. So bodies slide over the joint in both directions. An inner edge continues along its own
/// solid.
class EdgeLinks {
public:
    /// @param edges  start and end within `cells`; must outlive the use of this object, unchanged
    void connect(const std::vector<TileEdge>& edges, CellRect cells);

    [[nodiscard]] EdgeLink after(std::uint32_t edge) const { return find(edge, 1); }
    [[nodiscard]] EdgeLink before(std::uint32_t edge) const { return find(edge, 0); }

private:
    /// @param end  0 for what is before the edge, 1 for what is after it
    [[nodiscard]] EdgeLink find(std::uint32_t edge, std::size_t end) const;
    [[nodiscard]] bool hasOneLayer(GridPoint place) const;
    [[nodiscard]] std::size_t bucketOf(GridPoint point) const;
    /// Calls visit(number, edge) for the edges that start (0) or end (1) at a place.
    template <class Visit>
    void forEdgesAt(GridPoint place, std::size_t end, const Visit& visit) const;

    const std::vector<TileEdge>* edges_ = nullptr;
    CellRect cells_;
    std::size_t rowLength_ = 0;  // number of buckets per row
    // Linked lists of the edges by the cell in which they start (0), and by that in which they end (1): the
    // first of each cell, the others by `next`.
    std::vector<std::uint32_t> first_[2];
    std::vector<std::uint32_t> next_[2];
};

}  // namespace plumb::physics
