#include "editor/templates/project_templates.hpp"

#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "platform/paths.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"

namespace plumb::editor {
namespace {

// Parts of the platformer's and of the physics playground's assets.
constexpr std::array<std::string_view, 19> kTopDownAssets{
    "CREDITS.md",   "cave.png",       "cave.tileset.json",  "player.png",    "player.anim.json",
    "gloomcap.png", "bob.png",        "gloomcap.anim.json", "bob.anim.json", "lamp.png",
    "gate.png",     "gate.anim.json", "lamp_lit.anim.json", "light.png",     "light_big.png",
    "coin.wav",     "hurt.wav",       "checkpoint.wav",     "goal.wav"};
constexpr std::array<std::string_view, 8> kSandboxAssets{"CREDITS.md", "ball.png", "box.png",   "capsule.png",
                                                         "disc.png",   "ring.png", "blast.wav", "step.wav"};

constexpr std::array kTemplates{
    ProjectTemplate{"empty", "Empty", "One scene with a camera.", "", ""},
    ProjectTemplate{"cpp", "Game with C++ code", "Components in C++, rebuilt while you play.", "", "cpp"},
    ProjectTemplate{"lua", "Game with Lua scripts", "A player, coins and a score in Lua.", "", "lua"},
    ProjectTemplate{"topdown", "Top-down game", "A crypt seen from above: coins, enemies.", "platformer",
                    "topdown", kTopDownAssets},
    ProjectTemplate{"physics", "Physics sandbox", "A car, a seesaw, a stack; the mouse drags.",
                    "physics-playground", "physics", kSandboxAssets},
    ProjectTemplate{"kit", "Platformer kit", "The tutorial's parts and an empty level.", "platformer",
                    "platformer-kit"},
    ProjectTemplate{"platformer", "Platformer", "A copy of Wickwood: four levels to modify.", "platformer",
                    ""}};

constexpr std::string_view kFirstScene = R"({
  "format": 1,
  "effects": {},
  "layers": [],
  "entities": [
    {
      "id": "0000000000000001",
      "name": "camera",
      "components": {
        "Transform": {
          "position": [320, 180]
        },
        "Camera": {}
      }
    }
  ]
}
)";

std::string emptyProject(std::string_view name) {
    Json json = Json::object();
    json["name"] = std::string{name};
    json["version"] = "0.1.0";
    json["startScene"] = "scenes/level1.scene.json";
    json["window"] = {{"width", 1280}, {"height", 720}};
    json["resolution"] = {640, 360};
    return writeJson(json);
}

/// Copies a folder's content recursively. @param leftOut  names of files and folders in `from` to skip
Result<Done> copyFolder(const Path& from, const Path& to, std::span<const std::string_view> leftOut) {
    std::error_code failed;
    std::filesystem::create_directories(to, failed);
    for (const auto& entry : std::filesystem::directory_iterator{from, failed}) {
        const std::string name = entry.path().filename().string();
        if (std::find(leftOut.begin(), leftOut.end(), name) != leftOut.end()) continue;
        std::filesystem::copy(entry.path(), to / name, std::filesystem::copy_options::recursive, failed);
        if (failed) return Error{(to / name).string(), failed.message(), "choose another folder"};
    }
    return Done{};
}

Result<Done> rename(const Path& folder, std::string_view name) {
    const Result<std::string> text = readFile(folder / "project.json");
    if (!text) return text.error();
    Result<Json> json = parseJson(*text, "project.json");
    if (!json) return json.error();
    if (!json->is_object())
        return Error{(folder / "project.json").string(), "the template's project file is not a JSON object",
                     "reinstall Plumb"};
    (*json)["name"] = std::string{name};
    if (Json* window = findObject(*json, "window")) window->erase("title");
    return writeFile(folder / "project.json", writeJson(*json));
}

/// Copies the listed assets of a project. @param names  files in its folder `assets`
Result<Done> copyAssets(const Path& project, const Path& folder, std::span<const std::string_view> names) {
    std::error_code failed;
    std::filesystem::create_directories(folder / "assets", failed);
    for (const std::string_view name : names) {
        const Path to = folder / "assets" / name;
        std::filesystem::copy_file(project / "assets" / name, to, failed);
        if (failed) return Error{to.string(), failed.message(), "choose another folder, or reinstall Plumb"};
    }
    return Done{};
}

