#pragma once

#include <memory>
#include <string>

#include "editor/model/cost/what_if_run.hpp"
#include "editor/model/overlays/ghost_game.hpp"

namespace plumb::editor {

/// What another quality would do to this scene: the last seconds of the game that plays, or the first ones of
/// the scene while the game does not run. A copy of the game is played once, a little in each frame, to learn
/// what it does to its bodies; then a thread steps the physics alone again in all ways. The game itself is
/// only read.
class WhatIf {
public:
    static constexpr std::int64_t kTicks = 300;      ///< at most: 5 s
    static constexpr std::int64_t kLeastTicks = 30;  ///< of the game, to have something to measure
    static constexpr double kBudget = 0.008;         ///< s of CPU in a frame

    WhatIf();
    ~WhatIf();

    /// Begins anew. What cannot be measured is said by `refusal`.
    void begin(Workspace& workspace);
    void cancel();
    /// Another scene: what was measured means nothing any more.
    void forget();
    /// To be called in every frame in which it is shown.
    void tend(Workspace& workspace);

    [[nodiscard]] bool busy() const { return recording_ || (run_ != nullptr && !run_->done()); }
    [[nodiscard]] float progress() const;  ///< ratio
    [[nodiscard]] WhatIfResult result() const { return run_ != nullptr ? run_->result() : WhatIfResult{}; }
    [[nodiscard]] bool measured() const { return run_ != nullptr; }
    /// What was measured; null before it was.
    [[nodiscard]] const PhysicsTape* tape() const { return tape_.get(); }
    /// Whether it was of the game that played, not of how the scene begins.
    [[nodiscard]] bool wasPlaying() const { return playing_; }
    [[nodiscard]] const std::string& refusal() const { return refusal_; }
    /// For tests: until the thread is done.
    void wait() {
        if (run_ != nullptr) run_->wait();
    }

private:
    void refuse(std::string why);
    [[nodiscard]] bool stillThere(const Workspace& workspace) const;
    void recordTick(const Workspace& workspace);
    void finishTape();

    GhostGame ghost_;
    PlaySession* session_ = nullptr;  // of the ghost
    TapeRecorder recorder_;
    bool recording_ = false;
    bool playing_ = false;
    std::int64_t first_ = 0;
    std::int64_t tick_ = 0;
    std::int64_t last_ = 0;
    std::shared_ptr<const PhysicsTape> tape_;
    std::unique_ptr<WhatIfRun> run_;
    std::string refusal_;
};

}  // namespace plumb::editor
