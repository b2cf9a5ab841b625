#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumb::families {

/// Step times of scenes with growing numbers of objects of one kind.
struct CostRow {
    std::string_view kind;
    std::vector<int> counts;                ///< numbers of objects, each twice the previous one
    std::vector<double> micros;             ///< median time of a step for each count, µs
    [[nodiscard]] double exponent() const;  ///< exponent p of the fit time ~ count^p; 1: proportional
};

/// Measures step times for every kind of object at growing counts. Run it on a machine without other load.
std::vector<CostRow> measureCosts();
std::string textOf(std::span<const CostRow> rows);
std::string markdownOf(std::span<const CostRow> rows);

/// Largest exponent that counts as proportional: 2.2 times the time for twice the count, which allows for
/// cache misses at large counts.
inline constexpr double kMaxExponent = 1.15;

}  // namespace plumb::families
