#pragma once

#include "editor/ui/ui.hpp"
#include "editor/ui/widgets/dialog.hpp"

namespace plumb::editor::ui {

/// Dialog after a game in which the user edited fields: lets the user select the edits to copy to the scene.
class KeepDialog {
public:
    void draw(Ui& ui);

private:
    LastingQuestion question_{"Keep changes?"};
};

}  // namespace plumb::editor::ui
