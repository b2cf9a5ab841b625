#include "app/options/player_settings.hpp"

#include <filesystem>
#include <system_error>

#include "core/text.hpp"
#include "reflect/json.hpp"
#include "reflect/json_fields.hpp"
#include "reflect/json_text.hpp"

namespace plumb {
namespace {

constexpr int kFormat = 1;
constexpr int kMostCap = 1000;  // Hz
constexpr std::size_t kMostBytes = std::size_t{1} << 20;

}  // namespace

PlayerSettings settingsFromText(std::string_view text, const PlayerSettings& project,
                                const std::string& where, std::vector<Error>& warnings) {
    PlayerSettings settings = project;
    const Result<Json> json = parseJson(text, where, &warnings);
    if (!json) {
        warnings.push_back(
            {json.error().where, json.error().what,
             "the settings of the project are used; the next change keeps this file as settings.old.json"});
        return settings;
    }
    JsonFields fields{*json, where, warnings};
    if (!fields.acceptFormat(kFormat)) return settings;
    settings.fullscreen = fields.flag("fullscreen", project.fullscreen);
    settings.scale = fields.whole("scale", project.scale, 0, PlayerSettings::kMostScale);
    settings.vsync = fields.flag("vsync", project.vsync);
    settings.frameCap = fields.whole("frameCap", project.frameCap, 0, kMostCap);
    settings.master = fields.number("master", project.master, 0.0f, 1.0f);
    settings.music = fields.number("music", project.music, 0.0f, 1.0f);
    settings.sounds = fields.number("sounds", project.sounds, 0.0f, 1.0f);
    static_cast<void>(fields.find("language"));  // in files of earlier versions
    if (const Json* keys = fields.find("keys"))
        settings.keys = reboundFromJson(project.keys, *keys, where + ": keys", warnings);
    fields.warnUnknown();
    return settings;
}

std::string settingsText(const PlayerSettings& settings, const PlayerSettings& project) {
    Json json = Json::object();
    json["format"] = kFormat;
    json["fullscreen"] = settings.fullscreen;
    json["scale"] = settings.scale;
    json["vsync"] = settings.vsync;
    json["frameCap"] = settings.frameCap;
    json["master"] = settings.master;
    json["music"] = settings.music;
    json["sounds"] = settings.sounds;
    json["keys"] = bindingChanges(project.keys, settings.keys);
    return writeJson(json);
}

PlayerSettings readSettings(const Path& file, const PlayerSettings& project, std::vector<Error>& warnings) {
    std::error_code unknown;
    if (!std::filesystem::exists(file, unknown)) return project;
    const Result<std::string> text = readFile(file, kMostBytes);
    if (text) return settingsFromText(*text, project, file.generic_string(), warnings);
    warnings.push_back(text.error());
    return project;
}

Result<Done> writeSettings(const Path& file, std::string_view text, bool keeps) {
    std::error_code failed;
    if (keeps && std::filesystem::exists(file, failed)) {
        const Result<std::string> former = readFile(file);
        if (!former) return former.error();
        const Result<Done> kept = writeFile(file.parent_path() / "settings.old.json", *former);
        if (!kept) return kept;
    }
    return writeFile(file, text);
}

}  // namespace plumb
