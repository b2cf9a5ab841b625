#pragma once

#include <string>

#include "editor/model/project/export_task.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The dialog that exports the project as a game that runs without the editor, and shows the result.
class ExportDialog {
public:
    /// Draws the dialog, if it is open. Opens it on WindowRequest::Export.
    void draw(Ui& ui);

private:
    void poll(Ui& ui);
    void drawQuestion(Ui& ui);
    void drawTargets(Ui& ui);
    void drawResult(Ui& ui);
    void start(Ui& ui);
    void openFolder(Ui& ui);
    [[nodiscard]] const ExportTarget& target() const { return exportTargets()[target_]; }

    ExportTask task_;
    std::size_t target_ = 0;  ///< index in exportTargets()
    std::string folder_;      ///< text of the input field
    double started_ = 0.0;    ///< s, of ImGui's clock
    std::string report_;      ///< what the last export printed; empty: none yet
    bool failed_ = false;
};

}  // namespace plumb::editor::ui
