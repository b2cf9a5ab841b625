#include "editor/model/project/project_habits.hpp"

#include <array>
#include <optional>

#include "core/log.hpp"
#include "editor/model/safety/backups.hpp"
#include "editor/model/workspace.hpp"
#include "math/angle.hpp"
#include "reflect/json.hpp"
#include "reflect/json_fields.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"

namespace plumb::editor {
namespace {

constexpr std::array<std::string_view, 3> kSnapNames{"grid", "half grid", "pixels"};
constexpr const char* kGridFile = "grid.json";
constexpr const char* kBreakpointFile = "breakpoints.json";
constexpr const char* kRecentFile = "recent.json";
constexpr double kPause = 1.0;           // s: minimum time between two writes, e.g. while a color is dragged
constexpr float kLargestCell = 4096.0f;  // px: maximum cell size of the grid

Json toJson(const GridSettings& grid) {
    Json json = Json::object();
    json["size"] = {grid.size.x, grid.size.y};
    json["snap"] = grid.snap;
    json["to"] = kSnapNames[static_cast<std::size_t>(grid.to)];
    json["snapAngles"] = grid.snapAngles;
    json["angle"] = grid.angle;
    json["color"] = {grid.color.r, grid.color.g, grid.color.b, grid.color.a};
    return json;
}

/// Reads an array of `Count` numbers. @return false if its size is wrong or a number is outside [least, most]
template <std::size_t Count>
bool readNumbers(JsonFields& fields, const char* key, std::array<float, Count>& numbers, float least,
                 float most) {
    const Json* list = fields.array(key);
    if (list == nullptr || list->size() != Count) return false;
    for (std::size_t i = 0; i < Count; ++i) {
        const std::optional<float> number = floatOf((*list)[i]);
        if (!number || !(*number >= least && *number <= most)) return false;
        numbers[i] = *number;
    }
    return true;
}

GridSettings gridFrom(const Json& json, std::vector<Error>& problems) {
    GridSettings grid;
    JsonFields fields{json, "grid.json", problems};
    if (std::array<float, 2> size{}; readNumbers(fields, "size", size, 1.0f, kLargestCell))
        grid.size = {size[0], size[1]};
    grid.snap = fields.flag("snap", true);
    grid.to = static_cast<SnapTo>(fields.choice("to", 0, kSnapNames));
    grid.snapAngles = fields.flag("snapAngles", true);
    grid.angle =
        fields.number("angle", GridSettings::kSnapAngle, radiansFromDegrees(1.0f), radiansFromDegrees(90.0f));
    if (std::array<float, 4> parts{}; readNumbers(fields, "color", parts, 0.0f, 255.0f)) {
        const auto part = [&](std::size_t i) { return static_cast<std::uint8_t>(parts[i]); };
        grid.color = {part(0), part(1), part(2), part(3)};
    }
    return grid;
}

Path fileOf(const Workspace& workspace, const char* name) { return workspace.project.root / ".plumb" / name; }

/// Returns the JSON of a file; null if the file does not exist or cannot be read.
Json read(const Workspace& workspace, const char* name) {
    std::error_code failed;
    const Path file = fileOf(workspace, name);
    if (!std::filesystem::exists(file, failed)) return {};
    const Result<std::string> text = readFile(file);
    Result<Json> json = text ? parseJson(*text, name) : Result<Json>{text.error()};
    if (json) return *std::move(json);
    logWarning("Editor", json.error());
    return {};
}

void write(const Workspace& workspace, const char* name, const std::string& text) {
    makeEditorFolder(workspace.project.root);
    const Result<Done> written = writeFile(fileOf(workspace, name), text);
    if (!written) logWarning("Editor", written.error());
}

/// The content of grid.json, to detect changes. A resource of the document's world.
struct KeptGrid {
    std::string text;
    double waited = 0.0;  // s since the last comparison
};

}  // namespace

void readGrid(Workspace& workspace) {
    std::vector<Error> problems;
    const Json json = read(workspace, kGridFile);
    if (json.is_object()) workspace.grid = gridFrom(json, problems);
    for (const Error& problem : problems) logWarning("Editor", problem);
    // The file is not written until the user changes a setting.
    workspace.document.world.resource<KeptGrid>().text = writeJson(toJson(workspace.grid));
}

void updateGrid(Workspace& workspace, double seconds) {
    KeptGrid& kept = workspace.document.world.resource<KeptGrid>();
    kept.waited += seconds;
    if (kept.waited < kPause) return;
    kept.waited = 0.0;
    keepGrid(workspace);
}

void keepGrid(Workspace& workspace) {
    KeptGrid& kept = workspace.document.world.resource<KeptGrid>();
    std::string now = writeJson(toJson(workspace.grid));
    if (workspace.project.isNone || now == kept.text) return;
    kept.text = std::move(now);  // set before writing, so that a write error is reported only once
    write(workspace, kGridFile, kept.text);
}

void readBreakpoints(Workspace& workspace) {
    const Json json = read(workspace, kBreakpointFile);
    if (json.is_null()) return;
    std::vector<Error> problems;
    workspace.debugger.breakpoints = Breakpoints::fromJson(json, kBreakpointFile, problems);
    for (const Error& problem : problems) logWarning("Editor", problem);
    workspace.scripts.breakpointsKept();
}

void keepBreakpoints(const Workspace& workspace) {
    if (workspace.project.isNone) return;
    write(workspace, kBreakpointFile, writeJson(workspace.debugger.breakpoints.toJson()));
}

std::vector<std::string> recentChoices(const Workspace& workspace, std::size_t most) {
    std::vector<std::string> choices;
    const Json json = read(workspace, kRecentFile);
    if (!json.is_array()) return choices;
    for (const Json& choice : json) {
        if (const std::string* text = jsonText(choice); text != nullptr && choices.size() < most)
            choices.push_back(*text);
    }
    return choices;
}

void keepRecent(const Workspace& workspace, const std::vector<std::string>& choices) {
    if (!workspace.project.isNone) write(workspace, kRecentFile, writeJson(Json(choices)));
}

}  // namespace plumb::editor
