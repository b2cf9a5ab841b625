#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "app/frame_pacer.hpp"
#include "app/options/options_menu.hpp"
#include "app/player_options.hpp"
#include "app/screen.hpp"
#include "app/sound_output.hpp"
#include "input/input.hpp"

namespace plumb {

/// Returns the folder of saved games and settings: that of --saves, or the system's. Empty for runs that use
/// neither: replays of files, headless ones, and those that end by themselves.
/// @error the system has no folder for them
Result<Path> playerFolder(const PlayerOptions& options, std::string_view project);

/// Returns the settings of the window with those of the player, which the command line overrides.
ScreenSettings withPlayerSettings(ScreenSettings settings, const PlayerOptions& options,
                                  std::string_view project);

/// The settings of the player in a running game, and the menu that changes them: F10 or Back of a gamepad
/// opens it, unless an action of the game has the key.
class GameOptions {
public:
    /// Reads the settings, and applies all but the keys.
    /// @param options  of the program: with --safe the settings are not read
    /// @param screen, sounds, pacer, input  of the game; must outlive this
    GameOptions(const PlayerOptions& options, std::string_view project, Screen& screen, SoundOutput& sounds,
                FramePacer& pacer, Input& input);

    /// @return true if the menu has used the event: the game does not get it
    bool handle(const Event& event);
    void open();
    [[nodiscard]] bool isOpen() const { return menu_.isOpen(); }
    [[nodiscard]] bool quits() const { return quits_; }  ///< the player has chosen to quit
    /// False while the game is recorded or replayed: its keys are those of the recording.
    void allowKeys(bool allowed) { menu_.allowKeys(allowed); }
    /// Gives the input the keys of the player.
    void useKeys();
    /// True if the player has changed keys since the last call.
    bool takeKeysChanged() { return std::exchange(keysChanged_, false); }
    void setFullscreen(bool on);
    /// The changes of the bindings by the player, as JSON on one line; empty for none.
    [[nodiscard]] std::string keyChanges() const;

    /// Shows what does not work, and why, for some seconds.
    void notify(std::string_view what, const Error& error);
    /// The line that is shown; empty: none.
    [[nodiscard]] const std::string& notice() const { return notice_; }
    /// Draws the menu, or a message, over the game.
    void draw(AssetStore& assets);
    /// Writes the settings if they were changed.
    void write();

private:
    PlayerSettings read(bool safe);
    void apply();
    void fitWindow();
    [[nodiscard]] int mostScale() const;
    [[nodiscard]] bool isOpener(const Event& event) const;
    [[nodiscard]] Vec2 inMenu(Vec2 windowPosition) const;

    Result<Path> file_;         // empty: settings are not kept in this run; an error: they cannot be
    bool keepsFormer_ = false;  // the file has settings that are not read
    std::string notice_;
    double noticeEnd_ = 0.0;  // s, wall clock
    PlayerSettings project_;
    PlayerSettings applied_;
    PlayerSettings written_;
    int windowScale_;  // PlayerSettings::scale that the size of the window follows
    OptionsMenu menu_;
    Screen& screen_;
    SoundOutput& sounds_;
    FramePacer& pacer_;
    Input& input_;
    bool choseFullscreen_ = false;  // else the mode may be that of the command line, for this run only
    bool keysChanged_ = false;
    bool quits_ = false;
};

}  // namespace plumb
