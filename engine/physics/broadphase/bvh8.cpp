#include "physics/broadphase/bvh8.hpp"

#include <algorithm>

#include "physics/broadphase/partitioned_broad_phase.hpp"

namespace plumb::physics {

namespace {

constexpr float kMaxStretch = 1e6f;  // maximum ratio of sizes

constexpr TreeBoxes emptyBoxes() {
    TreeBoxes boxes{};
    for (auto& side : boxes.low) std::fill_n(side, kBranch, std::numeric_limits<float>::infinity());
    return boxes;
}
constexpr TreeNode kEmptyNode{emptyBoxes(), {}, {}};
constexpr TreeLeaf kEmptyLeaf{emptyBoxes(), {}, {}, 0, 0};

float minOf(const float (&side)[kBranch]) {
    float four[4];
    for (int i = 0; i < 4; ++i) four[i] = std::min(side[i], side[i + 4]);
    return std::min(std::min(four[0], four[2]), std::min(four[1], four[3]));
}

FilterUnion filtersOf(const TreeNode& node) {
    FilterUnion all;
    for (std::uint32_t i = 0; i < kBranch; ++i) {
        all.layers |= node.layers[i];
        all.masks |= node.masks[i];
    }
    return all;
}

FilterUnion filtersOf(const TreeLeaf& leaf) {
    FilterUnion all;
    for (const Filter& filter : leaf.filters) all.add(filter);
    return all;
}

/// Writes the union of the children of a node or leaf into a lane of its parent.
template <class Child>
void mergeInto(TreeNode& parent, std::size_t lane, const Child& child) {
    for (int side = 0; side < 4; ++side) parent.boxes.low[side][lane] = minOf(child.boxes.low[side]);
    const FilterUnion filters = filtersOf(child);
    parent.layers[lane] = filters.layers;
    parent.masks[lane] = filters.masks;
}

/// The default broad phase: trees with eight children per node, which no distribution of boxes degrades.
class TreeBroadPhase final : public PartitionedBroadPhase<Bvh8> {
public:
    void findPairs(std::span<const std::uint32_t> moved, std::span<const std::uint8_t> isMoved,
                   std::vector<PairKey>& pairs) const override {
        TreeSearch search;
        search.isMoved = isMoved.data();
        for (std::size_t i = 0; i < moved.size();) {
            // Proxies of one leaf search together.
            const ProxyLocation place = placeOf(moved[i]);
            std::uint32_t lanes = 0;
            for (; i < moved.size(); ++i) {
                const ProxyLocation next = placeOf(moved[i]);
                if (next / kBranch != place / kBranch) break;
                lanes |= 1u << next % kBranch;
            }
            if (place == kNoLocation) continue;
            const std::uint32_t part = partOfLocation(place);
            search.own = &parts_[part];
            search.ownMayBeAwake = part == kMovingPart;
            search.leaf = inPart(place) / kBranch;
            for (std::uint32_t other = firstPartner(part); other < kParts; ++other) {
                // Only awake proxies pair with static ones.
                search.lanes = other == kStaticPart ? lanes & search.own->leaves()[search.leaf].awake : lanes;
                search.allCanPair = allCanPair(part, other);
                search.others = &parts_[other];
                if (search.lanes != 0 && search.others->size() > 0) searches_.findPairsOfLeaf(search, pairs);
            }
        }
    }
};

}  // namespace

void Bvh8::makeRoom(std::uint32_t lanes) {
    std::size_t nodes = (lanes + kBranch - 1) / kBranch;
    leaves_.resize(nodes, kEmptyLeaf);
    stretches_.resize(nodes);
    stale_[0].resize((nodes + 63) / 64);
    height_ = 0;
    while (nodes > 1 || (nodes == 1 && height_ == 0)) {
        nodes = (nodes + kBranch - 1) / kBranch;
        if (levels_[height_].empty()) setBit(stale_[height_], 0);  // the former top level has a parent now
        levels_[height_].resize(nodes, kEmptyNode);
        stale_[++height_].resize((nodes + 63) / 64);
    }
}

void Bvh8::visitRegions(const std::function<void(const AABB&)>& visit) const {
    std::size_t lanes = (std::size_t{used_} + kBranch - 1) / kBranch;
    for (std::uint32_t level = 0; level < height_; ++level) {
        for (std::size_t i = 0; i < lanes; ++i) {
            const AABB box = levels_[level][i / kBranch].boxes.at(i % kBranch);
            if (box.min.x <= box.max.x) visit(box);
        }
        lanes = (lanes + kBranch - 1) / kBranch;
    }
}

void Bvh8::write(const Proxies& proxies, std::uint32_t lane, std::uint32_t id) {
    TreeLeaf& leaf = leaves_[lane / kBranch];
    const std::uint32_t i = lane % kBranch;
    const auto bit = static_cast<std::uint8_t>(1u << i);
    const AABB box = usable(proxies.bounds[id]);
    leaf.boxes.low[0][i] = box.min.x;
    leaf.boxes.low[1][i] = box.min.y;
    leaf.boxes.low[2][i] = -box.max.x;
    leaf.boxes.low[3][i] = -box.max.y;
    leaf.filters[i] = proxies.filters[id];
    leaf.ids[i] = id;
    leaf.live |= bit;
    leaf.awake &= static_cast<std::uint8_t>(~bit);
    if (proxies.motions[id] == ProxyMotion::Awake) leaf.awake |= bit;
}

std::uint32_t Bvh8::move(const Proxies& proxies, std::uint32_t lane) {
    write(proxies, lane, idAt(lane));
    setBit(stale_[0], lane / kBranch);
    return lane;
}

void Bvh8::erase(std::uint32_t lane) {
    TreeLeaf& leaf = leaves_[lane / kBranch];
    const std::uint32_t i = lane % kBranch;
    const auto others = static_cast<std::uint8_t>(~(1u << i));
    for (int side = 0; side < 4; ++side) leaf.boxes.low[side][i] = kEmptyLeaf.boxes.low[side][i];
    leaf.filters[i] = kEmptyLeaf.filters[i];
    leaf.live &= others;
    leaf.awake &= others;
    setBit(stale_[0], lane / kBranch);
    ++holes_;
}

void Bvh8::add(const Proxies& proxies, std::span<std::uint32_t> ids, const LocationList& list) {
    curve_.sort(proxies.bounds, ids);
    makeRoom(used_ + static_cast<std::uint32_t>(ids.size()));
    for (const std::uint32_t id : ids) {
        write(proxies, used_, id);
        setBit(stale_[0], used_ / kBranch);
        list.set(id, used_++);
    }
}

void Bvh8::sort(const Proxies& proxies, std::span<std::uint32_t> ids, std::uint32_t,
                const LocationList& list) {
    for (auto& level : levels_) level.clear();
    for (auto& bits : stale_) bits.clear();
    leaves_.clear();
    sortedSizes_.clear();
    stretches_.clear();
    stretch_ = lost_ = 0;
    height_ = used_ = holes_ = 0;
    add(proxies, ids, list);
    sorted_ = used_;
}

void Bvh8::find(const BoxSearches& searches, const AABB& box, const LineSweep* sweep, std::uint32_t mask,
                std::vector<std::uint32_t>& found) const {
    searches.findInTree(*this, box, sweep, mask, found);
}

void Bvh8::noteSize(std::size_t leaf, const TreeNode& parent) {
    const std::size_t lane = leaf % kBranch;
    const auto& low = parent.boxes.low;
    const float size = -(low[0][lane] + low[2][lane]) - (low[1][lane] + low[3][lane]);
    if (sortedSizes_.size() <= leaf && sorted_ == used_)
        return sortedSizes_.push_back(size);  // first visit after a sort
    // Leaves that were added after the sort are compared with an arbitrary sorted leaf.
    const float wanted = sortedSizes_[leaf % sortedSizes_.size()];
    std::uint32_t stretch = 0;
    if (size > wanted) {
        const float ratio = std::min(size / wanted, kMaxStretch);
        stretch = static_cast<std::uint32_t>(std::min(ratio * ratio - 1.0f, kMaxStretch) * kStretchUnit);
    }
    stretch_ += stretch - std::uint64_t{stretches_[leaf]};
    stretches_[leaf] = stretch;
}

void Bvh8::settle(std::size_t searches) {
    if (height_ == 0) return;
    takeBits(stale_[0], [&](std::size_t leaf) {
        TreeNode& parent = levels_[0][leaf / kBranch];
        mergeInto(parent, leaf % kBranch, leaves_[leaf]);
        noteSize(leaf, parent);
        setBit(stale_[1], leaf / kBranch);
    });
    for (std::size_t level = 0; level + 1 < height_; ++level) {
        takeBits(stale_[level + 1], [&](std::size_t node) {
            mergeInto(levels_[level + 1][node / kBranch], node % kBranch, levels_[level][node]);
            setBit(stale_[level + 2], node / kBranch);
        });
    }
    stale_[height_][0] = 0;
    lost_ += searches * stretch_ / leaves_.size();
}

std::unique_ptr<BroadPhase> makeTree() { return std::make_unique<TreeBroadPhase>(); }

}  // namespace plumb::physics
