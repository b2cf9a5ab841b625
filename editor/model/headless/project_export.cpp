#include "editor/model/headless/project_export.hpp"

#include <system_error>

#include "core/text.hpp"
#include "editor/model/assets/asset_catalog.hpp"

namespace plumb::editor {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kScript = R"sh(#!/bin/sh
here=$(cd "$(dirname "$0")" && pwd)
exec "$here/plumb-player" "$here/game" "$@"
)sh";
constexpr std::string_view kBatch = "@\"%~dp0plumb-player.exe\" \"%~dp0game\" %*\r\n";

/// Copies files and counts them; remembers the first thing that went wrong.
class Copier {
public:
    explicit Copier(ExportReport& report) : report_{report} {}

    void copy(const Path& from, const Path& to) {
        if (failed_) return;
        fs::create_directories(to.parent_path(), failed_);
        if (!failed_) fs::copy_file(from, to, fs::copy_options::overwrite_existing, failed_);
        if (failed_) place_ = to;
        ++report_.files;
        std::error_code ignored;
        report_.bytes += fs::file_size(to, ignored);
    }
    /// All files of a folder that are not hidden.
    void copyAll(const Path& from, const Path& to) {
        AssetCatalog catalog{from};
        catalog.refresh();
        for (const AssetItem& file : catalog.all()) {
            if (!file.folder) copy(from / file.path, to / file.path);
        }
    }
    [[nodiscard]] Result<Done> result() const {
        if (!failed_) return Done{};
        return Error{place_.generic_string(), failed_.message(),
                     "look whether there is room, and leave to write"};
    }

private:
    ExportReport& report_;
    std::error_code failed_;
    Path place_;
};

bool lies(const Path& inner, const Path& outer) {
    const Path way = fs::weakly_canonical(inner).lexically_relative(fs::weakly_canonical(outer));
    return !way.empty() && *way.begin() != "..";
}

Result<Done> checkTarget(const Path& project, const Path& folder) {
    const std::string name = folder.generic_string();
    if (lies(folder, project))
        return Error{name, "this is inside the project", "choose a folder outside of it"};
    if (lies(project, folder)) return Error{name, "the project is inside of it", "choose another folder"};
    std::error_code none;
    if (!fs::exists(folder, none)) return Done{};
    if (!fs::is_directory(folder, none)) return Error{name, "this is a file", "choose a folder"};
    if (fs::is_empty(folder, none) || fs::exists(folder / "game/project.json", none)) return Done{};
    return Error{name, "there are other things in this folder", "choose an empty one"};
}

Result<Done> writeScript(const Path& folder, bool windows) {
    const Path file = folder / (windows ? "play.bat" : "play");
    if (Result<Done> written = writeFile(file, windows ? kBatch : kScript); !written) return written;
    std::error_code ignored;
    fs::permissions(file, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                    fs::perm_options::add, ignored);
    return Done{};
}

/// Puts a finished folder where it belongs; what was there goes last.
Result<Done> replace(const Path& made, const Path& folder) {
    const Path before = Path{made}.concat(".before");
    std::error_code failed, ignored;
    if (fs::exists(folder, ignored)) fs::rename(folder, before, failed);
    if (!failed) fs::rename(made, folder, failed);
    if (failed) return Error{folder.generic_string(), failed.message(), "is a program using it?"};
    fs::remove_all(before, ignored);
    return Done{};
}

}  // namespace

Result<ExportReport> exportProject(const Path& project, const Path& wanted, const ExportParts& parts) {
    const Path folder = fs::absolute(wanted).lexically_normal();
    const Path target = folder.has_filename() ? folder : folder.parent_path();
    if (const Result<Done> good = checkTarget(project, target); !good) return good.error();
    std::error_code ignored;
    const Path made = target.parent_path() / format(".{}.export", target.filename().string());
    fs::remove_all(made, ignored);
    fs::remove_all(Path{made}.concat(".before"), ignored);

    ExportReport report;
    Copier copier{report};
    copier.copyAll(project, made / "game");
    copier.copyAll(parts.engineAssets, made / "assets");
    report.runnable = !parts.player.empty() && fs::is_regular_file(parts.player, ignored);
    if (report.runnable) copier.copy(parts.player, made / parts.player.filename());
    Result<Done> done = copier.result();
    if (done && report.runnable) done = writeScript(made, parts.player.extension() == ".exe");
    if (done) done = replace(made, target);
    if (done) return report;
    fs::remove_all(made, ignored);
    return done.error();
}

}  // namespace plumb::editor
