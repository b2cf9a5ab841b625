#include "physics/solver/strips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

constexpr int kStripGrain = 512;
constexpr std::size_t kWorthStrips = 256;  // bodies: the data of fewer fits into the L1 cache

std::uint8_t stripOf(const Strips& strips, double at) {
    const double place = strips.rate * (at - strips.begin) + 1.0;
    constexpr double kLast = Strips::kCount - 1;
    return static_cast<std::uint8_t>(place > 0.0 ? std::min(place, kLast) : 0.0);
}

/// Computes the strips of the next step: from 1.7 standard deviations below the mean position to 1.7 above.
void place(Strips& strips, const std::vector<PositionSums>& pieces, double count) {
    double mean[2] = {}, deviation[2] = {};
    for (int axis = 0; axis < 2; ++axis) {
        double sum = 0.0, squares = 0.0;
        for (const PositionSums& piece : pieces) sum += piece.sum[axis], squares += piece.squares[axis];
        mean[axis] = sum / count;
        deviation[axis] = std::sqrt(std::max(squares / count - mean[axis] * mean[axis], 1e-12));
    }
    strips.axis = deviation[0] > deviation[1] ? 0 : 1;
    const double half = 1.7 * deviation[strips.axis];
    strips.rate = static_cast<double>(Strips::kCount - 2) / (2.0 * half);
    strips.begin = mean[strips.axis] - half;
}

/// Assigns each body to a strip, with the strip boundaries of the last step.
void assign(StepContext& step) {
    const World& world = step.world;
    Strips& strips = step.work.strips;
    strips.ofBody.resize(world.bodies.size());
    const auto take = [&](std::size_t begin, std::size_t end, PositionSums& sums) {
        PositionSums own;
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t body = world.awake[i];
            const WorldPosition& centre = world.bodies.pose[body].centre;
            const double at[] = {double{centre.x}, double{centre.y}};
            strips.ofBody[body] = stripOf(strips, at[strips.axis]);
            for (int axis = 0; axis < 2; ++axis) {
                own.sum[axis] += at[axis];
                own.squares[axis] += at[axis] * at[axis];
            }
        }
        sums = own;
    };
    forPieces(step.pool, world.awake.size(), kStripGrain, strips.sums, take);
    place(strips, strips.sums, static_cast<double>(world.awake.size()));
}

/// Counting sort of a group's bodies.
void sort(const Strips& strips, const std::uint32_t* bodies, std::size_t count, std::uint32_t* sorted) {
    std::array<std::uint32_t, Strips::kCount> cursors{};
    for (std::size_t i = 0; i < count; ++i) ++cursors[strips.ofBody[bodies[i]]];
    std::uint32_t next = 0;
    for (std::uint32_t& cursor : cursors) next += std::exchange(cursor, next);
    for (std::size_t i = 0; i < count; ++i) sorted[cursors[strips.ofBody[bodies[i]]]++] = bodies[i];
}

}  // namespace

void sortIntoStrips(StepContext& step) {
    const std::vector<std::uint32_t>& awake = step.world.awake;
    Workspace& work = step.work;
    work.strips.areUsed = step.pool != nullptr && awake.size() >= kWorthStrips;
    if (!work.strips.areUsed) return;
    assign(step);
    std::vector<std::uint32_t>& unsorted = work.strips.unsorted;
    unsorted = work.solveOrder.empty() ? awake : work.solveOrder;
    work.solveOrder.resize(awake.size());
    std::size_t first = 0;
    for (const SolveGroup& group : work.groups) {
        const auto count = static_cast<std::size_t>(group.bodies);
        sort(work.strips, unsorted.data() + first, count, work.solveOrder.data() + first);
        first += count;
    }
}

}  // namespace plumb::physics
