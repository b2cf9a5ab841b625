#include "editor/model/editor_options.hpp"

#include <array>
#include <vector>

#include "core/text.hpp"

namespace plumb::editor {
namespace {

struct OptionRow {
    std::string_view name;
    int values;
    std::string_view help;
    bool (*set)(EditorOptions& options, std::span<const char* const> values);
};

bool setSize(EditorOptions& options, std::span<const char* const> values) {
    const std::vector<std::string_view> parts = split(values[0], 'x');
    if (parts.size() != 2) return false;
    const auto width = parseInt(parts[0]);
    const auto height = parseInt(parts[1]);
    if (!width || !height || *width < 320 || *width > 8192 || *height < 240 || *height > 8192) return false;
    options.width = static_cast<int>(*width);
    options.height = static_cast<int>(*height);
    return true;
}

bool setScale(EditorOptions& options, std::span<const char* const> values) {
    const auto scale = parseFloat(values[0]);
    if (!scale || *scale < 0.75f || *scale > 3.0f) return false;
    options.scale = *scale;
    return true;
}

bool setTheme(EditorOptions& options, std::span<const char* const> values) {
    options.theme = values[0];
    return options.theme == "dark" || options.theme == "light";
}

using Values = std::span<const char* const>;

constexpr std::array kOptions{
    OptionRow{"--scene", 1, "NAME         open this scene",
              [](EditorOptions& o, Values v) { return o.scene = v[0], true; }},
    OptionRow{"--select", 1, "NAME        select this entity",
              [](EditorOptions& o, Values v) { return o.select = v[0], true; }},
    OptionRow{"--validate", 0, "           check every scene, prefab and asset, tell the problems, end",
              [](EditorOptions& o, Values) { return o.validate = true; }},
    OptionRow{"--export", 1,
              "FOLDER      copy the game, its player and what both need into a folder that\n"
              "                        can be given to others, end",
              [](EditorOptions& o, Values v) { return o.exportTo = v[0], !o.exportTo.empty(); }},
    OptionRow{"--screenshot", 1, "FILE.png  write a picture of the window, end",
              [](EditorOptions& o, Values v) { return o.screenshot = v[0], true; }},
    OptionRow{"--tour", 1, "FILE          play the actions of this file, take its pictures, end",
              [](EditorOptions& o, Values v) { return o.tour = v[0], true; }},
    OptionRow{"--import", 1,
              "FILE [OUT]   import a map of Tiled (.tmx, .tmj, .world), a project of LDtk (.ldtk)\n"
              "                        or a sheet of Aseprite (.json) into PROJECT, or as\n"
              "                        OUT.scene.json, tell what came of it, end",
              [](EditorOptions& o, Values v) { return o.importFrom = v[0], true; }},
    OptionRow{"--size", 1, "WxH           size of the window, e.g. 1600x900", &setSize},
    OptionRow{"--scale", 1, "RATIO        size of the interface, 0.75 to 3", &setScale},
    OptionRow{"--theme", 1, "NAME         dark or light", &setTheme},
    OptionRow{"--welcome", 0, "            choose or make a project first",
              [](EditorOptions& o, Values) { return o.welcome = true; }},
    OptionRow{"--help", 0, "               this text",
              [](EditorOptions& o, Values) { return o.help = true; }},
};

}  // namespace

Result<EditorOptions> parseEditorOptions(std::span<const char* const> words) {
    EditorOptions options;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string_view word = words[i];
        if (!startsWith(word, "--")) {
            // What an import makes may be named behind it.
            const bool isTarget = endsWith(word, ".scene.json") || endsWith(word, ".anim.json");
            (isTarget && !options.importFrom.empty() ? options.importTo : options.project) = word;
            continue;
        }
        const OptionRow* found = nullptr;
        std::vector<std::string_view> names;
        for (const OptionRow& row : kOptions) {
            names.push_back(row.name);
            if (row.name == word) found = &row;
        }
        if (found == nullptr) {
            const std::string_view near = closestName(word, names);
            return Error{std::string{word}, "there is no such option",
                         near.empty() ? "see --help" : format("did you mean {}?", near)};
        }
        const auto count = static_cast<std::size_t>(found->values);
        if (words.size() - i <= count) return Error{std::string{word}, "its value is missing", "see --help"};
        if (!found->set(options, words.subspan(i + 1, count))) {
            return Error{std::string{word}, format("cannot be \"{}\"", words[i + 1]), "see --help"};
        }
        i += count;
    }
    return options;
}

std::string editorUsage() {
    std::string text = "plumb-editor [PROJECT] [options]\n\n";
    for (const OptionRow& row : kOptions) {
        text += format("  {} {}\n", row.name, row.help);
    }
    return text;
}

}  // namespace plumb::editor
