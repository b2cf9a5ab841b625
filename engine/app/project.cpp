#include "app/project.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/guarded.hpp"
#include "core/text.hpp"
#include "reflect/json.hpp"
#include "reflect/json_fields.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"
#include "scene/files/import_commit.hpp"

namespace plumb {
namespace {

constexpr std::array<std::pair<std::string_view, WindowScale>, 4> kScalings{
    {{"fit", WindowScale::Fit},
     {"integer", WindowScale::Integer},
     {"stretch", WindowScale::Stretch},
     {"fill", WindowScale::Fill}}};

/// Reads one JSON object of the file. An invalid value becomes a warning, and the default is kept.
class Reader {
public:
    Reader(const Json& json, std::string where, std::vector<Error>& warnings)
        : json_{json}, where_{std::move(where)}, warnings_{warnings} {}

    void text(std::string_view key, std::string& value) {
        if (const Json* found = find(key, "a string", "\"My Game\"", &Json::is_string))
            value = stringOrEmpty(*found);
    }
    void flag(std::string_view key, bool& value) {
        if (const Json* found = find(key, "true or false", "true", &Json::is_boolean))
            value = found->get<bool>();
    }
    void number(std::string_view key, float& value, float least, float most) {
        const Json* found = find(key, "a number", shortestText(value), &Json::is_number);
        if (found == nullptr) return;
        const std::optional<float> given = floatOf(*found);
        if (given && *given >= least && *given <= most) {
            value = *given;
        } else {
            warn(key, format("is {}, which is outside {}..{}", briefText(*found), least, most),
                 format("using {}", value));
        }
    }
    void size(std::string_view key, int& value) {
        auto given = static_cast<float>(value);
        number(key, given, 1.0f, 16384.0f);
        value = static_cast<int>(given);
    }
    void pair(std::string_view key, float& first, float& second) {
        const Json* found = find(key, "two numbers", "[320, 180]", &Json::is_array);
        if (found == nullptr) return;
        const bool two = found->size() == 2;
        const std::optional<float> one = two ? floatOf((*found)[0]) : std::nullopt;
        const std::optional<float> other = two ? floatOf((*found)[1]) : std::nullopt;
        if (one && other) {
            first = *one;
            second = *other;
        } else {
            warn(key, "expected two numbers", "write them as [320, 180]");
        }
    }
    /// @param example  of the value, for the remedy
    void names(std::string_view key, std::vector<std::string>& values, std::size_t most,
               const char* example) {
        const Json* found = find(key, "a list of names", example, &Json::is_array);
        if (found == nullptr) return;
        for (const Json& name : *found) {
            if (values.size() == most || !name.is_string()) {
                warn(key,
                     values.size() == most ? format("has more than {} names", most)
                                           : format("expected a string, found {}", name.type_name()),
                     format("write e.g. {}", example));
                return;
            }
            values.push_back(stringOrEmpty(name));
        }
    }
    const Json* object(std::string_view key) { return find(key, "an object", "{}", &Json::is_object); }

    /// Warns of the keys that were never read.
    void warnUnknown() {
        for (const auto& [key, value] : *json_.get_ptr<const Json::object_t*>()) {
            if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
            const std::string_view near = closestName(key, asked_);
            warn(key, "a project has no such key",
                 near.empty() ? "it is ignored; check the spelling or remove it"
                              : format("it is ignored; did you mean \"{}\"?", near));
        }
    }

    void warn(std::string_view key, std::string what, std::string remedy) {
        warnings_.push_back({where_ + std::string{key}, std::move(what), std::move(remedy)});
    }

private:
    const Json* find(std::string_view key, std::string_view expected, std::string_view example,
                     bool (Json::*is)() const noexcept) {
        asked_.push_back(key);
        const Json* at = findMember(json_, key);
        if (at == nullptr) return nullptr;
        if ((at->*is)()) return at;
        warn(key, format("expected {}, found {}", expected, at->type_name()),
             format("write e.g. {}", example));
        return nullptr;
    }

