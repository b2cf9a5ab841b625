#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/rect.hpp"

namespace plumb::physics {

/// Sorts boxes along a Hilbert curve through their centres, so that neighbours in the list are neighbours in
/// the plane. Dense cells of the curve get a finer curve of their own, so that a single box far away does not
/// degrade the order of the others.
/// Source: I. Kamel, C. Faloutsos, "On Packing R-trees", CIKM 1993.
class HilbertOrder {
public:
    /// @param bounds  by id; finite, or inverted ones anywhere
    void sort(std::span<const AABB> bounds, std::span<std::uint32_t> ids);

private:
    using Entry = std::uint64_t;  // index on the curve << 32 | id

    void sortRange(std::span<const AABB> bounds, std::span<Entry> entries, int depth);
    void sortByKey(std::span<Entry> entries, int digitBits);

    std::vector<Entry> entries_;
    std::vector<Entry> spare_;
    std::vector<std::uint32_t> counts_;
};

}  // namespace plumb::physics
