#pragma once

#include "editor/ui/ui.hpp"
#include "editor/ui/widgets/dialog.hpp"

namespace plumb::editor::ui {

/// After a game stopped in which something was changed by hand: what of it goes into the scene.
class KeepDialog {
public:
    void draw(Ui& ui);

private:
    LastingQuestion question_{"Keep changes?"};
};

}  // namespace plumb::editor::ui
