#pragma once

#include <optional>
#include <string>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The dialogs that ask for the name of a scene: of a new one, or of a copy of the open one.
class SceneNameDialog {
public:
    struct Answer {
        std::string name;   ///< of a scene that does not exist yet
        bool copy = false;  ///< the open scene gets this name; false: a new scene
    };
    /// Draws the dialog, if it is open. Opens it on WindowRequest::NameNewScene and NameSceneCopy.
    /// @return the name that the user has just confirmed
    std::optional<Answer> draw(Ui& ui);

private:
    std::optional<Answer> drawQuestion(Ui& ui, bool copy);

    std::string name_;
    std::string problem_;  ///< why the last name was rejected
};

}  // namespace plumb::editor::ui
