#include "physics/broadphase/hilbert_order.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace plumb::physics {

namespace {

constexpr std::size_t kCrowd = 8;         // a cell with more entries than this is sorted by a finer curve
constexpr std::size_t kFewEntries = 96;   // fewer entries are sorted by comparison
constexpr std::size_t kManyCells = 4096;  // more entries get a curve with three digits instead of two
constexpr int kDeepest = 24;  // each level is 256 times finer, and the exponents of floats span 2^277
constexpr float kFarthestKey = 1e30f;  // coordinates are clamped to this
constexpr float kMinExtent = 1e-30f;   // a smaller extent counts as one point

/// Table of four levels of the curve at once, indexed by state and 4 bits each of x and y. Entries: 8 bits of
/// the index on the curve, above them the next state. State bit 0: axes swapped, bit 1: both reversed.
constexpr auto kCurve = [] {
    std::array<std::array<std::uint16_t, 256>, 4> table{};
    for (unsigned state = 0; state < 4; ++state) {
        for (unsigned cell = 0; cell < 256; ++cell) {
            unsigned swapped = state & 1;
            unsigned turned = state >> 1;
            unsigned place = 0;
            for (int bit = 3; bit >= 0; --bit) {
                const unsigned x = ((cell >> (bit + 4)) & 1) ^ turned;
                const unsigned y = ((cell >> bit) & 1) ^ turned;
                const unsigned right = swapped ? y : x;
                const unsigned down = swapped ? x : y;
                place = place << 2 | ((3 * right) ^ down);
                turned ^= right & (down ^ 1);
                swapped ^= down ^ 1;
            }
            table[state][cell] = static_cast<std::uint16_t>((turned << 1 | swapped) << 8 | place);
        }
    }
    return table;
}();

/// Returns the index on the curve. @param digits  number of groups of four bits in x and y
std::uint32_t placeOnCurve(std::uint32_t x, std::uint32_t y, int digits) {
    std::uint32_t state = 0;
    std::uint32_t place = 0;
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) {
        const std::uint32_t step = kCurve[state][((x >> shift) & 15) << 4 | ((y >> shift) & 15)];
        place = place << 8 | (step & 255);
        state = step >> 8;
    }
    return place;
}

Vec2 centreOf(const AABB& box) {
    const Vec2 centre = box.min * 0.5f + box.max * 0.5f;
    // Written so that a NaN ends up at -kFarthestKey.
    return {centre.x > -kFarthestKey ? std::min(centre.x, kFarthestKey) : -kFarthestKey,
            centre.y > -kFarthestKey ? std::min(centre.y, kFarthestKey) : -kFarthestKey};
}

std::uint32_t idOf(std::uint64_t entry) { return static_cast<std::uint32_t>(entry); }

}  // namespace

void RadixSort::sort(std::span<std::uint64_t> keys, int digits, int bits) {
    spare_.resize(std::max(spare_.size(), keys.size()));
    std::span<std::uint64_t> to = std::span{spare_}.first(keys.size());
    const std::size_t last = (std::size_t{1} << bits) - 1;
    for (int shift = 32; shift < 32 + digits * bits; shift += bits) {
        counts_.assign(last + 2, 0);
        for (const std::uint64_t key : keys) ++counts_[(key >> shift & last) + 1];
        std::partial_sum(counts_.begin(), counts_.end(), counts_.begin());
        for (const std::uint64_t key : keys) to[counts_[key >> shift & last]++] = key;
        std::swap(keys, to);
    }
}

void HilbertOrder::sortRange(std::span<const AABB> bounds, std::span<Entry> entries, int depth) {
    Vec2 low = centreOf(bounds[idOf(entries[0])]);
    Vec2 high = low;
    for (const Entry entry : entries) {
        const Vec2 centre = centreOf(bounds[idOf(entry)]);
        low = min(low, centre);
        high = max(high, centre);
    }
    if (low == high) return;

    const int digits = entries.size() > kManyCells ? 3 : 2;
    const auto last = static_cast<float>((1 << (4 * digits)) - 1);
    // Square cells: otherwise a long, narrow world would have long, narrow leaves.
    const float extent = std::max(high.x - low.x, high.y - low.y);
    const float scale = extent > kMinExtent ? last / extent : 0.0f;
    for (Entry& entry : entries) {
        const Vec2 cell = (centreOf(bounds[idOf(entry)]) - low) * scale;
        const auto x = static_cast<std::uint32_t>(std::min(cell.x, last));
        const auto y = static_cast<std::uint32_t>(std::min(cell.y, last));
        entry = Entry{placeOnCurve(x, y, digits)} << 32 | idOf(entry);
    }
    if (entries.size() <= kFewEntries) {
        std::sort(entries.begin(), entries.end());
    } else {
        sorter_.sort(entries, 2, 4 * digits);
    }

    if (depth == kDeepest) return;
    for (std::size_t first = 0, i = 1; i <= entries.size(); ++i) {
        if (i < entries.size() && entries[i] >> 32 == entries[first] >> 32) continue;
        if (i - first > kCrowd) sortRange(bounds, entries.subspan(first, i - first), depth + 1);
        first = i;
    }
}

void HilbertOrder::sort(std::span<const AABB> bounds, std::span<std::uint32_t> ids) {
    if (ids.empty()) return;
    entries_.assign(ids.begin(), ids.end());
    sortRange(bounds, entries_, 0);
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = idOf(entries_[i]);
}

}  // namespace plumb::physics
