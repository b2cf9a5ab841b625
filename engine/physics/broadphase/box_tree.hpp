#pragma once

#include <cstdint>
#include <vector>

#include "physics/broadphase/packed_tree.hpp"

namespace plumb::physics {

/// A tree of boxes that are no shapes, numbered 0, 1, 2, … in the order in which they are added. Memory is
/// kept by clear(). The set of boxes that a search finds does not depend on the shape of the tree.
class BoxTree {
public:
    void clear();
    /// @param layers  a search finds the box if its mask has one of them
    void add(const AABB& box, std::uint32_t layers);
    /// Makes the boxes added since the last call visible to searches.
    void settle();
    [[nodiscard]] std::size_t size() const { return bounds_.size(); }

    /// Appends the numbers of the boxes that a box of half size `half` (m) may meet on its straight path from
    /// `from` to `from + way`. Any order; some of them may be off the path. May run on several threads at
    /// once.
    void cast(Vec2 from, Vec2 way, Vec2 half, std::uint32_t mask, std::vector<std::uint32_t>& found) const;

private:
    PackedTree tree_;
    std::vector<AABB> bounds_;
    std::vector<Filter> filters_;
    std::vector<ProxyMotion> motions_;
    std::vector<std::uint32_t> places_;
    std::vector<std::uint32_t> arrivals_;
};

}  // namespace plumb::physics
