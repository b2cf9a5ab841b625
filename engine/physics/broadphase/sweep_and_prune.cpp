#include <algorithm>
#include <bit>
#include <cmath>

#include "physics/broadphase/row_broad_phase.hpp"

namespace plumb::physics {

namespace {

constexpr float kLonger = 4.0f;         // ratio of the maximum box lengths of successive segments
constexpr float kStray = 0.25f;         // ratio of the allowed displacement to the usual box length
constexpr std::size_t kMaxShifts = 16;  // per key: with more shifts the keys are not nearly sorted

/// Returns an integer that sorts in the same order as the float. Not for NaN.
std::uint32_t sortable(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x + 0.0f);  // makes -0 equal to 0
    return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

/// Insertion sort; gives up when it takes too long.
/// @return false if it gave up; the keys are then partly sorted
bool sortNearlySorted(std::vector<std::uint64_t>& keys) {
    std::size_t left = kMaxShifts * keys.size();
    for (std::size_t i = 1; i < keys.size(); ++i) {
        const std::uint64_t key = keys[i];
        std::size_t at = i;
        for (; at > 0 && keys[at - 1] > key; --at) keys[at] = keys[at - 1];
        keys[at] = key;
        if (i - at > left) return false;
        left -= i - at;
    }
    return true;
}

/// Sweep and prune along one axis: boxes sorted by their lower end along the axis in which they are spread
/// out further. The best choice where all bodies move fast along a line. Boxes that are much longer than most
/// are stored in other segments, so that each segment has a limit for how far before a box its partners may
/// begin. A box may move a little from its sorted position; one that moves further is stored after all
/// segments. Source: D. Baraff, "Dynamic Simulation of Non-Penetrating Rigid Bodies", thesis, 1992 (sorted
/// intervals that stay nearly sorted); C. Ericson, "Real-Time Collision Detection", 2005, 7.5
class SweepAndPruneAxis : public SortedRows<SweepAndPruneAxis> {
public:
    SweepAndPruneAxis() : SortedRows{2} {}

    // Interface for PartitionedBroadPhase.
    void sort(const Proxies& proxies, std::span<const std::uint32_t> order, std::uint32_t,
              const LocationList& list) {
        chooseAxis(proxies, order);
        for (Segment& segment : segments_) segment = {};
        for (auto& keys : keys_) keys.clear();
        boxes_.resize(order.size());
        for (std::uint32_t k = 0; k < order.size(); ++k) {
            const AABB box = usable(proxies.bounds[order[k]]);
            const std::uint32_t i = segmentOf(box);
            boxes_[k] = box;
            keys_[i].push_back(Key{sortable(startOf(box))} << 32 | k);
            segments_[i].longest = std::max(segments_[i].longest, endOf(box) - startOf(box));
        }
        reset(static_cast<std::uint32_t>(order.size()), order.size());
        starts_.resize(order.size());
        std::uint32_t place = 0;
        for (std::uint32_t i = 0; i < kSegments; ++i) {
            if (!sortNearlySorted(keys_[i])) sorter_.sort(keys_[i], 4, 8);
            segments_[i].begin = place;
            for (const Key key : keys_[i]) {
                const std::uint32_t id = order[key & 0xffffffffu];
                const AABB& box = boxes_[key & 0xffffffffu];
                write(proxies, place, id, box);
                starts_[place] = startOf(box);
                list.set(id, place++);
            }
            segments_[i].end = place;
        }
    }

    std::uint32_t move(const Proxies& proxies, std::uint32_t place) {
        const std::uint32_t id = idAt(place);
        const AABB box = usable(proxies.bounds[id]);
        if (place < sorted_) {
            const float strayed = std::fabs(startOf(box) - starts_[place]);
            std::uint32_t segment = 0;
            while (place >= segments_[segment].end) ++segment;
            if (!(strayed <= stray_) || endOf(box) - startOf(box) > segments_[segment].longest) {
                erase(place);
                place = addPlace();
            }
        }
        write(proxies, place, id, box);
        return place;
    }

    void visitRegions(const std::function<void(const AABB&)>& visit) const {
        for (const Segment& segment : segments_) {
            AABB box = kNowhere;
            for (std::uint32_t place = segment.begin; place < segment.end; ++place) {
                if (!isFree(place)) box = merged(box, boxAt(place));
            }
            if (box.min.x <= box.max.x) visit(box);
        }
    }

