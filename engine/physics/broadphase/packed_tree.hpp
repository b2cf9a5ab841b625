#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/broadphase/broad_phase.hpp"
#include "physics/broadphase/curve_order.hpp"

namespace plumb::physics {

class RegionVisitor;

inline constexpr std::uint32_t kBranch = 8;  // children of a node, proxies of a leaf

/// Eight boxes. The far sides are negated, so that all four are compared and merged alike: boxes overlap
/// where each `low` of one is at most the other's far side. Empty lanes have +infinity and overlap nothing
/// finite.
struct alignas(32) TreeBoxes {
    float low[4][kBranch];  ///< m: left, top, -right, -bottom
};

/// Eight children.
struct TreeNode {
    TreeBoxes boxes;
    std::uint32_t layers[kBranch];  ///< of all below; see overruledBy()
    std::uint32_t masks[kBranch];
};

/// Eight proxies.
struct TreeLeaf {
    TreeBoxes boxes;
    Filter filters[kBranch];
    std::uint32_t ids[kBranch];  ///< in empty lanes that of any
    std::uint8_t live;           ///< bits: lanes that are not empty
    std::uint8_t awake;          ///< bits: lanes that are ProxyMotion::Awake
};

/// A tree of boxes with eight children per node and no pointers: leaf i is lane i % 8 of node i / 8 of the
/// level above, and so on up. Leaves are filled in the order of a curve through the boxes. Whoever comes
/// later goes to further leaves, who leaves leaves an empty lane, and who moves stretches its leaf, until
/// sorting again costs less than the time that searches have lost.
class PackedTree {
public:
    // What PartedProxies asks of a part; places are lanes.
    bool take(const Proxies& proxies, std::span<std::uint32_t> arrivals, std::uint32_t moving,
              std::span<std::uint32_t> places, std::uint32_t first);
    void erase(std::uint32_t lane);
    std::uint32_t move(const Proxies& proxies, std::uint32_t lane);
    void settle(std::size_t searches);
    [[nodiscard]] bool isDue(std::size_t arrivals) const;
    [[nodiscard]] std::uint32_t places() const { return used_; }
    [[nodiscard]] std::uint32_t size() const { return used_ - holes_; }
    [[nodiscard]] std::uint32_t idAt(std::uint32_t lane) const {
        return leaves_[lane / kBranch].ids[lane % kBranch];
    }
    void clear();
    void visitRegions(RegionVisitor& visitor) const;

    [[nodiscard]] std::uint32_t height() const { return height_; }  ///< levels of nodes; 0 without lanes
    /// @param i  below height(); the children of level 0 are the leaves
    [[nodiscard]] const TreeNode* level(std::uint32_t i) const { return levels_[i].data(); }
    [[nodiscard]] const TreeLeaf* leaves() const { return leaves_.data(); }

private:
    static constexpr std::size_t kMostLevels = 11;  // 8^12 lanes: more than there are ids

    void sort(const Proxies& proxies, std::span<const std::uint32_t> arrivals,
              std::span<std::uint32_t> places, std::uint32_t first);
    void append(const Proxies& proxies, std::span<const std::uint32_t> arrivals,
                std::span<std::uint32_t> places, std::uint32_t first);
    void makeRoom(std::uint32_t lanes);
    void write(const Proxies& proxies, std::uint32_t lane, std::uint32_t id);
    void noteSize(std::size_t leaf, const TreeNode& parent);

    std::vector<TreeLeaf> leaves_;
    std::array<std::vector<TreeNode>, kMostLevels> levels_;
    /// Bits: in 0 leaves, in i + 1 nodes of level i, that changed since their parents were written.
    std::array<std::vector<std::uint64_t>, kMostLevels + 1> stale_;
    std::uint32_t height_ = 0;
    std::uint32_t used_ = 0;  ///< lanes, with holes
    std::uint32_t holes_ = 0;
    std::uint32_t sorted_ = 0;  ///< lanes when it was sorted

    std::vector<float> sortedSizes_;  ///< m: of leaves after sorting, width and height together
    std::vector<std::uint32_t>
        stretches_;              ///< by leaf: how much likelier than then it is in the way, fixed point
    std::uint64_t stretch_ = 0;  ///< all of them
    std::uint64_t lost_ = 0;     ///< by searches since the sorting, in the same unit

    CurveOrder curve_;
    std::vector<std::uint32_t> order_;
};

}  // namespace plumb::physics
