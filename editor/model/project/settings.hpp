#pragma once

#include <string>
#include <vector>

#include "core/file.hpp"
#include "editor/model/input/key_bindings.hpp"
#include "editor/model/view/layout.hpp"

namespace plumb::editor {

enum class Theme : unsigned char { Dark, Light };

/// A layout that a person saved under a name.
struct NamedLayout {
    std::string name;
    PaneLayout layout;

    friend bool operator==(const NamedLayout&, const NamedLayout&) = default;
};

/// How a person likes the editor, in all projects. Nothing of it is part of a scene, and nothing is undone.
struct Settings {
    static constexpr float kLeastScale = 0.75f;
    static constexpr float kMostScale = 3.0f;
    static constexpr std::size_t kMostRecent = 12;

    Theme theme = Theme::Dark;
    float scale = 1.0f;        ///< of the whole interface
    float textSize = 14.0f;    ///< px at scale 1
    bool rightErases = false;  ///< the right button erases tiles; else it takes a pattern
    bool welcome = true;       ///< the welcome screen comes when the editor starts without a project
    PaneLayout layout;         ///< as it is now
    std::vector<NamedLayout> layouts;
    std::vector<std::string> recent;  ///< folders of projects, the last one first
    KeyBindings keys;

    /// Puts a project's folder at the front of the recent ones.
    void remember(const std::string& project);
    void forget(const std::string& project) { std::erase(recent, project); }
    /// Keeps the layout under a name; one of that name is replaced.
    void keepLayout(const std::string& name);

    [[nodiscard]] std::string toText() const;
    /// @param problems  what was wrong; what is wrong stays as it is at first
    /// @error           no JSON object at all
    static Result<Settings> fromText(std::string_view text, std::vector<Error>& problems);

    friend bool operator==(const Settings&, const Settings&) = default;
};

/// Where settings belong: $PLUMB_CONFIG, or the folder of the system: $XDG_CONFIG_HOME/plumb or
/// ~/.config/plumb, %APPDATA%\plumb, ~/Library/Application Support/plumb.
Path configFolder();

/// The file of the settings. Written as a whole or not at all, a moment after something changed.
class SettingsFile {
public:
    static constexpr double kPause = 1.0;  ///< s between two looks at what changed

    explicit SettingsFile(Path folder = configFolder()) : path_{std::move(folder) / "settings.json"} {}

    /// The settings as they were last; as at first when there are none. A file that cannot be read is kept
    /// beside as settings.json.damaged.
    /// @return what was wrong, for the person; empty when nothing was
    std::vector<Error> load(Settings& settings);
    /// Writes them when they are not as in the file. @param seconds  since the last call
    void tend(const Settings& settings, double seconds);
    Result<Done> save(const Settings& settings);
    [[nodiscard]] const Path& path() const { return path_; }

private:
    Path path_;
    std::string written_;
    double waited_ = 0.0;
};

}  // namespace plumb::editor
