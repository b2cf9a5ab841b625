#include "editor/model/headless/project_export.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <system_error>

#include "core/text.hpp"
#include "editor/model/assets/asset_catalog.hpp"

namespace plumb::editor {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kScript = R"sh(#!/bin/sh
file=$0
while [ -L "$file" ]; do  # called through a link; readlink -f, which follows all, is missing on older macOS
    target=$(readlink "$file")
    case $target in
        /*) file=$target ;;
        *) file=$(dirname "$file")/$target ;;
    esac
done
here=$(dirname "$file")
exec "$here/plumb-player" "$here/game" "$@"
)sh";
constexpr std::array<std::string_view, 1> kNotOfTheGame{"code/"};  // the player contains it
constexpr std::array<std::string_view, 2> kNotOfGames{"templates/", "tools/"};
constexpr std::string_view kBatch = "@\"%~dp0plumb-player.exe\" \"%~dp0game\" %*\r\n";

/// Copies and counts files until the first error, which it stores.
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
    /// Copies all files of a folder that are not hidden.
    /// @param leftOut  files whose path starts with one of these are not copied
    void copyAll(const Path& from, const Path& to, std::span<const std::string_view> leftOut) {
        const auto isLeftOut = [&](std::string_view path) {
            return std::any_of(leftOut.begin(), leftOut.end(),
                               [&](std::string_view start) { return startsWith(path, start); });
        };
        AssetCatalog catalog{from};
        catalog.refresh();
        for (const AssetItem& file : catalog.all()) {
            if (!file.folder && !isLeftOut(file.path)) copy(from / file.path, to / file.path);
        }
    }
    [[nodiscard]] Result<Done> result() const {
        if (!failed_) return Done{};
        return Error{place_.generic_string(), failed_.message(),
                     "check the free disk space and the write permission"};
    }

private:
    ExportReport& report_;
    std::error_code failed_;
    Path place_;
};

bool isBelow(const Path& inner, const Path& outer) {
    const Path relative = fs::weakly_canonical(inner).lexically_relative(fs::weakly_canonical(outer));
    return !relative.empty() && *relative.begin() != "..";
}

Result<Done> checkTarget(const Path& project, const Path& folder) {
    const std::string name = folder.generic_string();
    if (isBelow(folder, project))
        return Error{name, "the folder is inside the project", "choose a folder outside the project"};
    if (isBelow(project, folder))
        return Error{name, "the folder contains the project", "choose another folder"};
    std::error_code none;
    if (!fs::exists(folder, none)) return Done{};
    if (!fs::is_directory(folder, none))
        return Error{name, "this is a file, not a folder", "choose a folder"};
    if (fs::is_empty(folder, none) || fs::exists(folder / "game/project.json", none)) return Done{};
    return Error{name, "the folder has other content", "choose an empty folder"};
}

Result<Done> writeScript(const Path& folder, bool windows) {
    const Path file = folder / (windows ? "play.bat" : "play");
    if (Result<Done> written = writeFile(file, windows ? kBatch : kScript); !written) return written;
    std::error_code ignored;
    fs::permissions(file, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                    fs::perm_options::add, ignored);
    return Done{};
}

/// Moves the finished folder to its destination. The old content is removed only afterwards.
Result<Done> replace(const Path& made, const Path& folder) {
    const Path before = Path{made}.concat(".before");
    std::error_code failed, ignored;
    if (fs::exists(folder, ignored)) fs::rename(folder, before, failed);
    if (!failed) fs::rename(made, folder, failed);
    if (failed) return Error{folder.generic_string(), failed.message(), "close programs that use the folder"};
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
    copier.copyAll(project, made / "game", kNotOfTheGame);
    copier.copyAll(parts.engineAssets, made / "assets", kNotOfGames);
    report.runnable = !parts.player.empty() && fs::is_regular_file(parts.player, ignored);
    if (report.runnable)
        copier.copy(parts.player, made / ("plumb-player" + parts.player.extension().string()));
    Result<Done> done = copier.result();
    if (done && report.runnable) done = writeScript(made, parts.player.extension() == ".exe");
    if (done) done = replace(made, target);
    if (done) return report;
    fs::remove_all(made, ignored);
    return done.error();
}

}  // namespace plumb::editor
