#pragma once

#include <string>
#include <vector>

#include "editor/ui/ui.hpp"
#include "editor/ui/widgets/dialog.hpp"

namespace plumb::editor::ui {

/// The dialogs that prevent the loss of work: recovery after a crash, a file changed by another program, a
/// failed save, and the list of backups.
class SafetyDialogs {
public:
    void draw(Ui& ui);
    /// Opens the list of backups of the open scene.
    void chooseBackup(Ui& ui);

private:
    /// What the dialog asks: whether to recover unsaved work, or which version of a changed file to keep.
    enum class Question : unsigned char { None, Recovery, Changed };

    /// Opens the next question if no dialog is open; postpones a question that was closed unanswered.
    void ask(Ui& ui);
    [[nodiscard]] Question nextQuestion(Ui& ui) const;
    void drawRecovery(Ui& ui);
    bool drawLost(Ui& ui, std::size_t index);
    void drawChanged(Ui& ui);
    void drawNotSaved(Ui& ui);
    void drawBackups(Ui& ui);

    /// Stores in differences_ how two versions of a scene's text differ; the dialog lists this until the
    /// question is answered.
    void compare(std::string_view file, std::string_view other);
    void drawDifferences(Ui& ui, const char* path) const;

    std::vector<Backup> backups_;
    std::vector<std::string> differences_;  ///< lines of the comparison; empty until the user requests it
    LastingQuestion notSaved_{"Not saved"};
    Question open_ = Question::None;  ///< the shown question
    bool later_ = false;              ///< the recovery is postponed until the project is next opened
    bool waits_ = false;              ///< the question Changed is postponed until the next save
    bool refused_ = false;            ///< a save was refused, so the question is shown even while a game runs
};

}  // namespace plumb::editor::ui
