#include "editor/model/assets/import_task.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "editor/model/assets/asset_catalog.hpp"
#include "editor/model/commands/write_asset.hpp"
#include "editor/model/input/key_words.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor {
namespace {

std::string lowerCase(std::string text) {
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

}  // namespace

bool ImportTask::goTo(const Path& path) {
    std::error_code ignored;
    const Path whole = std::filesystem::absolute(path, ignored).lexically_normal();
    if (std::filesystem::is_directory(whole, ignored)) {
        folder_ = whole;
        file_.clear();
        kind_ = ImportKind::None;
    } else if (std::filesystem::is_regular_file(whole, ignored)) {
        folder_ = whole.parent_path();
        file_ = whole;
        kind_ = importKindOf(file_);
        target = importTarget(file_, kind_, project_).lexically_relative(project_).generic_string();
    } else {
        return false;
    }
    problem_.clear();
    list();
    return true;
}

void ImportTask::list() {
    rows_.clear();
    std::error_code failed;
    std::filesystem::directory_iterator at{folder_, failed};
    for (; !failed && at != std::filesystem::directory_iterator{}; at.increment(failed)) {
        std::string name = at->path().filename().string();
        const bool folder = at->is_directory(failed);
        if (!startsWith(name, ".") && (folder || mayBeImported(at->path())))
            rows_.push_back({std::move(name), folder});
    }
    std::sort(rows_.begin(), rows_.end(), [](const ImportRow& a, const ImportRow& b) {
        return a.folder != b.folder ? a.folder : lowerCase(a.name) < lowerCase(b.name);
    });
}

std::string_view ImportTask::kind() const {
    switch (kind_) {
        case ImportKind::TiledMap: return "Tiled map";
        case ImportKind::TiledWorld: return "Tiled world";
        case ImportKind::Ldtk: return "LDtk project";
        case ImportKind::Aseprite: return "Aseprite sheet";
        case ImportKind::None: break;
    }
    return {};
}

bool ImportTask::replaces() const {
    const Result<Path> path = pathInside(project_, target);
    std::error_code ignored;
    return path && std::filesystem::exists(*path, ignored);
}

bool ImportTask::run() {
    report_.reset();
    problem_.clear();
    const Result<Path> path = pathInside(project_, target);
    Result<ImportReport> done =
        path ? importFile(file_, *path, project_) : Result<ImportReport>{path.error()};
    if (done) {
        report_ = *std::move(done);
    } else {
        problem_ = done.error().text();
    }
    return report_.has_value();
}

void ImportTask::again() {
    report_.reset();
    problem_.clear();
    list();
}

void addDroppedFile(Workspace& workspace, const std::string& file) {
    if (mayBeImported(file)) {
        workspace.importFrom = file;
        workspace.request = WindowRequest::Import;
        return;
    }
    const std::string name = Path{file}.filename().string();
    if (assetKindOf(name) == AssetKind::None) {
        workspace.notice = format("{} is not a file type that games can load", name);
        return;
    }
    if (!workspace.canEdit()) {
        workspace.notice = format("Stop the game to add {} ({})", name, keysFor(workspace, "run.play"));
        return;
    }
    const Result<std::string> bytes = readFile(file);
    if (!bytes) {
        workspace.notice = bytes.error().text();
        return;
    }
    const std::string path = "assets/" + name;
    std::error_code ignored;
    if (std::filesystem::exists(workspace.project.root / path, ignored)) {
        workspace.notice = format("{} already exists; rename one of the files", path);
        return;
    }
    workspace.undo.endGesture();
    workspace.undo.push(std::make_unique<WriteAsset>(format("add file {}", name), workspace.project.root,
                                                     workspace.assets, path, *bytes));
    workspace.undo.endGesture();
    workspace.notice = format("Added {}", path);
}

}  // namespace plumb::editor
