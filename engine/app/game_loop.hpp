#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/crash_file.hpp"
#include "app/event_log.hpp"
#include "app/frame_pacer.hpp"
#include "app/game.hpp"
#include "app/player_options.hpp"
#include "app/saved_game.hpp"
#include "app/screen.hpp"
#include "app/sound_output.hpp"
#include "core/watchdog.hpp"
#include "input/device_state.hpp"
#include "input/recorder.hpp"
#include "input/replay_link.hpp"
#include "scene/physics/physics_times.hpp"

namespace plumb {

/// Runs a game in real time in a window, or headless as fast as possible.
class GameLoop {
public:
    /// @param screen  null: run headless
    GameLoop(Game& game, Screen* screen, const PlayerOptions& options, std::string projectName);

    /// Runs until the window is closed, the requested number of ticks is reached or the replay ends.
    /// @return the program's exit code
    int run();

    /// Ends the loop after this tick.
    void quit() { running_ = false; }

private:
    bool prepare();
    bool prepareCrashFile();
    void runHeadless();
    void runScreen();
    void runFrame(bool lockstep);
    void openDevices();
    void handleEvents();
    void reloadEdited();
    void tick();
    void simulate(const InputFrame& frame);
    void noteEndOfCrash();
    bool beginReplay();
    [[nodiscard]] bool isLockstep() const;
    void checkReplay();
    void takeOver();
    void goOnLive(const std::string& why);
    void record(const InputFrame& frame);
    void performRequests();
    void loadSaved(int slot);
    void updateRecording();
    bool nextInput(InputFrame& frame);
    [[nodiscard]] Result<std::string> link(bool withHash) const;
    void beginPage();
    void updatePage();
    void drawFrame(float alpha);
    PhysicsShown shownPhysics();
    void reportRate();
    void finish();

    Game& game_;
    Screen* screen_;
    PlayerOptions options_;
    std::string projectName_;
    FramePacer pacer_;
    DeviceState devices_;
    EventLog events_;
    std::optional<SoundOutput> sounds_;  ///< empty if headless
    PhysicsTimes physicsTimes_;
    std::vector<Event> pending_;  // window events of this frame; a member, so that its memory is reused
    std::optional<Replay> replay_;
    std::optional<ReplayPlayer> replayPlayer_;
    std::optional<SaveSlots> slots_;  ///< empty: the game does not save
    Recorder recorder_;
    std::optional<RecordingFile> recording_;  ///< empty: the game is not recorded, or no longer
    std::optional<CrashFile> crashFile_;      ///< empty: a crash leaves no file
    std::optional<Watchdog> watchdog_;
    std::optional<LinkWriter> link_;  ///< empty: no link can be asked for
    bool goesOnLive_ = false;         // after the replay, or when a key is pressed during it
    Input::Asked shownControls_;      // controls that the page shows
    std::int64_t ticks_ = 0;
    std::int64_t framesDrawn_ = 0;
    double before_ = 0.0;          // s, wall clock: start of the last frame
    double rateStart_ = 0.0;       // s, wall clock: when the frame rate was last logged
    std::int64_t rateFrames_ = 0;  // frames drawn since rateStart_
    bool padsOpen_ = false;        // the gamepads are open
    bool running_ = true;
    bool failed_ = false;  // run() returns an error code
};

/// Returns `options` with the scene and the seed of the replay that they name, if any; a file without these
/// lines has those of a run without options.
/// @param projectName  the project to play; recordings of another one are refused
/// @error the replay cannot be read, or belongs to another project
Result<PlayerOptions> begunAsRecorded(PlayerOptions options, std::string_view projectName);

/// Saves the current image as PNG, atomically.
Result<Done> saveScreenshot(Screen& screen, const Path& path);

}  // namespace plumb