    // Interface for SortedRows and RowBroadPhase.
    std::uint32_t freePlace(const AABB&) { return addPlace(); }
    [[nodiscard]] bool areNear(std::uint32_t a, std::uint32_t b) const {
        return b - a < kNear && b < sorted_;
    }
    template <class Visit>
    void visitNear(const AABB& box, const LineSweep*, std::uint32_t from, const Visit& visit) const {
        for (const Segment& segment : segments_) {
            if (segment.end <= from || segment.begin == segment.end) continue;
            const SlotRange range = findStarts(segment, box, from);
            visit(range.begin, range.end);
        }
        if (places() > sorted_) visit(std::max(sorted_, from), places());
    }

private:
    static constexpr std::uint32_t kNear = 16;  // slots: boxes this near in the list search together
    static constexpr std::uint32_t kSegments = 6;
    using Key = std::uint64_t;  ///< sortable(lower end) << 32 | index in the list of ids

    struct Segment {
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
        float longest = 0.0f;  ///< m: maximum length along the axis
    };

    /// Chooses the axis, if the boxes changed much or the last choice is old.
    void chooseAxis(const Proxies& proxies, std::span<const std::uint32_t> order) {
        const auto spread = newStatistics(proxies, order);
        if (!spread) return;
        axis_ = spread->aspect >= 1.0f ? 0 : 1;
        usual_ = spread->extent;
        stray_ = spread->extent * kStray;
    }

    [[nodiscard]] std::uint32_t segmentOf(const AABB& box) const {
        const float length = endOf(box) - startOf(box);
        float maximum = usual_;
        for (std::uint32_t i = 0; i + 1 < kSegments; ++i) {
            if (!(length > maximum)) return i;  // kNowhere is in the first segment
            maximum *= kLonger;
        }
        return kSegments - 1;
    }

    [[nodiscard]] float startOf(const AABB& box) const { return axis_ == 0 ? box.min.x : box.min.y; }
    [[nodiscard]] float endOf(const AABB& box) const { return axis_ == 0 ? box.max.x : box.max.y; }
    /// The first slot from `begin` on whose box starts above x.
    [[nodiscard]] std::uint32_t firstAbove(float x, std::uint32_t begin, std::uint32_t end) const {
        if (begin >= end) return end;
        const float* at = starts_.data() + begin;
        std::uint32_t left = end - begin;
        while (left > 1) {
            const std::uint32_t half = left / 2;
            at = at[half - 1] <= x ? at + half : at;  // unpredictable, so without a branch
            left -= half;
        }
        return static_cast<std::uint32_t>(at - starts_.data()) + (*at <= x ? 1 : 0);
    }

    /// Returns the slots of a segment, none before `from`, whose boxes `box` may overlap.
    [[nodiscard]] SlotRange findStarts(const Segment& segment, const AABB& box, std::uint32_t from) const {
        // Boxes may have moved since the sort; lengths and positions may have been rounded.
        const float lower = startOf(box) - segment.longest - stray_;
        const float upper = endOf(box) + stray_ + std::fabs(endOf(box)) * (2.0f * kRounding);
        if (from > segment.begin) {
            // The search starts after a box of this segment, so the last partner is near.
            std::uint32_t step = 8;
            while (from + step < segment.end && starts_[from + step] <= upper) step *= 2;
            return {from, firstAbove(upper, from, std::min(from + step, segment.end))};
        }
        const float lost = (std::fabs(startOf(box)) + segment.longest) * (2.0f * kRounding);
        const std::uint32_t begin = firstAbove(lower - lost, segment.begin, segment.end);
        return {begin, firstAbove(upper, begin, segment.end)};
    }

    Segment segments_[kSegments];
    std::vector<float> starts_;  ///< m: by slot, the lower end at the last sort
    int axis_ = 0;               ///< 0: x, 1: y
    float usual_ = 0.0f;         ///< m: length that most boxes do not exceed
    float stray_ = 0.0f;         ///< m: maximum distance of a box from its sorted position

    std::vector<AABB> boxes_;  ///< bounds of the boxes, during the sort
    std::vector<Key> keys_[kSegments];
    RadixSort sorter_;
};

}  // namespace

std::unique_ptr<BroadPhase> makeSweepAndPrune() {
    return std::make_unique<RowBroadPhase<SweepAndPruneAxis>>();
}

}  // namespace plumb::physics
