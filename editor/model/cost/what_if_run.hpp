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

/// Variant of the physics settings with which the ticks of a recording (PhysicsTape) are stepped.
enum class WhatIfKind : std::uint8_t {
    Quality,       ///< a fixed quality
    Automatic,     ///< present quality with automatic quality for hard islands
    Verlet,        ///< present quality with the Verlet integrator
    OneIteration,  ///< present quality with one iteration
    Nudged,        ///< present quality, bodies displaced by kNudge at the start: detects chaos
    Reference      ///< maximum quality with half the time step
};

/// Measured cost and error of one variant.
struct WhatIfPoint {
    WhatIfKind kind = WhatIfKind::Quality;
    int quality = 0;
    float microseconds = 0.0f;  ///< median CPU time of the physics per tick
    float overlap = 0.0f;       ///< largest overlap, m: median over the samples in the second half
    float jointError = 0.0f;    ///< largest joint gap, m: median over the samples in the second half
    float peak = 0.0f;          ///< largest overlap or gap of all samples, m, e.g. in a hard impact
    float away = -1.0f;         ///< median distance of bodies from those of Reference, m; below 0: unknown

    [[nodiscard]] float error() const { return overlap > jointError ? overlap : jointError; }
};

/// The measurements so far.
struct WhatIfResult {
    std::vector<WhatIfPoint> points;  ///< one per measured variant
    physics::Settings settings;       ///< settings of the game
    PixelScale scale;
    int ticks = 0;           ///< ticks stepped per variant
    int ticksOnTape = 0;     ///< ticks recorded
    std::size_t bodies = 0;  ///< number of dynamic bodies
    bool complete = false;   ///< all variants are measured
    bool isChaotic = false;  ///< a tiny displacement at the start (kNudge) becomes large
    float hair = 0.0f;       ///< median distance of bodies due to that displacement, m

    [[nodiscard]] const WhatIfPoint* find(WhatIfKind kind, int quality = -1) const;  ///< -1: any; null: none
    [[nodiscard]] const WhatIfPoint* present() const {
        return find(settings.automaticQuality ? WhatIfKind::Automatic : WhatIfKind::Quality,
                    settings.quality);
    }
};

/// Steps the ticks of a recording with all variants of the settings, in a thread of its own. Depends only on
/// the physics, not on a game.
class WhatIfRun {
public:
    static constexpr double kBudget = 1.2;     ///< CPU time, s; expensive scenes step fewer ticks
    static constexpr int kReferenceParts = 2;  ///< physics steps per tick of the reference
    static constexpr float kNudge = 1.0e-5f;   ///< initial displacement of variant Nudged, m

    explicit WhatIfRun(std::shared_ptr<const PhysicsTape> tape);
    ~WhatIfRun();
    WhatIfRun(const WhatIfRun&) = delete;
    WhatIfRun& operator=(const WhatIfRun&) = delete;

    [[nodiscard]] WhatIfResult result() const;
    [[nodiscard]] float progress() const { return progress_; }  ///< 0 to 1
    [[nodiscard]] bool done() const { return done_; }
    /// For tests: waits until it is done.
    void wait();

private:
    struct Track;

    void work();
    void chooseStart();
    [[nodiscard]] std::vector<WhatIfPoint> variants() const;
    Track follow(const WhatIfPoint& variant, const PhysicsTape::Start& start, std::size_t ticks);
    void compare(const std::vector<Track>& tracks);

    std::shared_ptr<const PhysicsTape> tape_;
    const PhysicsTape::Start* start_ = nullptr;
    std::size_t ticks_ = 0;
    double stepsToDo_ = 1.0;  // approximate substeps of all variants, for the progress
    double stepsDone_ = 0.0;
    mutable std::mutex mutex_;  // guards result_
    WhatIfResult result_;
    std::atomic<float> progress_ = 0.0f;
    std::atomic<bool> cancelled_ = false;
    std::atomic<bool> done_ = false;
    std::thread thread_;
};

}  // namespace plumb::editor
