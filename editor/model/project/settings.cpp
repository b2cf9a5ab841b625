#include "editor/model/project/settings.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "core/guarded.hpp"
#include "core/log.hpp"
#include "reflect/json.hpp"
#include "reflect/json_fields.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"

namespace plumb::editor {
namespace {

constexpr std::array<std::string_view, 2> kThemeNames{"dark", "light"};
constexpr int kFormat = 1;
constexpr std::size_t kMostLayouts = 64;

void readRecent(JsonFields& fields, Settings& settings) {
    const Json* recent = fields.array("recent");
    for (std::size_t i = 0; recent != nullptr && i < recent->size(); ++i) {
        const std::string* project = jsonText((*recent)[i]);
        if (project != nullptr && settings.recent.size() < Settings::kMaxRecent)
            settings.recent.push_back(*project);
    }
}

void readLayouts(JsonFields& fields, Settings& settings, std::vector<Error>& problems) {
    if (const Json* layout = fields.find("layout")) {
        const auto read = PaneLayout::fromJson(*layout, "settings.json: layout", problems);
        if (read) settings.layout = *read;
    }
    const Json* layouts = fields.find("layouts");
    if (layouts == nullptr) return;
    if (!layouts->is_object())
        return fields.warn("layouts", "expected an object that maps names to layouts",
                           "the saved layouts are ignored");
    for (const auto& [name, layout] : layouts->items()) {
        const auto read = PaneLayout::fromJson(layout, "settings.json: layouts." + name, problems);
        if (read && !name.empty() && settings.layouts.size() < kMostLayouts)
            settings.layouts.push_back({name, *read});
    }
}

Result<Settings> readSettings(std::string_view text, std::vector<Error>& problems) {
    Settings settings;
    const Result<Json> json = parseJson(text, "settings.json", &problems);
    if (!json) return json.error();
    if (!json->is_object())
        return Error{"settings.json", format("expected an object, found {}", json->type_name()),
                     "the editor starts with default settings"};
    JsonFields fields{*json, "settings.json", problems};
    static_cast<void>(fields.acceptFormat(kFormat));
    settings.theme = static_cast<Theme>(fields.choice("theme", 0, kThemeNames));
    settings.scale = fields.number("scale", 1.0f, Settings::kLeastScale, Settings::kMostScale);
    settings.textSize = fields.number("textSize", 14.0f, 10.0f, 24.0f);
    settings.rightErases = fields.flag("rightErases", false);
    settings.welcome = fields.flag("welcome", true);
    settings.textEditor = fields.text("textEditor");
    readRecent(fields, settings);
    if (const Json* keys = fields.find("keys"))
        settings.keys = KeyBindings::fromJson(*keys, "settings.json: keys", problems);
    readLayouts(fields, settings, problems);
    return settings;
}

Path fromEnvironment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? Path{} : Path{value};
}

}  // namespace

void Settings::remember(const std::string& project) {
    forget(project);
    recent.insert(recent.begin(), project);
    if (recent.size() > kMaxRecent) recent.resize(kMaxRecent);
}

void Settings::keepLayout(const std::string& name) {
    const auto same = std::find_if(layouts.begin(), layouts.end(),
                                   [&](const NamedLayout& one) { return one.name == name; });
    if (same != layouts.end()) {
        same->layout = layout;
    } else {
        layouts.push_back({name, layout});
    }
}

std::string Settings::toText() const {
    Json json = Json::object();
    json["format"] = kFormat;
    json["theme"] = kThemeNames[static_cast<std::size_t>(theme)];
    json["scale"] = scale;
    json["textSize"] = textSize;
    json["rightErases"] = rightErases;
    json["welcome"] = welcome;
    json["textEditor"] = textEditor;
    json["recent"] = recent;
    json["keys"] = keys.toJson();
    json["layout"] = layout.toJson();
    Json named = Json::object();
    for (const NamedLayout& one : layouts) named[one.name] = one.layout.toJson();
    json["layouts"] = std::move(named);
    return writeJson(json);
}

Result<Settings> Settings::fromText(std::string_view text, std::vector<Error>& problems) {
    return guarded("settings.json", [&] { return readSettings(text, problems); });
}

Path configFolder() {
    if (Path own = fromEnvironment("PLUMB_CONFIG"); !own.empty()) return own;
#if defined(_WIN32)
    if (Path data = fromEnvironment("APPDATA"); !data.empty()) return data / "plumb";
#elif defined(__APPLE__)
    if (Path home = fromEnvironment("HOME"); !home.empty()) return home / "Library/Application Support/plumb";
#else
    // The XDG Base Directory Specification requires that relative paths are ignored.
    if (Path data = fromEnvironment("XDG_CONFIG_HOME"); data.is_absolute()) return data / "plumb";
    if (Path home = fromEnvironment("HOME"); !home.empty()) return home / ".config/plumb";
#endif
    return Path{".plumb"};
}

std::vector<Error> SettingsFile::load(Settings& settings) {
    std::vector<Error> problems;
    std::error_code failed;
    if (!std::filesystem::exists(path_, failed)) {
        written_ = settings.toText();  // the file is not written until the user changes a setting
        return problems;
    }
    const Result<std::string> text = readFile(path_);
    Result<Settings> read = text ? Settings::fromText(*text, problems) : Result<Settings>{text.error()};
    if (read) {
        settings = *std::move(read);
        written_ = settings.toText();
        return problems;
    }
    const Path aside = path_.string() + ".damaged";
    std::filesystem::rename(path_, aside, failed);
    problems.push_back(
        {read.error().where, read.error().what,
         format("the editor starts with default settings; the file was renamed to {}", aside.string())});
    return problems;
}

void SettingsFile::update(const Settings& settings, double seconds) {
    waited_ += seconds;
    if (waited_ < kPause) return;
    waited_ = 0.0;
    const Result<Done> saved = save(settings);
    if (!saved) logWarning("Editor", saved.error());
}

Result<Done> SettingsFile::save(const Settings& settings) {
    std::string text = settings.toText();
    if (text == written_) return Done{};
    written_ = std::move(text);  // set before writing, so that a write error is reported only once
    return writeFile(path_, written_);
}

}  // namespace plumb::editor
