#include "editor/model/project/editor_options.hpp"

#include <array>
#include <vector>

#include "core/option_rows.hpp"
#include "core/text.hpp"
#include "editor/templates/project_templates.hpp"

namespace plumb::editor {
namespace {

using Row = OptionRow<EditorOptions>;

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

bool setTemplate(EditorOptions& options, std::string_view text) {
    options.from = text;
    return findTemplate(text) != nullptr;
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
    Row{"--replay", "FILE", "play a replay, e.g. of a crash, and pause 2 s before its end",
        [](EditorOptions& o, std::string_view v) { return setText(v, o.replay); }},
    Row{"--new", "FOLDER", "create a project in this folder, named like it, and exit",
        [](EditorOptions& o, std::string_view v) { return setText(v, o.newProject); }},
    Row{"--template", "NAME",
        "template of the new project: empty, cpp, lua, topdown, physics, kit or platformer", &setTemplate},
    Row{"--validate", "", "check all scenes, prefabs and assets, print the problems and exit",
        [](EditorOptions& o, std::string_view) { return o.validate = true; }},
    Row{"--export", "FOLDER",
        "copy the game, the player program and all files they need to a folder for distribution, then exit",
        [](EditorOptions& o, std::string_view v) { return setText(v, o.exportTo); }},
    Row{"--player", "FILE", "with --export: the player of another system, or the folder of a page",
        [](EditorOptions& o, std::string_view v) { return setText(v, o.player); }},
    Row{"--licences", "FOLDER", "with --export: the licences of the player's libraries",
        [](EditorOptions& o, std::string_view v) { return setText(v, o.licences); }},
    Row{"--finished", "FOLDER", "with --export: copy this finished export instead of making one",
        [](EditorOptions& o, std::string_view v) { return setText(v, o.finished); }},
    Row{"--resources", "FOLDER",
        "write icon and version of the program for Windows to a folder, game.rc and game.ico, and exit",
        [](EditorOptions& o, std::string_view v) { return setText(v, o.resources); }},
    Row{"--screenshot", "FILE.png", "write a screenshot of the window as a PNG image and exit",
        [](EditorOptions& o, std::string_view v) { return setPngPath(v, o.screenshot); }},
    Row{"--tour", "FILE", "run the actions of this script, take its screenshots and exit",
        [](EditorOptions& o, std::string_view v) { return setText(v, o.tour); }},
    Row{"--import", "FILE [OUT]",
        "import a Tiled map (.tmx, .tmj, .world), an LDtk project (.ldtk) or an Aseprite sheet (.json) "
        "into PROJECT, or as OUT.scene.json, print a report and exit",
        [](EditorOptions& o, std::string_view v) { return setText(v, o.importFrom); }},
    Row{"--size", "WxH", "window size in px, 320x240 to 8192x8192, e.g. 1600x900", &setSize},
    Row{"--scale", "RATIO", "scale of the user interface, 0.75 to 3", &setScale},
    Row{"--theme", "NAME", "color theme, dark or light", &setTheme},
    Row{"--welcome", "", "show the welcome screen first, to open or create a project",
        [](EditorOptions& o, std::string_view) { return o.welcome = true; }},
    Row{"--help", "", "show this help", [](EditorOptions& o, std::string_view) { return o.help = true; }},
};

}  // namespace

Result<EditorOptions> parseEditorOptions(std::span<const char* const> words) {
    EditorOptions options;
    const Result<Done> read =
        readOptions<EditorOptions>(kOptions, words, options, [&](std::string_view word) -> Result<Done> {
            // After --import FILE, a scene or animation file is the output, not the project.
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
