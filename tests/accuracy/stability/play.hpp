#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/accuracy/command/threads.hpp"
#include "tests/accuracy/stability/maps.hpp"

namespace plumb::stability {

/// A map with its results. It may have fewer rows than the map.
struct PlayedMap {
    const Map* map = nullptr;
    std::vector<std::size_t> rows;  ///< of the map's, in order
    std::vector<Figures> cells;     ///< row by row, all columns of each

    [[nodiscard]] std::size_t width() const { return map->columns.values.size(); }
    [[nodiscard]] const Figures& at(std::size_t row, std::size_t column) const {
        return cells[row * width() + column];
    }
    [[nodiscard]] std::vector<Score> scoresOf(std::size_t row) const;
    [[nodiscard]] std::string rowLabel(std::size_t row) const;
    [[nodiscard]] std::string columnLabel(std::size_t column) const;
    /// The range of a row that is no worse than `floor`, as text: "all", "none", "to 1000", "0.1 to 10".
    [[nodiscard]] std::string holds(std::size_t row, Score floor) const;
};

struct Choice {
    bool quick = false;    ///< only the rows that are marked for it
    std::string_view map;  ///< the name of one map; empty: all
    int threads = 1;
};

/// Runs all selected cells on several threads. The results do not depend on their number.
std::vector<PlayedMap> play(const Choice& choice, const accuracy::ShowDone& show = {});

}  // namespace plumb::stability
