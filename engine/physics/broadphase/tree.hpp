#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/broadphase/broad_phase.hpp"
#include "physics/broadphase/packed_tree.hpp"

namespace plumb::physics {

struct TreeSearch;

/// Trees of boxes, eight children a node: one of what never moves, one of what rests, one of what moves. The
/// default: no distribution of sizes and places is bad for it.
class TreeBroadPhase final : public BroadPhase {
public:
    /// @param search  compiled for this processor
    explicit TreeBroadPhase(const TreeSearch& search) : search_{search} {}

    void rebuild(const Proxies& proxies) override;
    void update(const Proxies& proxies, std::span<const std::uint32_t> changed) override;
    void arrange(std::span<std::uint32_t> moved) override;
    void findPairs(const Proxies& proxies, std::span<const std::uint32_t> moved,
                   std::span<const std::uint8_t> isMoved, std::vector<PairKey>& pairs) const override;
    void query(const Proxies& proxies, const AABB& box, std::uint32_t mask,
               std::vector<std::uint32_t>& found) const override;
    void cast(const Proxies& proxies, Vec2 from, Vec2 way, Vec2 half, std::uint32_t mask,
              std::vector<std::uint32_t>& found) const override;

private:
    enum Tree : std::uint32_t { kStatic, kAsleep, kMoving, kTrees };
    static std::uint32_t treeOf(ProxyMotion motion);

    void sendToTrees(const Proxies& proxies, std::span<const std::uint32_t> changed);

    const TreeSearch& search_;
    std::array<PackedTree, kTrees> trees_;
    std::vector<std::uint32_t>
        lanes_;  ///< by proxy: which tree (high 2 bits), which lane of it; or kNowhereLane
    std::array<std::vector<std::uint32_t>, kTrees> arrivals_;
    std::array<std::vector<std::uint64_t>, kTrees>
        marks_;  ///< of arrange(): bits, by lane; all 0 between calls
};

}  // namespace plumb::physics
