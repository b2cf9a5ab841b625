#pragma once

#include <optional>
#include <string>

#include "editor/model/assets/import_task.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The dialog that imports a file of Tiled, LDtk or Aseprite and shows a report.
class ImportDialog {
public:
    /// Draws the dialog, if it is open. Opens it if Workspace::request is WindowRequest::Import.
    void draw(Ui& ui);

private:
    void begin(Ui& ui);
    void drawChooser(Ui& ui);
    void drawList(Ui& ui);
    void drawTarget(Ui& ui);
    void import(Ui& ui);
    void drawReport(Ui& ui, const ImportReport& report);

    std::optional<ImportTask> task_;
    std::string place_;    ///< text of the input field for the path of a folder or file
    std::string missing_;  ///< error message if `place_` does not exist
};

/// Opens the scene at `path`. If the open scene has unsaved changes, only shows a notice to save it first.
void openSceneOrSay(Ui& ui, const std::string& path);

}  // namespace plumb::editor::ui
