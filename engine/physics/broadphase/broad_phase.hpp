#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "math/rect.hpp"

namespace plumb::physics {

/// Decides which shapes collide. Shapes of the same body never collide. Those of the same group always
/// do if the group is above 0, never if it is below 0. Others do if each is on a layer of the other's mask.
struct Filter {
    std::uint32_t layers = 1;          ///< bits: the layers that the shape is on
    std::uint32_t mask = 0xffffffffu;  ///< bits: the layers that the shape collides with
    std::int32_t group = 0;            ///< 0: no group
    std::uint32_t body = 0;
};

/// True if shapes with these filters collide when they touch.
constexpr bool mayCollide(const Filter& a, const Filter& b) {
    if (a.body == b.body) return false;
    if (a.group == b.group && a.group != 0) return a.group > 0;
    return (a.layers & b.mask) != 0 && (b.layers & a.mask) != 0;
}

enum class ProxyMotion : std::uint8_t {
    Gone,       ///< the shape was destroyed
    Static,     ///< never moves
    Asleep,     ///< dynamic, at rest
    Kinematic,  ///< moves, but not by forces
    Awake       ///< dynamic, may move
};

/// The proxies of all shapes: views of three arrays indexed by shape. Bounds are already enlarged by a
/// margin; the bounds of a shape change only when the shape leaves them.
struct Proxies {
    std::span<const AABB> bounds;
    std::span<const Filter> filters;
    std::span<const ProxyMotion> motions;
};

enum class Among : std::uint8_t { All, Static };  ///< the proxies that cast() searches

/// Two shapes whose bounds overlap. The lower index is in the high half, so that sorting orders keys by it.
using PairKey = std::uint64_t;
constexpr PairKey pairKey(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t low = a < b ? a : b;  // without a branch, as it would be unpredictable
    return PairKey{low} << 32 | (a ^ b ^ low);
}

/// Finds pairs of proxies with overlapping bounds. A broad phase holds no state of its own: its content
/// follows from the proxies, and any kind, with any history, returns the same sets. Touching bounds overlap.
class BroadPhase {
public:
    virtual ~BroadPhase() = default;

    /// Discards everything and adds all proxies that are not Gone.
    virtual void rebuild(const Proxies& proxies) = 0;
    /// Updates proxies that were added or removed, or whose bounds, filter or motion changed.
    /// @param changed  indices, each once
    virtual void update(const Proxies& proxies, std::span<const std::uint32_t> changed) = 0;
    /// Sorts `moved` so that proxies that can be searched together are adjacent. Optional, but findPairs() is
    /// several times faster in this order; parts for threads should be contiguous ranges of it.
    virtual void arrange(std::span<std::uint32_t> moved) = 0;
    /// Appends each pair of a proxy in `moved` with any other proxy if their bounds overlap, their filters
    /// match, at least one is dynamic and at least one moves. So a kinematic proxy pairs with sleeping ones,
    /// which it has to wake, but not with static or kinematic ones. A pair of two moved proxies is reported
    /// once. The order is arbitrary. Different parts of `moved` may be searched on several threads at once.
    /// @param isMoved  indexed by proxy: nonzero for all that are in `moved` of any thread
    virtual void findPairs(std::span<const std::uint32_t> moved, std::span<const std::uint8_t> isMoved,
                           std::vector<PairKey>& pairs) const = 0;
    /// Appends all proxies on a layer in `mask` whose bounds overlap the box, in any order.
    virtual void query(const AABB& box, std::uint32_t mask, std::vector<std::uint32_t>& found) const = 0;
    /// Appends all proxies whose bounds, enlarged by `half` on each side, intersect the line from `from` to
    /// `from + displacement`. The order is arbitrary; the result may contain proxies that the line misses.
    virtual void cast(Vec2 from, Vec2 displacement, Vec2 half, std::uint32_t mask,
                      std::vector<std::uint32_t>& found, Among among) const = 0;
    /// Visits the nodes, cells or segments that are in use, for debug drawing.
    virtual void visitRegions(const std::function<void(const AABB&)>& visit) const = 0;
};

/// The broad phases. Each is the fastest for some kind of scene (docs/performance.md).
enum class BroadPhaseKind : std::uint8_t { Tree, Grid, SweepAndPrune, Quadtree, Count };

std::unique_ptr<BroadPhase> makeBroadPhase(BroadPhaseKind kind);
std::string_view nameOf(BroadPhaseKind kind);

}  // namespace plumb::physics
