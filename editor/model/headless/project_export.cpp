#include "editor/model/headless/project_export.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <system_error>
#include <utility>

#include "app/player.hpp"
#include "codec/pack.hpp"
#include "core/text.hpp"
#include "editor/model/headless/export_folder.hpp"
#include "platform/paths.hpp"

namespace plumb::editor {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> kNotOfGames{"templates/", "tools/"};  // in the engine's assets
constexpr std::string_view kPage = "index.html";
constexpr const char* kIcon = "icon.png";
constexpr std::size_t kNamed = 5;  // files in the report

using Files = std::vector<std::pair<std::string, std::string>>;

/// The files of a folder that are neither hidden nor what a killed writeFile() left.
/// @param leftOut  starts of paths that are not listed
/// @error a folder cannot be read; a link to a folder, which may lead anywhere
Result<std::vector<std::string>> filesFor(const Path& folder, std::span<const std::string_view> leftOut) {
    std::vector<std::string> files;
    std::error_code failed, none;
    for (fs::recursive_directory_iterator at{folder, failed}, end; !failed && at != end;
         at.increment(failed)) {
        const std::string name = at->path().filename().string();
        const bool isFolder = at->is_directory(none);
        std::string path = at->path().lexically_relative(folder).generic_string();
        const std::string whole = isFolder ? path + "/" : path;
        const bool isLeftOut = std::any_of(leftOut.begin(), leftOut.end(),
                                           [&](std::string_view start) { return startsWith(whole, start); });
        if (isLeftOut || startsWith(name, ".") || endsWith(name, ".tmp~")) {
            at.disable_recursion_pending();
        } else if (!isFolder) {
            files.push_back(std::move(path));
        } else if (at->is_symlink(none)) {
            return Error{path, "this is a link to a folder, which exports do not follow",
                         "put the folder itself there, or leave it out with export.leaveOut"};
        }
    }
    if (failed)
        return Error{folder.generic_string(), failed.message(), "check the permissions of its folders"};
    return files;
}

/// Adds the files of filesFor().
/// @error one that cannot be read or whose path a pack cannot have
Result<Done> addFiles(Files& files, const Path& from, const std::string& to,
                      std::span<const std::string_view> leftOut) {
    const Result<std::vector<std::string>> found = filesFor(from, leftOut);
    if (!found) return found.error();
    for (const std::string& file : *found) {
        std::string path = to + "/" + file;
        if (const std::string why = whyPathRefused(path); !why.empty())
            return Error{file, "the path " + why, "rename it, or leave it out with export.leaveOut"};
        Result<std::string> bytes = readFile(from / file);
        if (!bytes) return bytes.error();
        files.emplace_back(std::move(path), std::move(*bytes));
    }
    return Done{};
}

Result<Files> filesOf(const Project& project, const Path& engineAssets) {
    std::vector<std::string_view> leftOut{"code/"};  // the player contains it
    leftOut.insert(leftOut.end(), project.leftOut.begin(), project.leftOut.end());
    Files files;
    if (Result<Done> done = addFiles(files, project.root, std::string{kGameFolder}, leftOut); !done)
        return done.error();
    if (Result<Done> done = addFiles(files, engineAssets, "assets", kNotOfGames); !done) return done.error();
    return files;
}

std::vector<std::string> largestOf(const Files& files) {
    std::vector<std::pair<std::size_t, std::string>> sizes;
    for (const auto& [path, bytes] : files) sizes.emplace_back(bytes.size(), path);
    std::sort(sizes.rbegin(), sizes.rend());
    sizes.resize(std::min(sizes.size(), kNamed));
    std::vector<std::string> lines;
    for (const auto& [size, path] : sizes)
        lines.push_back(format("{}, {} MB", path, fixedText(static_cast<double>(size) / 1e6, 2)));
    return lines;
}

/// The texts of all libraries, one after the other.
Result<std::string> licencesIn(const Path& folder) {
    std::string text;
    for (const std::string& file : filesBelow(folder, ".txt")) {
        Result<std::string> one = readFile(folder / file);
        if (!one) return one.error();
        const std::string name = file.substr(0, file.size() - 4);
        text += format("{}\n{}\n\n{}\n\n\n", name, std::string(name.size(), '='), trimmed(*one));
    }
    return text;
}

std::string htmlText(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '&' || c == '<' || c == '>' || c == '"') {
            out += format("&#{};", static_cast<int>(c));
        } else {
            out += c;
        }
    }
    return out;
}

/// The page of the player with the name and the icon of the game.
std::string withProject(std::string page, const Project& project) {
    const std::pair<std::string_view, std::string> values[] = {
        {"{{NAME}}", htmlText(project.name)}, {"{{ICON}}", project.icon.empty() ? "data:," : kIcon}};
    for (const auto& [mark, value] : values) {
        for (std::size_t at = page.find(mark); at != std::string::npos;
             at = page.find(mark, at + value.size()))
            page.replace(at, mark.size(), value);
    }
    return page;
}

Result<Done> copyFile(const Path& from, const Path& to) {
    std::error_code failed;
    fs::create_directories(to.parent_path(), failed);
    if (!failed) fs::copy_file(from, to, fs::copy_options::overwrite_existing, failed);
    if (!failed) return Done{};
    return Error{to.generic_string(), failed.message(), "check the free disk space and the write permission"};
}

