#pragma once

#include <cstdint>
#include <vector>

#include "physics/ids.hpp"

namespace plumb::physics {

/// Returns a freed index, or a new one at the end of parallel lists.
template <class First, class... Others>
std::uint32_t takeIndex(std::vector<std::uint32_t>& free, First& first, Others&... others) {
    if (free.empty()) {
        first.emplace_back();
        (others.emplace_back(), ...);
        return static_cast<std::uint32_t>(first.size() - 1);
    }
    const std::uint32_t index = free.back();
    free.pop_back();
    return index;
}

/// Rarely used properties, outside the main arrays. An object stores the index of its row; kNone: defaults.
template <class Row>
struct SideTable {
    std::vector<Row> rows;
    std::vector<std::uint32_t> free;  ///< free rows, last freed last

    [[nodiscard]] const Row& operator[](std::uint32_t index) const {
        return index == kNone ? kUsual : rows[index];
    }

    /// Returns row `index` for writing; if it is kNone, adds a row and sets `index`. Kept until release().
    Row& own(std::uint32_t& index) {
        if (index != kNone) return rows[index];
        index = takeIndex(free, rows);
        return rows[index] = {};
    }

    void release(std::uint32_t& index) {
        if (index == kNone) return;
        free.push_back(index);
        index = kNone;
    }

private:
    static constexpr Row kUsual{};
};

}  // namespace plumb::physics
