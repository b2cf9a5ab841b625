#pragma once

#include <algorithm>
#include <compare>
#include <utility>
#include <vector>

namespace plumb::editor {

/// Column (x) and row (y) of a cell in a tile layer or a palette.
struct CellPlace {
    int x = 0;
    int y = 0;
    friend bool operator==(CellPlace, CellPlace) = default;
};

/// Selected cells of a tile layer, each once, sorted by row and column. Not part of the undo history.
class CellSelection {
public:
    [[nodiscard]] const std::vector<CellPlace>& all() const { return cells_; }
    [[nodiscard]] bool empty() const { return cells_.empty(); }
    [[nodiscard]] bool has(CellPlace place) const {
        return std::binary_search(cells_.begin(), cells_.end(), place, &inRows);
    }

    void clear() { cells_.clear(); }
    void set(std::vector<CellPlace> cells) {
        cells_ = std::move(cells);
        std::sort(cells_.begin(), cells_.end(), &inRows);
        cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
    }
    void add(const std::vector<CellPlace>& cells) {
        std::vector<CellPlace> all = cells_;
        all.insert(all.end(), cells.begin(), cells.end());
        set(std::move(all));
    }
    void remove(std::vector<CellPlace> cells) {
        CellSelection removed;
        removed.set(std::move(cells));
        std::erase_if(cells_, [&](CellPlace place) { return removed.has(place); });
    }
    void move(int dx, int dy) {
        for (CellPlace& place : cells_) place.x += dx, place.y += dy;
    }

private:
    static bool inRows(CellPlace a, CellPlace b) { return std::pair{a.y, a.x} < std::pair{b.y, b.x}; }

    std::vector<CellPlace> cells_;
};

}  // namespace plumb::editor
