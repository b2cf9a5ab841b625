#include "editor/model/safety/journal.hpp"

#include <algorithm>
#include <utility>

#include "core/log.hpp"
#include "editor/model/safety/backups.hpp"
#include "editor/model/safety/file_times.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"

namespace plumb::editor {
namespace {

namespace fs = std::filesystem;

constexpr int kSessions = 16;  // maximum number of editors that have the project open at the same time
constexpr std::string_view kJournalEnding = ".journal";

/// The first line of a journal; the text of the scene follows.
std::string headerOf(std::string_view scene) {
    Json json = Json::object();
    json["journal"] = 1;
    json["scene"] = scene;
    return compactText(json) + "\n";
}

std::optional<LostWork> readJournal(const Path& path) {
    const Result<std::string> text = readFile(path);
    if (!text) return std::nullopt;
    const std::size_t line = text->find('\n');
    if (line == std::string::npos) return std::nullopt;
    const Result<Json> header = parseJson(std::string_view{*text}.substr(0, line), "journal");
    const std::string* scene = header ? findText(*header, "scene") : nullptr;
    if (scene == nullptr) return std::nullopt;
    return LostWork{*scene, text->substr(line + 1), whenWritten(path), path};
}

Path sessionFolder(const Path& project, int session) {
    return project / ".plumb" / ("session" + std::to_string(session));
}

}  // namespace

Journal::~Journal() {
    if (writer_) writer_->wait();
}

Result<Done> Journal::begin() {
    if (begun()) return Done{};
    makeEditorFolder(project_);
    // Prefers session folders without journals: those left by a crash must be kept until the user decides.
    for (const bool empty : {true, false}) {
        for (int session = 1; session <= kSessions && !lock_; ++session) {
            folder_ = sessionFolder(project_, session);
            if (empty && !filesBelow(folder_, kJournalEnding).empty()) continue;
            if (auto lock = FileLock::take(folder_ / "lock")) lock_.emplace(std::move(*lock));
        }
    }
    if (!lock_) {
        return Error{(project_ / ".plumb").generic_string(), "the journal cannot be written to this folder",
                     "make the folder writable; until then a crash loses unsaved changes"};
    }
    writer_.emplace(types_, project_);
    return Done{};
}

Path Journal::fileOf(std::string_view scene) const {
    std::string name{scene};
    std::replace(name.begin(), name.end(), '/', '+');
    return folder_ / (name + std::string{kJournalEnding});
}

void Journal::update(const Document& document, const UndoStack& undo, double now) {
    if (!begun()) return;
    if (const std::string problem = writer_->takeProblem();
        !problem.empty() && !std::exchange(reported_, true))
        logWarning("Editor", "The journal cannot be written, so a crash would lose unsaved changes: {}",
                   problem);
    if (scene_ != document.scenePath) {
        scene_ = document.scenePath;
        revision_ = document.sceneRevision - (undo.isSaved() ? 0 : 1);
        actions_ = 0;
    }
    const bool moved = std::exchange(step_, undo.size()) != undo.size();
    if (std::exchange(steps_, undo.total()) != undo.total() || moved) ++actions_;
    if (undo.isSaved()) {
        forget();
        revision_ = document.sceneRevision;
        return;
    }
    if (document.scenePath.empty() || revision_ == document.sceneRevision) return;
    const double ago = now - written_;
    if (actions_ < kActions && ago < kSeconds) return;
    if (writer_->busy()) {
        // Until the pending write is finished, a crash would lose its changes as well.
        if (actions_ < kActions && ago < kMostSeconds) return;
        writer_->wait();
    }
    write(document, now);
}

void Journal::write(const Document& document, double now) {
    file_ = fileOf(document.scenePath);
    writer_->write(document.world, document.scene, file_, headerOf(document.scenePath));
    revision_ = document.sceneRevision;
    written_ = now;
    actions_ = 0;
}

void Journal::forget() {
    if (file_.empty()) return;
    writer_->wait();
    std::error_code failed;
    fs::remove(std::exchange(file_, {}), failed);
    actions_ = 0;
}

void Journal::finish() {
    if (begun()) writer_->wait();
}

std::vector<LostWork> Journal::lostWork() const {
    std::vector<LostWork> found;
    for (int session = 1; session <= kSessions; ++session) {
        const Path folder = sessionFolder(project_, session);
        std::error_code failed;
        if (!fs::is_directory(folder, failed)) continue;
        // A locked folder belongs to another running editor.
        if (folder != folder_ && !FileLock::take(folder / "lock")) continue;
        for (const std::string& name : filesBelow(folder, kJournalEnding)) {
            if (folder / name == file_) continue;
            std::optional<LostWork> work = readJournal(folder / name);
            const Result<Path> file = work ? pathInside(project_, work->scene) : Result<Path>{Error{}};
            const Result<std::string> now = file ? readFile(*file) : Result<std::string>{Error{}};
            if (!file || (now && *now == work->text)) {
                fs::remove(folder / name, failed);
            } else {
                found.push_back(*std::move(work));
            }
        }
    }
    // Newest first: of two journals of one scene, the user probably wants the newer one.
    const auto writtenAt = [](const LostWork& work) {
        std::error_code none;
        return fs::last_write_time(work.journal, none);
    };
    std::stable_sort(found.begin(), found.end(),
                     [&](const LostWork& a, const LostWork& b) { return writtenAt(a) > writtenAt(b); });
    return found;
}

}  // namespace plumb::editor
