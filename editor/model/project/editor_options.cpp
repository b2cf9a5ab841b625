#include "editor/model/project/editor_options.hpp"

#include <array>
#include <vector>

#include "core/option_rows.hpp"
#include "core/text.hpp"

namespace plumb::editor {
namespace {

using Row = OptionRow<EditorOptions>;

bool setText(std::string_view text, std::string& field) {
    field = text;
    return !text.empty();
}

bool setSize(EditorOptions& options, std::string_view text) {
    const std::vector<std::string_view> parts = split(text, 'x');
    if (parts.size() != 2) return false;
    const auto width = parseInt(parts[0]);
    const auto height = parseInt(parts[1]);
    if (!width || !height || *width < 320 || *width > 8192 || *height < 240 || *height > 8192) return false;
    options.width = static_cast<int>(*width);
    options.height = static_cast<int>(*height);
    return true;
}

bool setScale(EditorOptions& options, std::string_view text) {
    const auto scale = parseFloat(text);
    if (!scale || *scale < 0.75f || *scale > 3.0f) return false;
    options.scale = *scale;
    return true;
}

bool setTheme(EditorOptions& options, std::string_view text) {
    options.theme = text;
    return options.theme == "dark" || options.theme == "light";
}

constexpr std::array kOptions{
    Row{"--scene", "NAME", "open this scene",
        [](EditorOptions& o, std::string_view v) { return setText(v, o.scene); }},
    Row{"--select", "NAME", "select this entity",
        [](EditorOptions& o, std::string_view v) { return setText(v, o.select); }},
    Row{"--validate", "", "check every scene, prefab and asset, tell the problems, end",
        [](EditorOptions& o, std::string_view) { return o.validate = true; }},
    Row{"--export", "FOLDER",
        "copy the game, its player and what both need into a folder that can be given to others, end",
        [](EditorOptions& o, std::string_view v) { return setText(v, o.exportTo); }},
    Row{"--screenshot", "FILE.png", "write a picture of the window, end",
        [](EditorOptions& o, std::string_view v) { return setText(v, o.screenshot); }},
    Row{"--tour", "FILE", "play the actions of this file, take its pictures, end",
        [](EditorOptions& o, std::string_view v) { return setText(v, o.tour); }},
    Row{"--import", "FILE [OUT]",
        "import a map of Tiled (.tmx, .tmj, .world), a project of LDtk (.ldtk) or a sheet of "
        "Aseprite (.json) into PROJECT, or as OUT.scene.json, tell what came of it, end",
        [](EditorOptions& o, std::string_view v) { return setText(v, o.importFrom); }},
    Row{"--size", "WxH", "size of the window in px, 320x240 to 8192x8192, e.g. 1600x900", &setSize},
    Row{"--scale", "RATIO", "size of the interface, 0.75 to 3", &setScale},
    Row{"--theme", "NAME", "dark or light", &setTheme},
    Row{"--welcome", "", "choose or make a project first",
        [](EditorOptions& o, std::string_view) { return o.welcome = true; }},
    Row{"--help", "", "this text", [](EditorOptions& o, std::string_view) { return o.help = true; }},
};

}  // namespace

Result<EditorOptions> parseEditorOptions(std::span<const char* const> words) {
    EditorOptions options;
    const Result<Done> read =
        readOptions<EditorOptions>(kOptions, words, options, [&](std::string_view word) -> Result<Done> {
            // What an import makes may be named behind it.
            const bool isTarget = endsWith(word, ".scene.json") || endsWith(word, ".anim.json");
            std::string& named = isTarget && !options.importFrom.empty() ? options.importTo : options.project;
            if (!named.empty())
                return Error{"command line", format("\"{}\" is a second project", word), "name one project"};
            named = word;
            return Done{};
        });
    if (!read) return read.error();
    return options;
}

std::string editorUsage() {
    return format("usage: plumb-editor [PROJECT] [options]\n\n{}",
                  optionLines(helpOf<EditorOptions>(kOptions)));
}

}  // namespace plumb::editor
