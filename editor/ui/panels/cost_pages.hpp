#pragma once

#include <vector>

#include "editor/model/cost/island_table.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Draws the page "Stages": the time of each part of a tick in the last second, as bars.
void drawStagesPage(Ui& ui);

/// The page "Islands": a table of the simulation islands of the running game.
class IslandsPage {
public:
    void draw(Ui& ui);

private:
    void refresh(const Ui& ui);
    void drawRow(Ui& ui, std::size_t index);

    std::vector<IslandRow> rows_;
    IslandColumn by_ = IslandColumn::Cost;  ///< column by which the rows are sorted
    bool descending_ = true;
    std::int64_t tick_ = -1;  ///< the tick of the running game at which `rows_` was read
    physics::BodyId chosen_;  ///< first body of the selected island
};

}  // namespace plumb::editor::ui
