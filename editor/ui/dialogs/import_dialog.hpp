#pragma once

#include <optional>
#include <string>

#include "editor/model/assets/import_task.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Chooses a file of Tiled, LDtk or Aseprite, brings it in, and tells what came of it.
class ImportDialog {
public:
    /// Opens by itself when the workspace asks for it.
    void draw(Ui& ui);

private:
    void begin(Ui& ui);
    void drawChooser(Ui& ui);
    void drawList(Ui& ui);
    void drawTarget(Ui& ui);
    void import(Ui& ui);
    void drawReport(Ui& ui, const ImportReport& report);

    std::optional<ImportTask> task_;
    std::string place_;
    std::string missing_;
};

/// Opens a scene, unless that would cost changes that are not saved: then it says so.
void openSceneOrSay(Ui& ui, const std::string& path);

}  // namespace plumb::editor::ui
