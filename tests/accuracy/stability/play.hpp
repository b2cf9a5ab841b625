#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/accuracy/command/threads.hpp"
#include "tests/accuracy/stability/maps.hpp"

namespace plumb::stability {

/// Results of a map, or of some of its rows.
struct PlayedMap {
    const Map* map = nullptr;
    std::vector<std::size_t> rows;  ///< indices of the rows of the map, in order
    std::vector<Figures> cells;     ///< figures of all cells, row by row

    [[nodiscard]] std::size_t width() const { return map->columns.values.size(); }
    [[nodiscard]] const Figures& at(std::size_t row, std::size_t column) const {
        return cells[row * width() + column];
    }
    [[nodiscard]] std::vector<Score> scoresOf(std::size_t row) const;
    [[nodiscard]] std::string rowLabel(std::size_t row) const;
    [[nodiscard]] std::string columnLabel(std::size_t column) const;
    /// Formats the range of column values around the easiest column for which all
    /// scores are at least `floor`: "all", "none", "to 1000", "0.1 to 10".
    [[nodiscard]] std::string holds(std::size_t row, Score floor) const;
};

struct Choice {            ///< cells to run
    bool quick = false;    ///< only the rows in Map::quickRows
    std::string_view map;  ///< name of a map; empty: all maps
    int threads = 1;
};

/// Runs all selected cells on several threads. The results do not depend on the number of threads.
std::vector<PlayedMap> play(const Choice& choice, const accuracy::ShowDone& show = {});

}  // namespace plumb::stability
