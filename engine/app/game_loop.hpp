#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/event_log.hpp"
#include "app/frame_pacer.hpp"
#include "app/game.hpp"
#include "app/options/game_options.hpp"
#include "app/player_options.hpp"
#include "app/recording/run_records.hpp"
#include "app/reload/edited_files.hpp"
#include "app/saved_game.hpp"
#include "app/screen.hpp"
#include "app/sound_output.hpp"
#include "app/touch_controls.hpp"
#include "input/device_state.hpp"
#include "input/recorder.hpp"
#include "scene/physics/physics_times.hpp"

namespace plumb {

/// Runs a game in real time in a window, or headless as fast as possible.
class GameLoop {
public:
    /// @param screen  null: run headless
    /// @param edited  content of the game, whose scripts are read again when they change; null: they are not
    GameLoop(Game& game, Screen* screen, const PlayerOptions& options, std::string projectName,
             GameContent* edited = nullptr);

    /// Runs until the window is closed, the requested number of ticks is reached or the replay ends.
    /// @return the program's exit code
    int run();

    /// Ends the loop after this tick.
    void quit() { running_ = false; }

private:
    bool prepare();
    void runHeadless();
    void runScreen();
    void runFrame(bool lockstep);
    void openDevices();
    void handleEvents();
    void reloadEdited();
    void tick();
    bool beginReplay();
    [[nodiscard]] bool isLockstep() const;
    void checkReplay();
    void takeOver();
    void goOnLive(const std::string& why);
    void performRequests();
    void loadSaved(int slot);
    void fail(std::string_view what, const Error& error);
    void followPause();
    bool chooseKeys();
    bool beginWithState();
    [[nodiscard]] Replay start() const;
    bool nextInput(InputFrame& frame);
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
    EditedFiles edited_;
    std::optional<SoundOutput> sounds_;  ///< empty if headless
    PhysicsTimes physicsTimes_;
    std::vector<Event> pending_;  // window events of this frame; a member, so that its memory is reused
    std::optional<Replay> replay_;
    std::optional<ReplayPlayer> replayPlayer_;
    std::optional<GameOptions> player_;  ///< empty if headless
    std::optional<SaveSlots> slots_;     ///< empty: the game does not save
    std::optional<Error> noSlots_;       ///< why it cannot, though it should
    RunRecords records_;
    bool goesOnLive_ = false;  // after the replay, or when a key is pressed during it
    TouchControls shownControls_;
    std::int64_t ticks_ = 0;
    std::int64_t framesDrawn_ = 0;
    double before_ = 0.0;          // s, wall clock: start of the last frame
    double rateStart_ = 0.0;       // s, wall clock: when the frame rate was last logged
    std::int64_t rateFrames_ = 0;  // frames drawn since rateStart_
    bool focusLost_ = false;       // another window has the focus
    bool padsOpen_ = false;        // the gamepads are open
    bool running_ = true;
    bool failed_ = false;  // run() returns an error code
};

/// Saves the current image as PNG, atomically.
Result<Done> saveScreenshot(Screen& screen, const Path& path);

}  // namespace plumb
