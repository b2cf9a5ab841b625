#pragma once

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

    std::vector<Backup> backups_;
    bool recovering_ = false;
    bool later_ = false;  ///< Esc: asked again when the project is opened the next time
};

}  // namespace plumb::editor::ui
