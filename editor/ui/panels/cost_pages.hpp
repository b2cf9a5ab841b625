#pragma once

#include <vector>

#include "editor/model/cost/island_table.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// What each part of a tick took in the last second, as bars.
void drawStagesPage(Ui& ui);

/// The islands of the game that plays.
class IslandsPage {
public:
    void draw(Ui& ui);

private:
    void refresh(const Ui& ui);
    void drawRow(Ui& ui, std::size_t index);

    std::vector<IslandRow> rows_;
    IslandColumn by_ = IslandColumn::Cost;
    bool descending_ = true;
    std::int64_t tick_ = -1;  ///< that they are of
    physics::BodyId chosen_;  ///< the first body of the island that was clicked
};

}  // namespace plumb::editor::ui
