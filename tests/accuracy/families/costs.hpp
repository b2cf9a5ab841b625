#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumb::families {

/// What twice as many of one kind of thing cost.
struct CostRow {
    std::string_view kind;
    std::vector<int> counts;                ///< each twice the one before
    std::vector<double> micros;             ///< a step, median
    [[nodiscard]] double exponent() const;  ///< of the fitted power: 1 is in proportion
};

/// Times every kind of thing at growing counts. Needs a quiet machine.
std::vector<CostRow> measureCosts();
std::string textOf(std::span<const CostRow> rows);
std::string markdownOf(std::span<const CostRow> rows);

/// Largest exponent that counts as in proportion: 2.2 times the cost for twice the count, which leaves room
/// for caches that get too small.
inline constexpr double kMaxExponent = 1.15;

}  // namespace plumb::families
