#include "physics/broadphase/box_statistics.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "physics/broadphase/overlap.hpp"

namespace plumb::physics {

namespace {

float usualExtent(const Proxies& proxies, std::span<const std::uint32_t> ids) {
    std::array<std::uint32_t, 512> counts{};  // by exponent and first bit of the mantissa
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
    const double spacing =
        3.5 * std::sqrt(deviation(0) * deviation(1) / count);  // even spread: side = sqrt(12) deviations
    return {usualExtent(proxies, ids), static_cast<float>(spacing),
            static_cast<float>(deviation(0) / deviation(1))};
}

}  // namespace plumb::physics
