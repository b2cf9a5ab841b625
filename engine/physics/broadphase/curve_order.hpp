#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/rect.hpp"

namespace plumb::physics {

/// Puts boxes into the order of a Hilbert curve through their centres, so that neighbours in the list are
/// neighbours in the plane. Crowds get a finer curve of their own, so that one box far away spoils nothing.
/// Source: I. Kamel, C. Faloutsos, "On Packing R-trees", CIKM 1993.
class CurveOrder {
public:
    /// @param bounds  by id; finite, or inverted ones in any place
    void sort(std::span<const AABB> bounds, std::span<std::uint32_t> ids);

private:
    using Entry = std::uint64_t;  // place on the curve << 32 | id

    void sortRange(std::span<const AABB> bounds, std::span<Entry> entries, int depth);
    void sortByKey(std::span<Entry> entries, int digitBits);

    std::vector<Entry> entries_;
    std::vector<Entry> spare_;
    std::vector<std::uint32_t> counts_;
};

}  // namespace plumb::physics
