#include "physics/broadphase/box_rows.hpp"

#include <algorithm>
#include <bit>

namespace plumb::physics {

namespace {

constexpr std::uint32_t kBehind = 8;           // slots of padding at the end
constexpr std::uint32_t kSortsPerChoice = 32;  // the distribution of boxes changes slowly

float usualExtent(const Proxies& proxies, std::span<const std::uint32_t> ids) {
    std::array<std::uint32_t, 512> counts{};  // of sizes, by exponent and first mantissa bit
    for (const std::uint32_t id : ids) {
        const Vec2 size = usable(proxies.bounds[id]).size();
        ++counts[std::bit_cast<std::uint32_t>(std::max({size.x, size.y, 0.0f})) >> 22 & 511];
    }
    std::uint32_t median = 0;
    std::size_t passed = counts[0];
    while (passed * 2 < ids.size()) passed += counts[++median];
    std::uint32_t maximum = median;
    while (passed * 4 < ids.size() * 3 && maximum < median + 2) passed += counts[++maximum];
    constexpr std::uint32_t kLastFinite = 509;
    return std::bit_cast<float>(std::min(maximum + 1, kLastFinite) << 22);
}

}  // namespace

BoxStatistics statisticsOf(const Proxies& proxies, std::span<const std::uint32_t> ids) {
    double sum[2] = {};
    double squares[2] = {};
    double count = 1.0;
    for (const std::uint32_t id : ids) {
        const AABB box = usable(proxies.bounds[id]);
        if (box == kNowhere) continue;
        const Vec2 middle = middleOf(box);
        const double at[] = {double{middle.x}, double{middle.y}};
        for (int axis = 0; axis < 2; ++axis) {
            sum[axis] += at[axis];
            squares[axis] += at[axis] * at[axis];
        }
        count += 1.0;
    }
    const auto deviation = [&](int axis) {
        const double mean = sum[axis] / count;
        return std::sqrt(std::max(squares[axis] / count - mean * mean, 1e-12));
    };
    const double spacing = 3.5 * std::sqrt(deviation(0) * deviation(1) / count);  // side: sqrt(12) deviations
    return {usualExtent(proxies, ids), static_cast<float>(spacing),
            static_cast<float>(deviation(0) / deviation(1))};
}

/// Appends free slots, or removes some at the end.
void BoxRows::resize(std::uint32_t places) {
    for (auto& side : low) side.resize(places + kBehind, kEmpty);
    filters.resize(places);
    ids.resize(places);
    states.resize(places, kFree);
    free_ = free_ + places - count_;
    count_ = places;
}

void BoxRows::reset(std::uint32_t places, std::size_t boxes) {
    for (auto& side : low) side.clear();
    states.clear();
    count_ = free_ = 0;
    resize(places);
    all = {};
    sorted_ = places;
    sortedSize_ = static_cast<std::uint32_t>(boxes);
    lost_ = 0;
}

void BoxRows::write(const Proxies& proxies, std::uint32_t place, std::uint32_t id, const AABB& box) {
    low[0][place] = box.min.x;
    low[1][place] = box.min.y;
    low[2][place] = -box.max.x;
    low[3][place] = -box.max.y;
    filters[place] = proxies.filters[id];
    ids[place] = id;
    free_ -= isFree(place) ? 1u : 0u;
    states[place] = proxies.motions[id] == ProxyMotion::Awake ? kAwake : kInUse;
    all.add(filters[place]);
}

std::optional<BoxStatistics> BoxRows::newStatistics(const Proxies& proxies,
                                                    std::span<const std::uint32_t> order) {
    const std::size_t before = chosenFor_;
    const std::size_t now = order.size();
    const bool alike = now <= before + before / 8 && before <= now + now / 8;
    if (alike && sortsSince_++ < kSortsPerChoice) return std::nullopt;
    chosenFor_ = now;
    sortsSince_ = 0;
    return statisticsOf(proxies, order);
}

void BoxRows::settle(std::size_t searches) {
    std::uint32_t used = count_;
    while (used > sorted_ && isFree(used - 1)) --used;
    if (used < count_) resize(used);
    if (used - sorted_ > kFew) lost_ += searches * ((used - sorted_) / 8);
}

}  // namespace plumb::physics
