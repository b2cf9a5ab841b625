#pragma once

#include <memory>
#include <string>

#include "editor/model/cost/what_if_run.hpp"
#include "editor/model/overlays/ghost_game.hpp"

namespace plumb::editor {

/// Measures cost and error of other physics settings for the last seconds of the running game, or for the
/// first seconds of the scene if none runs. Plays a copy of the game once, over several frames, to record its
/// changes to the physics; then a thread steps only the physics again, once per variant of the settings. The
/// game itself is not changed.
class WhatIf {
public:
    static constexpr std::int64_t kTicks = 300;    ///< maximum number of ticks: 5 s
    static constexpr std::int64_t kMinTicks = 30;  ///< minimum number of ticks for a measurement
    static constexpr double kBudget = 0.008;       ///< CPU time per frame, s

    WhatIf();
    ~WhatIf();

    /// Starts a new measurement. If that is not possible, `refusal` returns the reason.
    void begin(Workspace& workspace);
    void cancel();
    /// Cancels and drops all results, e.g. when another scene is opened.
    void forget();
    /// Continues the measurement; must be called in every frame in which the panel is shown.
    void update(Workspace& workspace);

    [[nodiscard]] bool busy() const { return recording_ || (run_ != nullptr && !run_->done()); }
    [[nodiscard]] float progress() const;  ///< 0 to 1
    [[nodiscard]] WhatIfResult result() const { return run_ != nullptr ? run_->result() : WhatIfResult{}; }
    [[nodiscard]] bool measured() const { return run_ != nullptr; }
    /// The recording that is measured; null before it is complete.
    [[nodiscard]] const PhysicsTape* tape() const { return tape_.get(); }
    /// True if the running game was measured, false if the start of the scene.
    [[nodiscard]] bool wasPlaying() const { return playing_; }
    [[nodiscard]] const std::string& refusal() const { return refusal_; }
    /// For tests: waits until the thread has finished.
    void wait() {
        if (run_ != nullptr) run_->wait();
    }

private:
    void refuse(std::string why);
    [[nodiscard]] bool stillThere(const Workspace& workspace) const;
    void recordTick(const Workspace& workspace);
    void finishTape();

    GhostGame ghost_;
    PlaySession* session_ = nullptr;  // the session of `ghost_`
    TapeRecorder recorder_;
    bool recording_ = false;
    bool playing_ = false;    // the running game is measured, not the start of the scene
    std::int64_t first_ = 0;  // tick before the recording
    std::int64_t tick_ = 0;   // last recorded tick; `first_`: none yet
    std::int64_t last_ = 0;   // tick at which the recording ends
    std::shared_ptr<const PhysicsTape> tape_;
    std::unique_ptr<WhatIfRun> run_;
    std::string refusal_;
};

}  // namespace plumb::editor
