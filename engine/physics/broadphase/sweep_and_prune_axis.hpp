#pragma once

#include <span>
#include <vector>

#include "physics/broadphase/partitioned_broad_phase.hpp"

namespace plumb::physics {

/// Sweep and prune along one axis: boxes sorted by their lower end along the axis in which they are spread
/// out further. The best choice where all bodies move fast along a line. Boxes that are much longer than most
/// are stored in other segments, so that each segment has a limit for how far before a box its partners may
/// begin. A box may move a little from where it was sorted to; one that moves further is stored after all
/// segments. Source: D. Baraff, "Dynamic Simulation of Non-Penetrating Rigid Bodies", thesis, 1992 (sorted
/// intervals that stay nearly sorted); C. Ericson, "Real-Time Collision Detection", 2005, 7.5
class SweepAndPruneAxis : public SortedRows<SweepAndPruneAxis> {
public:
    SweepAndPruneAxis() : SortedRows{2} {}

    // Interface for PartitionedBroadPhase.
    void sort(const Proxies& proxies, std::span<const std::uint32_t> order, std::uint32_t moving,
              const PlaceList& list);
    std::uint32_t move(const Proxies& proxies, std::uint32_t place);
    void visitRegions(const std::function<void(const AABB&)>& visit) const;

    // Interface for SortedRows and RowBroadPhase.
    std::uint32_t freePlace(const AABB&) { return addPlace(); }
    [[nodiscard]] bool areNear(std::uint32_t a, std::uint32_t b) const {
        return b - a < kNear && b < sorted_;
    }
    template <class Visit>
    void visitNear(const AABB& box, const LineSweep* sweep, std::uint32_t from, const Visit& visit) const;

private:
    static constexpr std::uint32_t kNear = 16;
    static constexpr std::uint32_t kSegments = 6;
    using Key = std::uint64_t;  ///< lower end as an integer of the same order << 32 | index of its id

    struct Segment {
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
        float longest = 0.0f;  ///< m: maximum length along the axis
    };

    void chooseAxis(const Proxies& proxies, std::span<const std::uint32_t> order);
    [[nodiscard]] std::uint32_t segmentOf(const AABB& box) const;
    [[nodiscard]] float startOf(const AABB& box) const { return axis_ == 0 ? box.min.x : box.min.y; }
    [[nodiscard]] float endOf(const AABB& box) const { return axis_ == 0 ? box.max.x : box.max.y; }
    [[nodiscard]] std::uint32_t firstAbove(float x, std::uint32_t begin, std::uint32_t end) const;
    /// The slots of a segment, none before `from`, with the boxes that `box` may overlap.
    [[nodiscard]] Stretch findStarts(const Segment& segment, const AABB& box, std::uint32_t from) const;

    Segment segments_[kSegments];
    std::vector<float> starts_;  ///< m: by slot, the lower end at the last sort
    int axis_ = 0;               ///< 0: x, 1: y
    float usual_ = 0.0f;         ///< m: length that most boxes do not exceed
    float stray_ = 0.0f;         ///< m: maximum distance of a box from where it was sorted to

    std::vector<AABB> boxes_;  ///< of the ids that are sorted
    std::vector<Key> keys_[kSegments];
    RadixSort sorter_;
};

template <class Visit>
void SweepAndPruneAxis::visitNear(const AABB& box, const LineSweep*, std::uint32_t from,
                                  const Visit& visit) const {
    for (const Segment& segment : segments_) {
        if (segment.end <= from || segment.begin == segment.end) continue;
        const Stretch stretch = findStarts(segment, box, from);
        visit(stretch.begin, stretch.end);
    }
    if (places() > sorted_) visit(std::max(sorted_, from), places());
}

}  // namespace plumb::physics