/// Copies a project that comes with the engine; its scenes are replaced if the template has its own.
Result<Done> copyProject(const ProjectTemplate& from, const Path& folder) {
    // Editor data, and the scripts that generated the images. The last two are replaced by the template.
    static constexpr std::array<std::string_view, 4> kLeftOut{".plumb", "art", "project.json", "scenes"};
    const std::span<const std::string_view> leftOut{kLeftOut};
    const Path source = engineProjects() / from.copyOf;
    const Path start = engineAssets() / "templates" / from.start;
    if (from.copyOf.empty()) return copyFolder(start, folder, {});
    if (from.start.empty()) return copyFolder(source, folder, leftOut.first(2));
    const Result<Done> copied =
        from.assets.empty() ? copyFolder(source, folder, leftOut) : copyAssets(source, folder, from.assets);
    return copied ? copyFolder(start, folder, {}) : copied;
}

Result<Done> makeEmpty(const Path& folder, std::string_view name) {
    std::error_code failed;
    for (const char* part : {"assets", "prefabs"}) std::filesystem::create_directories(folder / part, failed);
    const Result<Done> scene = writeFile(folder / "scenes/level1.scene.json", kFirstScene);
    return scene ? writeFile(folder / "project.json", emptyProject(name)) : scene;
}

}  // namespace

std::span<const ProjectTemplate> projectTemplates() { return kTemplates; }

const ProjectTemplate* findTemplate(std::string_view id) {
    const auto found = std::find_if(kTemplates.begin(), kTemplates.end(),
                                    [&](const ProjectTemplate& row) { return row.id == id; });
    return found == kTemplates.end() ? nullptr : &*found;
}

Path engineProjects() {
    std::error_code failed;
    const Path folder = engineAssets().parent_path() / "projects";
    return std::filesystem::is_directory(folder, failed) ? folder : Path{};
}

bool isHere(const ProjectTemplate& row) {
    if (!row.copyOf.empty() && !isProject(engineProjects() / row.copyOf)) return false;
    return row.start.empty() || isProject(engineAssets() / "templates" / row.start);
}

std::string folderNameFor(std::string_view name) {
    std::string folder;
    for (const char letter : trimmed(name)) {
        const bool upper = letter >= 'A' && letter <= 'Z';
        const bool plain = upper || (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') ||
                           static_cast<unsigned char>(letter) >= 0x80;
        if (plain) {
            folder += upper ? static_cast<char>(letter + 32) : letter;
        } else if (!folder.empty() && folder.back() != '-') {
            folder += '-';
        }
    }
    while (!folder.empty() && folder.back() == '-') folder.pop_back();
    return folder;
}

Result<Path> createProject(const ProjectTemplate& from, std::string_view name, const Path& folder) {
    std::error_code failed;
    if (trimmed(name).empty())
        return Error{"New project", "the project has no name", "enter one, e.g. \"My Game\""};
    if (folder.empty() || !folder.is_absolute())
        return Error{folder.string(), "the path is not absolute",
                     "enter one that starts at the root, e.g. /home/me/game"};
    if (std::filesystem::exists(folder, failed) &&
        (!std::filesystem::is_directory(folder, failed) || !std::filesystem::is_empty(folder, failed)))
        return Error{folder.string(), "a file or a non-empty folder already exists there",
                     "choose an empty folder, or another name"};
    if (!isHere(from))
        return Error{std::string{from.name}, "the template is not installed with this program",
                     "start from the template \"Empty\""};
    const bool isEmpty = from.copyOf.empty() && from.start.empty();
    Result<Done> made = isEmpty ? makeEmpty(folder, trimmed(name)) : copyProject(from, folder);
    if (made && !isEmpty) made = rename(folder, trimmed(name));
    if (!made) return made.error();
    return folder;
}

bool isProject(const Path& folder) {
    std::error_code failed;
    return std::filesystem::is_regular_file(folder / "project.json", failed);
}

std::string projectNameOf(const Path& folder) {
    const Result<std::string> text = readFile(folder / "project.json");
    if (text) {
        const Result<Json> json = parseJson(*text, "project.json");
        if (const std::string* name = json ? findText(*json, "name") : nullptr) return *name;
    }
    return folder.filename().string();
}

Path projectPicture(const Path& folder) { return folder / ".plumb/picture.png"; }

}  // namespace plumb::editor
