#pragma once

#include "editor/ui/ui.hpp"
#include "editor/ui/widgets/dialog.hpp"

namespace plumb::editor::ui {

/// The dialog shown after a game in which the user changed fields: selects the changes to copy to the scene.
class KeepDialog {
public:
    void draw(Ui& ui);

private:
    LastingQuestion question_{"Keep changes?"};
};

}  // namespace plumb::editor::ui
