#pragma once

#include <string>
#include <vector>

#include "core/file.hpp"
#include "editor/model/input/key_bindings.hpp"
#include "editor/model/view/layout.hpp"

namespace plumb::editor {

enum class Theme : unsigned char { Dark, Light };

/// A pane layout that the user saved under a name.
struct NamedLayout {
    std::string name;
    PaneLayout layout;

    friend bool operator==(const NamedLayout&, const NamedLayout&) = default;
};

/// The user's editor settings for all projects. They are not part of a scene or of the undo history.
struct Settings {
    static constexpr float kLeastScale = 0.75f;    ///< minimum of `scale`
    static constexpr float kMostScale = 3.0f;      ///< maximum of `scale`
    static constexpr std::size_t kMaxRecent = 12;  ///< maximum number of `recent` projects

    Theme theme = Theme::Dark;
    float scale = 1.0f;        ///< scale of the user interface
    float textSize = 14.0f;    ///< px at scale 1: size of the text
    bool rightErases = false;  ///< right mouse button on tiles: true erases, false picks a pattern
    /// Command that opens a line of a source (wordsOf); empty: the program that the system assigns to the
    /// file.
    std::string textEditor;
    bool welcome = true;               ///< show the welcome screen if the editor starts without a project
    PaneLayout layout;                 ///< the current layout
    std::vector<NamedLayout> layouts;  ///< layouts saved by the user
    std::vector<std::string> recent;   ///< folders of recent projects, latest first
    KeyBindings keys;                  ///< shortcuts of actions

    /// Moves or inserts a project's folder at the front of the recent ones.
    void remember(const std::string& project);
    void forget(const std::string& project) { std::erase(recent, project); }
    /// Saves the current layout under a name; replaces a layout of the same name.
    void keepLayout(const std::string& name);

    [[nodiscard]] std::string toText() const;
    /// Parses the settings. Invalid values keep their defaults.
    /// @param problems  receives one entry per invalid value
    /// @error           the text is not a JSON object
    static Result<Settings> fromText(std::string_view text, std::vector<Error>& problems);

    friend bool operator==(const Settings&, const Settings&) = default;
};

/// Returns the folder for settings: $PLUMB_CONFIG if set, else $XDG_CONFIG_HOME/plumb or ~/.config/plumb on
/// Linux, %APPDATA%\plumb on Windows, ~/Library/Application Support/plumb on macOS.
Path configFolder();

/// The settings file. It is written atomically, up to `kPause` after a change.
class SettingsFile {
public:
    static constexpr double kPause = 1.0;  ///< s between two checks for changes

    explicit SettingsFile(Path folder = configFolder()) : path_{std::move(folder) / "settings.json"} {}

    /// Reads the settings; without a file they stay unchanged. A file that cannot be read is renamed to
    /// settings.json.damaged.
    /// @return the problems found, to be shown to the user
    std::vector<Error> load(Settings& settings);
    /// Checks for changes once per `kPause` and writes them. @param seconds  time since the last call
    void update(const Settings& settings, double seconds);
    /// Writes the settings if they differ from the file.
    Result<Done> save(const Settings& settings);
    [[nodiscard]] const Path& path() const { return path_; }

private:
    Path path_;
    std::string written_;  // content of the file
    double waited_ = 0.0;  // s since the last check for changes
};

}  // namespace plumb::editor
