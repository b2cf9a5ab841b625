#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "editor/model/cost/physics_tape.hpp"

namespace plumb::editor {

/// How the ticks of a tape are stepped again.
enum class WhatIfKind : std::uint8_t {
    Quality,       ///< at one quality
    Automatic,     ///< at the present quality, hard islands more
    Verlet,        ///< the present quality with that integrator
    OneIteration,  ///< the present quality with one iteration
    Nudged,        ///< the present quality, begun a hair aside: tells chaos from error
    Reference      ///< the highest quality with half the step
};

/// What one way of stepping cost, and how far off it was.
struct WhatIfPoint {
    WhatIfKind kind = WhatIfKind::Quality;
    int quality = 0;
    float microseconds = 0.0f;  ///< CPU time of a tick's physics: the median
    float overlap = 0.0f;       ///< m: the largest of a look; of all looks in the second half the median
    float jointError = 0.0f;    ///< m: the same of the gaps of joints
    float peak = 0.0f;          ///< m: the largest of all looks, e.g. when something hits hard
    float away = -1.0f;  ///< m: from the reference, half of the bodies more and half less; below 0: not known

    [[nodiscard]] float error() const { return overlap > jointError ? overlap : jointError; }
};

/// What is known so far.
struct WhatIfResult {
    std::vector<WhatIfPoint> points;
    physics::Settings settings;  ///< those of the game
    PixelScale scale;
    int ticks = 0;           ///< that each way was stepped
    int ticksOnTape = 0;     ///< that it could have been
    std::size_t bodies = 0;  ///< that can be pushed
    bool complete = false;
    bool isChaotic = false;  ///< a hair's difference at the start becomes large
    float hair = 0.0f;       ///< m: what became of it

    [[nodiscard]] const WhatIfPoint* find(WhatIfKind kind, int quality = -1) const;
    [[nodiscard]] const WhatIfPoint* present() const {
        return find(settings.automaticQuality ? WhatIfKind::Automatic : WhatIfKind::Quality,
                    settings.quality);
    }
};

/// Steps the ticks of a tape again in all ways, in a thread of its own. Knows no game: only physics.
class WhatIfRun {
public:
    static constexpr double kBudget = 1.2;     ///< s of CPU: with more to do, fewer ticks are stepped
    static constexpr int kReferenceParts = 2;  ///< steps of the reference in a tick
    static constexpr float kNudge = 1.0e-5f;   ///< m

    explicit WhatIfRun(std::shared_ptr<const PhysicsTape> tape);
    ~WhatIfRun();
    WhatIfRun(const WhatIfRun&) = delete;
    WhatIfRun& operator=(const WhatIfRun&) = delete;

    [[nodiscard]] WhatIfResult result() const;
    [[nodiscard]] float progress() const { return progress_; }  ///< ratio
    [[nodiscard]] bool done() const { return done_; }
    /// For tests: until it is done.
    void wait();

private:
    struct Track;

    void work();
    void chooseStart();
    [[nodiscard]] std::vector<WhatIfPoint> ways() const;
    Track follow(const WhatIfPoint& way, const PhysicsTape::Start& start, std::size_t ticks);
    void compare(const std::vector<Track>& tracks);

    std::shared_ptr<const PhysicsTape> tape_;
    const PhysicsTape::Start* start_ = nullptr;
    std::size_t ticks_ = 0;
    double stepsToDo_ = 1.0;  // substeps of all ways, roughly: for the progress
    double stepsDone_ = 0.0;
    mutable std::mutex mutex_;  // of result_
    WhatIfResult result_;
    std::atomic<float> progress_ = 0.0f;
    std::atomic<bool> cancelled_ = false;
    std::atomic<bool> done_ = false;
    std::thread thread_;
};

}  // namespace plumb::editor
