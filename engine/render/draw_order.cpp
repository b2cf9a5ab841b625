#include "render/draw_order.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace plumb {
namespace {

constexpr unsigned kDigitBits = 11;
constexpr std::size_t kDigitValues = std::size_t{1} << kDigitBits;
constexpr std::size_t kDigits = 3;
using Counts = std::array<std::array<std::uint32_t, kDigitValues>, kDigits>;

std::size_t digitOf(std::uint32_t key, std::size_t digit) {
    return (key >> (digit * kDigitBits)) & (kDigitValues - 1);
}

/// Counts all digits in one pass. @return true if the keys are already sorted
bool countDigits(std::span<const DrawItem> items, Counts& counts) {
    bool ordered = true;
    std::uint32_t before = 0;
    for (const DrawItem& item : items) {
        for (std::size_t digit = 0; digit < kDigits; ++digit) ++counts[digit][digitOf(item.key, digit)];
        ordered = ordered && before <= item.key;
        before = item.key;
    }
    return ordered;
}

void startsFromCounts(std::array<std::uint32_t, kDigitValues>& counts) {
    std::uint32_t start = 0;
    for (std::uint32_t& count : counts) {
        const std::uint32_t here = count;
        count = start;
        start += here;
    }
}

}  // namespace

std::span<const DrawItem> DrawOrder::sort(std::span<const DrawItem> items) {
    sorted_.assign(items.begin(), items.end());
    Counts counts{};
    if (items.empty() || countDigits(items, counts)) return sorted_;

    spare_.resize(items.size());
    for (std::size_t digit = 0; digit < kDigits; ++digit) {
        auto& starts = counts[digit];
        if (starts[digitOf(items.front().key, digit)] == items.size()) continue;
        startsFromCounts(starts);
        for (const DrawItem& item : sorted_) spare_[starts[digitOf(item.key, digit)]++] = item;
        sorted_.swap(spare_);
    }
    return sorted_;
}

}  // namespace plumb
