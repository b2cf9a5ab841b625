#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace plumb::physics {

struct StepContext;

/// Sums over the positions of bodies along x and y, for mean and variance.
struct PositionSums {
    double sum[2] = {};      ///< m
    double squares[2] = {};  ///< m2

    void clear() { *this = {}; }
};

/// Divides the world into strips with about equal numbers of bodies. Bodies and contacts of a strip are
/// adjacent in the solver's arrays: a thread that processes a part of each array does not write cache lines
/// of other threads. Affects only the memory layout, never the result.
struct Strips {
    static constexpr std::size_t kCount = 32;

    bool areUsed = false;              ///< true with several threads and enough bodies
    int axis = 0;                      ///< axis along which the strips are arranged
    double begin = 0.0;                ///< m: start of the second strip
    double rate = 0.0;                 ///< 1/m: number of strips per length
    std::vector<std::uint8_t> ofBody;  ///< indexed by body: index of its strip
    std::vector<std::uint8_t> ofContact;
    std::vector<PositionSums> sums;  ///< per piece of work
    std::vector<std::uint32_t> unsorted;

    [[nodiscard]] std::size_t count() const { return areUsed ? kCount : 1; }
};

/// Assigns the awake bodies to strips, and sorts the bodies of each group by strip: Workspace::solveOrder.
void sortIntoStrips(StepContext& step);

}  // namespace plumb::physics
