#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/broadphase/hilbert_order.hpp"
#include "physics/broadphase/overlap.hpp"

namespace plumb::physics {

struct BoxSearches;
struct LocationList;

inline constexpr std::uint32_t kBranch = 8;  // children per node, and proxies per leaf

/// Eight boxes. The right and bottom sides are negated, so that all four sides are compared and merged
/// alike: two boxes overlap if each `low` of one is at most the opposite side of the other. Empty lanes
/// contain +infinity and overlap no finite box.
struct alignas(32) TreeBoxes {
    float low[4][kBranch];  ///< m: left, top, -right, -bottom

    [[nodiscard]] constexpr AABB at(std::size_t lane) const {
        return {{low[0][lane], low[1][lane]}, {-low[2][lane], -low[3][lane]}};
    }
};

struct TreeNode {
    TreeBoxes boxes;
    std::uint32_t layers[kBranch];  ///< per child: FilterUnion::layers of the leaves below
    std::uint32_t masks[kBranch];   ///< per child: FilterUnion::masks of the leaves below
};

struct TreeLeaf {
    TreeBoxes boxes;
    Filter filters[kBranch];
    std::uint32_t ids[kBranch];  ///< unspecified in empty lanes
    std::uint8_t live;           ///< bits: lanes that are in use
    std::uint8_t awake;          ///< bits: lanes that are ProxyMotion::Awake
};

/// A tree of bounding boxes with eight children per node and without pointers: leaf i is lane i % 8 of node i
/// / 8 in the level above, and so on up. Leaves are filled in the order of a Hilbert curve. Later arrivals
/// are appended in further leaves, removed boxes leave empty lanes, and moved boxes enlarge their leaf, until
/// sorting again costs less than the time that searches have lost.
class Bvh8 {
public:
    // Interface for PartitionedBroadPhase; its slots are lanes here.
    void sort(const Proxies& proxies, std::span<std::uint32_t> ids, std::uint32_t moving,
              const LocationList& list);
    void add(const Proxies& proxies, std::span<std::uint32_t> ids, const LocationList& list);
    void erase(std::uint32_t lane);
    std::uint32_t move(const Proxies& proxies, std::uint32_t lane);
    void settle(std::size_t searches);
    [[nodiscard]] bool isDue(std::size_t arrivals, std::uint32_t) const {
        if (used_ + arrivals - sorted_ > sorted_ / 8 + (sorted_ > 0 ? 32 : 0)) return true;
        return holes_ > size() + 64 || lost_ > kStretchUnit * used_;
    }
    [[nodiscard]] std::uint32_t places() const { return used_; }
    [[nodiscard]] std::uint32_t size() const { return used_ - holes_; }
    [[nodiscard]] bool isFree(std::uint32_t lane) const {
        return (leaves_[lane / kBranch].live >> lane % kBranch & 1) == 0;
    }
    [[nodiscard]] std::uint32_t idAt(std::uint32_t lane) const {
        return leaves_[lane / kBranch].ids[lane % kBranch];
    }
    void find(const BoxSearches& searches, const AABB& box, const LineSweep* sweep, std::uint32_t mask,
              std::vector<std::uint32_t>& found) const;
    void visitRegions(const std::function<void(const AABB&)>& visit) const;

    [[nodiscard]] std::uint32_t height() const { return height_; }  ///< node levels; 0 for an empty tree
    /// @param i  less than height(); the children of level 0 are the leaves
    [[nodiscard]] const TreeNode* level(std::uint32_t i) const { return levels_[i].data(); }
    [[nodiscard]] const TreeLeaf* leaves() const { return leaves_.data(); }

private:
    static constexpr std::size_t kMaxLevels = 11;      // 8^12 lanes: more than there can be ids
    static constexpr std::uint64_t kStretchUnit = 16;  // fixed-point value of a leaf whose area has doubled

    void makeRoom(std::uint32_t lanes);
    void write(const Proxies& proxies, std::uint32_t lane, std::uint32_t id);
    void noteSize(std::size_t leaf, const TreeNode& parent);

    std::vector<TreeLeaf> leaves_;
    std::array<std::vector<TreeNode>, kMaxLevels> levels_;
    /// Dirty bits, set if the parent has to be updated: [0] per leaf, [i + 1] per node of level i.
    std::array<std::vector<std::uint64_t>, kMaxLevels + 1> stale_;
    std::uint32_t height_ = 0;
    std::uint32_t used_ = 0;    ///< lanes, including empty ones
    std::uint32_t holes_ = 0;   ///< empty lanes below used_
    std::uint32_t sorted_ = 0;  ///< lanes in use at the last sort

    std::vector<float> sortedSizes_;        ///< m: width plus height of each leaf after the last sort
    std::vector<std::uint32_t> stretches_;  ///< per leaf: growth of its area since the sort, fixed point
    std::uint64_t stretch_ = 0;             ///< sum of stretches_
    std::uint64_t lost_ = 0;  ///< cost of searches in leaves grown since the sort, unit as stretches_

    HilbertOrder curve_;
};

}  // namespace plumb::physics
