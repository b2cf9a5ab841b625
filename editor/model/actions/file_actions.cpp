#include <array>

#include "editor/model/actions/action_rows.hpp"
#include "editor/model/document/prefab_file.hpp"

namespace plumb::editor {
namespace {

/// True also while a game runs, since the game plays a copy of the scene.
bool hasScene(const Workspace& w) { return !w.document.scenePath.empty(); }

const std::array kRows{
    Action{"file.new",
           "File",
           "New scene...",
           {Key::N, true, false, true},
           always,
           ask<WindowRequest::NameNewScene>},
    Action{"file.open", "File", "Open scene...", control(Key::O), always, ask<WindowRequest::ChooseScene>},
    Action{"file.save", "File", "Save", control(Key::S), hasScene,
           [](Workspace& w) { static_cast<void>(w.save().ok()); }},
    Action{"file.saveAs", "File", "Save as...", control(Key::S, true),
           [](const Workspace& w) { return editable(w) && !isPrefabFile(w.document.scenePath); },
           ask<WindowRequest::NameSceneCopy>},
    Action{"file.backups",
           "File",
           "Backups of this scene...",
           {Key::B, true, false, true},
           editable,
           ask<WindowRequest::ChooseBackup>},
    line("File"),
    Action{"file.import", "File", "Import...", control(Key::I, true), always, ask<WindowRequest::Import>},
    Action{"file.export", "File", "Export...", {}, always, ask<WindowRequest::Export>},
    line("File"),
    Action{"file.welcome", "File", "Projects...", control(Key::O, true), always, ask<WindowRequest::Welcome>},
    line("File"),
    Action{"file.quit", "File", "Quit", control(Key::Q), always, ask<WindowRequest::Quit>},
};

}  // namespace

std::span<const Action> fileActions() { return kRows; }

}  // namespace plumb::editor
