#pragma once

#include <string>
#include <vector>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Questions about work that might be lost: after a crash, and when another program changed the open file;
/// and the list of what the scene was before.
class SafetyDialogs {
public:
    void draw(Ui& ui);
    void chooseBackup(Ui& ui);

private:
    void drawRecovery(Ui& ui);
    void drawChanged(Ui& ui);
    void drawBackups(Ui& ui);

    /// What differs between two texts of a scene, in a list that stays until the question is answered.
    void compare(std::string_view file, std::string_view other);
    void drawDifferences(Ui& ui, const char* path) const;

    std::vector<Backup> backups_;
    std::vector<std::string> differences_;  ///< empty until they were asked for
    bool recovering_ = false;
    bool later_ = false;  ///< Esc: asked again when the project is opened the next time
};

}  // namespace plumb::editor::ui
