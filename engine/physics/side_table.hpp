#pragma once

#include <cstdint>
#include <vector>

#include "physics/ids.hpp"

namespace plumb::physics {

/// What only some things differ in, so that the others need not carry it along: each thing has the index of a
/// row, and kNone stands for a row of defaults.
template <class Row>
struct SideTable {
    std::vector<Row> rows;
    std::vector<std::uint32_t> free;  ///< rows, last freed last

    [[nodiscard]] const Row& operator[](std::uint32_t index) const {
        return index == kNone ? kUsual : rows[index];
    }

    /// The row to write; a thing without one gets one, for as long as it lives.
    Row& own(std::uint32_t& index) {
        if (index != kNone) return rows[index];
        if (free.empty()) {
            index = static_cast<std::uint32_t>(rows.size());
            return rows.emplace_back();
        }
        index = free.back();
        free.pop_back();
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