/// Copies all files of a folder.
Result<Done> copyFiles(const Path& from, const Path& to) {
    for (const std::string& file : filesBelow(from, "")) {
        if (Result<Done> copied = copyFile(from / file, to / file); !copied) return copied;
    }
    return Done{};
}

Result<Done> copyIcon(const Project& project, const Path& folder) {
    if (project.icon.empty()) return Done{};
    const Result<Path> icon = pathInside(project.root, project.icon);
    return icon ? copyFile(*icon, folder / kIcon) : icon.error();
}

/// What desktops on Linux show as the game. The program is beside it, wherever that is (%k).
/// Source: freedesktop.org, "Desktop Entry Specification" 1.5, for the two levels of quoting
std::string desktopEntry(const Project& project, std::string_view program) {
    std::string name, argument;
    for (const char c : project.name) {
        if (static_cast<unsigned char>(c) < 32) continue;
        if (c == '\\') name += '\\';
        name += c;
    }
    for (const char c : program) {
        if (c == '$' || c == '`') argument += "\\\\";
        if (c == '%') argument += '%';
        argument += c;
    }
    return format(
        "[Desktop Entry]\nType=Application\nName={}\nIcon={}\nCategories=Game;\n"
        "Exec=sh -c \"exec \\\\\"\\\\$(dirname \\\\\"\\\\$1\\\\\")/\\\\$2\\\\\"\" sh %k \"{}\"\n",
        name, program, argument);
}

/// Copies the program and what a desktop shows of it. @return what starts the game
Result<std::string> copyProgram(const Project& project, const Path& player, const Path& folder) {
    std::string name = fileNameOf(project.name) + player.extension().string();
    if (Result<Done> copied = copyFile(player, folder / name); !copied) return copied.error();
    if (player.has_extension()) return name;  // the program for Windows contains its icon
    const Path entry = folder / (name + ".desktop");
    if (Result<Done> done = writeFile(entry, desktopEntry(project, name)); !done) return done.error();
    std::error_code failed;
    fs::permissions(entry, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                    fs::perm_options::add, failed);  // desktops open others as a text
    if (Result<Done> copied = copyIcon(project, folder); !copied) return copied.error();
    return name;
}

/// Copies all files of the page. @return what starts the game
Result<std::string> copyPage(const Project& project, const Path& player, const Path& folder) {
    const Result<std::string> page = readFile(player / kPage);
    if (!page) return page.error();
    if (Result<Done> copied = copyFiles(player, folder); !copied) return copied.error();
    if (Result<Done> written = writeFile(folder / kPage, withProject(*page, project)); !written)
        return written.error();
    if (Result<Done> copied = copyIcon(project, folder); !copied) return copied.error();
    return std::string{kPage};
}

Result<ExportReport> exportTo(const Project& project, const Path& folder, const ExportParts& parts) {
    const Result<Files> files = filesOf(project, parts.engineAssets);
    if (!files) return files.error();
    ExportReport report;
    report.files = files->size();
    report.largest = largestOf(*files);
    if (Result<Done> done = writeFile(folder / kPackName, writePack(*files)); !done) return done.error();
    std::error_code ignored;
    Result<std::string> program = fs::is_directory(parts.player, ignored)
                                      ? copyPage(project, parts.player, folder)
                                      : copyProgram(project, parts.player, folder);
    if (!program) return program.error();
    report.program = std::move(*program);
    if (!parts.licences.empty()) {
        const Result<std::string> text = licencesIn(parts.licences);
        if (!text) return text.error();
        if (Result<Done> done = writeFile(folder / "licences.txt", *text); !done) return done.error();
    }
    for (const std::string& file : filesBelow(folder, ""))
        report.bytes += fs::file_size(folder / file, ignored);
    return report;
}

/// Has an empty folder filled, and places what is in it then, or after an error nothing.
/// @param fill  Result<Done>(const Path& folder)
/// @return the paths of all files, sorted
template <class Fill>
Result<std::vector<std::string>> fillAndPlace(const Project& project, const Path& wanted, const Fill& fill) {
    Result<ExportFolder> folder = ExportFolder::check(project, wanted);
    if (!folder) return folder.error();
    const Result<Path> stage = folder->stage();
    const Result<Done> filled = stage ? fill(*stage) : Result<Done>{stage.error()};
    Result<std::vector<std::string>> placed =
        filled ? folder->place() : Result<std::vector<std::string>>{filled.error()};
    folder->clear();
    return placed;
}

}  // namespace

Result<ExportReport> exportProject(const Project& project, const Path& folder, const ExportParts& parts) {
    std::error_code ignored;
    if (!fs::exists(parts.player, ignored))
        return Error{parts.player.generic_string(), "there is no player",
                     "build it: ./plumb export builds it first"};
    ExportReport report;
    Result<std::vector<std::string>> placed =
        fillAndPlace(project, folder, [&](const Path& stage) -> Result<Done> {
            Result<ExportReport> made = exportTo(project, stage, parts);
            if (!made) return made.error();
            report = *std::move(made);
            return Done{};
        });
    if (!placed) return placed.error();
    report.written = *std::move(placed);
    return report;
}

Result<Done> placeExport(const Project& project, const Path& finished, const Path& folder) {
    const Result<std::vector<std::string>> placed =
        fillAndPlace(project, folder, [&](const Path& stage) { return copyFiles(finished, stage); });
    return placed ? Result<Done>{Done{}} : placed.error();
}

}  // namespace plumb::editor
