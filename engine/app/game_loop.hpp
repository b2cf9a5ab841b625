#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/event_log.hpp"
#include "app/frame_pacer.hpp"
#include "app/game.hpp"
#include "app/player_options.hpp"
#include "app/screen.hpp"
#include "app/sound_output.hpp"
#include "input/device_state.hpp"
#include "input/recorder.hpp"
#include "scene/physics/physics_times.hpp"

namespace plumb {

/// Runs a game in real time in a window, or as fast as it can without one.
class GameLoop {
public:
    /// @param screen  null to run headless
    GameLoop(Game& game, Screen* screen, const PlayerOptions& options, std::string projectName);

    /// Plays until the window closes, the ticks asked for are over or the replay ends.
    /// @return the program's exit code
    int run();

    /// Ends the loop after this tick.
    void quit() { running_ = false; }

private:
    bool prepare();
    void runHeadless();
    void runScreen();
    void openDevices();
    void handleEvents();
    void reloadEdited();
    void tick();
    void keepRecording();
    bool nextInput(InputFrame& frame);
    void drawFrame(float alpha);
    PhysicsShown shownPhysics();
    void reportRate();
    int finish();

    Game& game_;
    Screen* screen_;
    PlayerOptions options_;
    std::string projectName_;
    FramePacer pacer_;
    DeviceState devices_;
    EventLog events_;
    std::optional<SoundOutput> sounds_;  ///< none headless
    PhysicsTimes physicsTimes_;
    std::vector<Event> pending_;
    std::optional<Replay> replay_;
    std::optional<ReplayPlayer> replayPlayer_;
    Recorder recorder_;
    std::int64_t ticks_ = 0;
    std::int64_t framesDrawn_ = 0;
    double rateStart_ = 0.0;  // s, wall clock
    std::int64_t rateFrames_ = 0;
    bool padsOpen_ = false;
    bool running_ = true;
    bool failed_ = false;
};

/// The options with which the game of their replay began: its seed, and its scene where none is named.
PlayerOptions begunAsRecorded(PlayerOptions options);

/// Files of the outside world that a loop writes: PNG, atomically.
Result<Done> saveScreenshot(Screen& screen, const Path& path);

}  // namespace plumb
