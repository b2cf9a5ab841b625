#include "editor/model/safety/safety_net.hpp"

#include "core/log.hpp"
#include "editor/model/safety/other_editors.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor {
namespace {

constexpr double kLookEvery = 1.0;  // s between two checks of the open file

}  // namespace

SafetyNet::SafetyNet(Workspace& workspace)
    : backups{workspace.project.root},
      workspace_{workspace},
      journal_{workspace.document.types(), workspace.project.root} {}

void SafetyNet::begin() {
    const bool others = !journal_.begun() && isOpenInAnEditor(workspace_.project.root);
    if (const Result<Done> begun = journal_.begin(); !begun) {
        logWarning("Editor", begun.error());
        return;
    }
    lost_ = journal_.lostWork();
    if (!others) return;
    workspace_.notice =
        "Another editor has this project open. If both change a scene, the last to save asks which version "
        "to keep.";
    logWarning("Editor", "{}", workspace_.notice);
}

void SafetyNet::update(double seconds) {
    now_ += seconds;
    journal_.update(workspace_.document, workspace_.undo, now_);
    if (!journal_.begun() || now_ - looked_ < kLookEvery) return;
    looked_ = now_;
    lookAtFile();
}

Result<Done> SafetyNet::restore(const Backup& backup) {
    const Result<std::string> text = readFile(backup.path);
    if (!text) return text.error();
    const Result<LoadReport> opened = workspace_.openText(workspace_.document.scenePath, *text);
    if (!opened) return opened.error();
    workspace_.notice = format("Restored the backup of {}; save it to keep it", backup.when);
    return Done{};
}

Result<Done> SafetyNet::recover(std::size_t index) {
    const LostWork work = lost_[index];
    const Result<LoadReport> opened = workspace_.openText(work.scene, work.text);
    if (!opened) return opened.error();
    workspace_.notice = format("Recovered {} as of {}; save it to keep it", work.scene, work.when);
    // A new journal is written before the old one is deleted, so that a crash in between loses nothing.
    journal_.update(workspace_.document, workspace_.undo, now_ + Journal::kSeconds);
    journal_.finish();
    std::error_code failed;
    std::filesystem::remove(work.journal, failed);
    lost_.erase(lost_.begin() + static_cast<std::ptrdiff_t>(index));
    return Done{};
}

void SafetyNet::discard(std::size_t index) {
    backups.keepText(lost_[index].scene, lost_[index].text);
    std::error_code failed;
    std::filesystem::remove(lost_[index].journal, failed);
    lost_.erase(lost_.begin() + static_cast<std::ptrdiff_t>(index));
}

void SafetyNet::lookAtFile() {
    onDisk_ = watch_.look();
    if (onDisk_ != FileWatch::State::Gone) return;
    watch_.forget();
    onDisk_ = FileWatch::State::Same;
    workspace_.undo.markUnsaved();
    workspace_.notice =
        format("The file {} was deleted; saving creates it again", workspace_.document.scenePath);
    logWarning("Editor", "{}", workspace_.notice);
}

void SafetyNet::takeTheirs() {
    keepUnsaved();
    static_cast<void>(workspace_.open(workspace_.document.scenePath).ok());
}

void SafetyNet::keepMine() {
    watch_.know(file());
    onDisk_ = FileWatch::State::Same;
    workspace_.undo.markUnsaved();
    workspace_.notice =
        "Your version is kept; saving overwrites the other one, which is added to the backups";
}

void SafetyNet::leaving() {
    keepUnsaved();
    journal_.forget();
}

void SafetyNet::opened() {
    if (workspace_.document.scenePath.empty()) {
        watch_.forget();
    } else {
        watch_.know(file());
    }
    onDisk_ = FileWatch::State::Same;
}

/// Writes the journal before the file is saved: if the program is killed while it writes the file, the
/// journal has the full text. A journal with the same text as the file is not offered for recovery. The
/// journal is written in another thread while the caller creates the text of the file; the caller must wait
/// with finish() before it writes the file.
void SafetyNet::saving() {
    journal_.finish();
    journal_.update(workspace_.document, workspace_.undo, now_ + Journal::kMostSeconds);
    backups.keep(workspace_.document.scenePath);
}

void SafetyNet::saved() {
    journal_.forget();
    opened();
}

/// Backs up unsaved changes, so that a wrong click on "Discard" loses nothing.
void SafetyNet::keepUnsaved() {
    if (!journal_.begun() || !workspace_.unsaved() || workspace_.document.scenePath.empty()) return;
    backups.keepText(workspace_.document.scenePath, workspace_.text());
}

Path SafetyNet::file() const { return workspace_.project.root / Path{workspace_.document.scenePath}; }

}  // namespace plumb::editor