    const Json& json_;
    std::string where_;
    std::vector<Error>& warnings_;
    std::vector<std::string_view> asked_;  // keys that were read
};

void readWindow(const Json& json, const std::string& where, Project& project) {
    Reader window{json, where + ": window.", project.warnings};
    window.size("width", project.windowWidth);
    window.size("height", project.windowHeight);
    window.flag("fullscreen", project.fullscreen);
    window.warnUnknown();
}

void readPhysics(const Json& json, const std::string& where, Project& project) {
    Reader physics{json, where + ": physics.", project.warnings};
    physics.number("pixelsPerMetre", project.pixelsPerMetre, 0.001f, 100000.0f);
    physics.pair("gravity", project.gravity.x, project.gravity.y);
    auto quality = static_cast<float>(project.physicsQuality);
    physics.number("quality", quality, 0.0f, 6.0f);
    project.physicsQuality = static_cast<int>(quality);
    physics.names("layers", project.layers, 32, "[\"ground\", \"player\"]; \"\" skips a layer");
    physics.warnUnknown();
}

void readExport(const Json& json, const std::string& where, Project& project) {
    constexpr std::size_t kMost = 256;
    Reader exported{json, where + ": export.", project.warnings};
    exported.text("icon", project.icon);
    exported.flag("mods", project.mods);
    exported.names("leaveOut", project.leftOut, kMost, "[\"art/\"]");
    exported.warnUnknown();
}

void readScaling(Reader& reader, Project& project) {
    std::string name = "fit";
    reader.text("scaling", name);
    for (const auto& [known, scaling] : kScalings) {
        if (name == known) {
            project.scaling = scaling;
            return;
        }
    }
    reader.warn("scaling", format("there is no scaling \"{}\"", name), "write fit, integer, stretch or fill");
}

}  // namespace

Result<Project> loadProject(const Path& path) {
    const bool isFolder = folderExists(path);
    const Path file = isFolder ? path / "project.json" : path;
    Result<std::string> text = readFile(file);
    if (!text) {
        // A path without extension is meant as a folder.
        const bool noFolder = !isFolder && !path.has_extension() && !fileExists(path);
        return Error{file.generic_string(), noFolder ? "there is no such folder" : text.error().what,
                     "name a folder with a project.json in it, e.g. projects/platformer"};
    }
    const Path root = file.has_parent_path() ? file.parent_path() : Path{"."};
    finishImport(root);  // if an import was killed while it moved its files
    return projectFromText(*text, root, "project.json");
}

namespace {

Result<Project> readProject(std::string_view text, const Path& root, const std::string& where) {
    Project project;
    project.root = root;
    Result<Json> json = parseJson(text, where, &project.warnings);
    if (!json) return json.error();
    if (!json->is_object()) {
        return Error{where, format("expected an object, found {}", json->type_name()),
                     "write {\"name\": \"My Game\"}"};
    }
    Reader reader{*json, where + ": ", project.warnings};
    reader.text("name", project.name);
    reader.text("version", project.version);
    reader.text("startScene", project.startScene);
    reader.text("pauseScene", project.pauseScene);
    if (const Json* window = reader.object("window")) readWindow(*window, where, project);
    auto width = static_cast<float>(project.windowWidth);
    auto height = static_cast<float>(project.windowHeight);
    reader.pair("resolution", width, height);
    if (width >= 1.0f && height >= 1.0f && width <= 16384.0f && height <= 16384.0f) {
        project.width = static_cast<int>(width);
        project.height = static_cast<int>(height);
    } else {
        reader.warn("resolution", "is outside 1..16384", "write it as [320, 180]");
    }
    readScaling(reader, project);
    reader.flag("smooth", project.smooth);
    if (const Json* physics = reader.object("physics")) readPhysics(*physics, where, project);
    project.actions = ActionMap::defaults();
    if (const Json* input = reader.object("input")) {
        project.actions = actionMapFromJson(*input, where + ": input", project.warnings);
    }
    if (const Json* exported = reader.object("export")) readExport(*exported, where, project);
    reader.warnUnknown();
    return project;
}

}  // namespace

Result<Project> projectFromText(std::string_view text, const Path& root, const std::string& where) {
    return guarded(where, [&] { return readProject(text, root, where); });
}

}  // namespace plumb
