#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/accuracy/command/threads.hpp"
#include "tests/accuracy/stability/maps.hpp"

namespace plumb::stability {

/// A map with what came out. Rows may be fewer than the map has.
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
    /// Where a row is no worse than `floor`, in words: "all", "none", "to 1000", "0.1 to 10".
    [[nodiscard]] std::string holds(std::size_t row, Score floor) const;
};

struct Choice {
    bool quick = false;    ///< only the rows that are marked so
    std::string_view map;  ///< the name of one; empty for all
    int threads = 1;
};

/// Plays all cells that are chosen, on some threads. What comes out does not depend on how many.
std::vector<PlayedMap> play(const Choice& choice, const accuracy::ShowDone& show = {});

}  // namespace plumb::stability
