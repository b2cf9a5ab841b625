#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/rect.hpp"

namespace plumb::physics {

/// Sorts keys by their upper half, digit by digit; stable. Reuses its memory in the next sort.
class RadixSort {
public:
    /// @param digits  number of digits of the upper half to sort by, from the lowest on; even
    /// @param bits    bits per digit
    void sort(std::span<std::uint64_t> keys, int digits, int bits);

private:
    std::vector<std::uint64_t> spare_;
    std::vector<std::uint32_t> counts_;
};

/// Sorts boxes along a Hilbert curve through their centres, so that neighbours in the list are neighbours in
/// the plane. Dense cells of the curve get a finer curve of their own, so that a single box far away does not
/// degrade the order of the others.
/// Source: I. Kamel, C. Faloutsos, "On Packing R-trees", CIKM 1993.
class HilbertOrder {
public:
    /// @param bounds  indexed by id; each is finite, or inverted (min above max) with any values
    void sort(std::span<const AABB> bounds, std::span<std::uint32_t> ids);

private:
    using Entry = std::uint64_t;  // index on the curve << 32 | id

    void sortRange(std::span<const AABB> bounds, std::span<Entry> entries, int depth);

    std::vector<Entry> entries_;
    RadixSort sorter_;
};

}  // namespace plumb::physics
