#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "math/rect.hpp"

namespace plumb::physics {

/// Whom a shape meets. Shapes of one body never meet; of one group always (above 0) or never (below 0);
/// everybody else when each is on a layer that the other's mask has.
struct Filter {
    std::uint32_t layers = 1;
    std::uint32_t mask = 0xffffffffu;
    std::int32_t group = 0;
    std::uint32_t body = 0;
};

constexpr bool meet(const Filter& a, const Filter& b) {
    if (a.body == b.body) return false;
    if (a.group == b.group && a.group != 0) return a.group > 0;
    return (a.layers & b.mask) != 0 && (b.layers & a.mask) != 0;
}

/// What a proxy does.
enum class ProxyMotion : std::uint8_t {
    Gone,       ///< a free place
    Static,     ///< never moves
    Asleep,     ///< movable, rests
    Kinematic,  ///< moves, cannot be pushed
    Awake       ///< movable, may move
};

/// Whether two proxies can make a pair: one of them can be pushed, and one of them moves. So a kinematic
/// proxy pairs with sleepers as well, which it has to wake, but not with what nothing pushes.
constexpr bool canPair(ProxyMotion a, ProxyMotion b) {
    if (a == ProxyMotion::Awake || b == ProxyMotion::Awake) return true;
    return (a == ProxyMotion::Kinematic && b == ProxyMotion::Asleep) ||
           (a == ProxyMotion::Asleep && b == ProxyMotion::Kinematic);
}

/// The shapes as a broad phase sees them: three arrays indexed by shape. A view; nothing is owned.
/// Bounds are already fattened by a margin; they change only when a shape leaves them.
struct Proxies {
    std::span<const AABB> bounds;
    std::span<const Filter> filters;
    std::span<const ProxyMotion> motions;
};

/// Who is looked for.
enum class Among : std::uint8_t { All, Static };

/// Two shapes whose bounds overlap: the lower index in the high half, so that sorting sorts by it.
using PairKey = std::uint64_t;
constexpr PairKey pairKey(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t low = a < b ? a : b;  // nobody can guess which: no branch
    return PairKey{low} << 32 | (a ^ b ^ low);
}

/// Finds who is near whom. What it keeps follows from the proxies, so it is no state: any kind of broad
/// phase, in any condition, gives the same sets. Bounds that only touch count as overlapping.
class BroadPhase {
public:
    virtual ~BroadPhase() = default;

    /// Forgets everything and takes all proxies that are not Gone.
    virtual void rebuild(const Proxies& proxies) = 0;
    /// Takes note of proxies that came, went, or whose bounds, filter or motion changed since the last call.
    /// @param changed  indices, each once
    virtual void update(const Proxies& proxies, std::span<const std::uint32_t> changed) = 0;
    /// Puts side by side who is searched for together. Not needed for right results, but findPairs() is
    /// several times faster with `moved` in this order, and its parts for threads best are pieces of it.
    virtual void arrange(std::span<std::uint32_t> moved) = 0;
    /// Appends each pair of a proxy of `moved` with any other whose bounds overlap, whose filters meet, and
    /// of which the motions can pair. A pair of two moved ones is given once. Any order. May run on several threads
    /// at once for different parts of `moved`.
    /// @param isMoved  by proxy: nonzero for all that are in `moved` of any thread
    virtual void findPairs(const Proxies& proxies, std::span<const std::uint32_t> moved,
                           std::span<const std::uint8_t> isMoved, std::vector<PairKey>& pairs) const = 0;
    /// Appends all proxies whose bounds overlap the box and whose layers are in `mask`. Any order.
    virtual void query(const Proxies& proxies, const AABB& box, std::uint32_t mask,
                       std::vector<std::uint32_t>& found) const = 0;
    /// Appends all proxies whose bounds, grown by `half` on each side, meet the line from `from` along `way`.
    /// Any order; those far off the line may be among them.
    virtual void cast(const Proxies& proxies, Vec2 from, Vec2 way, Vec2 half, std::uint32_t mask,
                      std::vector<std::uint32_t>& found, Among among) const = 0;
};

/// Which broad phase; each has a case that it wins (docs/performance.md).
enum class BroadPhaseKind : std::uint8_t { Tree, Grid, SweepAndPrune, Quadtree, Count };

std::unique_ptr<BroadPhase> makeBroadPhase(BroadPhaseKind kind);
std::string_view nameOf(BroadPhaseKind kind);

}  // namespace plumb::physics
