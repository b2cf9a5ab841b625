#pragma once

#include <string>
#include <vector>

#include "editor/ui/ui.hpp"
#include "editor/ui/widgets/dialog.hpp"

namespace plumb::editor::ui {

/// Questions about work that might be lost: after a crash, and when another program changed the open file;
/// and the list of what the scene was before.
class SafetyDialogs {
public:
    void draw(Ui& ui);
    void chooseBackup(Ui& ui);

private:
    /// What a person is asked; one question at a time.
    enum class Question : unsigned char { None, Recovery, Changed };

    /// Opens the next question when no other dialog is open, and notices when one was closed unanswered.
    void ask(Ui& ui);
    [[nodiscard]] Question nextQuestion(Ui& ui) const;
    void drawRecovery(Ui& ui);
    bool drawLost(Ui& ui, std::size_t index);
    void drawChanged(Ui& ui);
    void drawNotSaved(Ui& ui);
    void drawBackups(Ui& ui);

    /// What differs between two texts of a scene, in a list that stays until the question is answered.
    void compare(std::string_view file, std::string_view other);
    void drawDifferences(Ui& ui, const char* path) const;

    std::vector<Backup> backups_;
    std::vector<std::string> differences_;  ///< empty until they were asked for
    LastingQuestion notSaved_{"Not saved"};
    Question open_ = Question::None;  ///< on the screen
    bool later_ = false;    ///< the recovery is asked for again when the project is opened the next time
    bool waits_ = false;    ///< which file to keep is asked again when the scene is saved
    bool refused_ = false;  ///< the scene could not be saved: the question comes also while a game plays
};

}  // namespace plumb::editor::ui
