#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <string_view>
#include <vector>

#include "core/profile.hpp"
#include "editor/model/play/play_mode.hpp"
#include "physics/manifest.hpp"

namespace plumb {
class PhysicsTimes;
}

namespace plumb::editor {

/// Measures each tick of the running game: the time of each system and each physics stage, and the number of
/// objects processed. No cost while it is not shown. The simulation does not read a clock: its schedule fills
/// the `Profile` provided to the world, if there is one.
class Profiler final : public TickListener {
public:
    static constexpr std::size_t kTicks = 600;  ///< maximum number of samples: 10 s

    /// Numbers of objects processed in a tick.
    struct Counts {
        std::uint32_t entities = 0;
        std::uint32_t bodies = 0;
        std::uint32_t awake = 0;     ///< awake bodies
        std::uint32_t contacts = 0;  ///< contacts of awake bodies
        std::uint32_t drawCalls = 0;
        std::uint32_t sprites = 0;
        std::array<std::uint32_t, physics::kEffects> requesters{};  ///< components that require each effect
    };
    /// How several threads shared the work of a physics stage.
    struct Threads {
        float shared = 0.0f;      ///< ms, wall time: duration of the parallel parts of the stage
        std::vector<float> busy;  ///< ms: time each thread worked in the parallel parts, main thread first
    };
    /// The measurements of one tick. Times are CPU time of the main thread, unless noted.
    struct Sample {
        std::int64_t tick = 0;
        bool again = false;            ///< the tick was replayed from the recording
        float milliseconds = 0.0f;     ///< ms: the whole tick
        float drawing = 0.0f;          ///< ms: drawing the frame after the tick; 0 if another tick came first
        std::vector<float> zones;      ///< ms per zone, in the order of `zones()`
        std::vector<Threads> threads;  ///< per zone, in the order of `zones()`
        Counts counts;
    };
    /// A system or a physics stage whose time is measured.
    struct Zone {
        std::string_view name;
        bool inPhysics = false;  ///< a physics stage: its time is part of the physics system's time
    };
    /// One row of the profiler table.
    struct Row {
        std::size_t zone = 0;        ///< index in `zones()`
        float chosen = 0.0f;         ///< ms in the selected tick
        float mean = 0.0f;           ///< ms, mean over all samples
        float worst = 0.0f;          ///< ms, maximum over all samples
        std::int64_t worstTick = 0;  ///< tick of the maximum
        Threads threads;             ///< means over all samples; empty if only one thread worked on the zone
    };

    explicit Profiler(PhysicsTimes& times) : times_{times} { profile_.on = false; }

    /// Requests that ticks are measured; to be called in every frame in which the profiler is shown.
    void want() { wanted_ = kFramesOfWish; }
    /// Starts or stops measuring, depending on `want` and `held`; to be called once per frame.
    void update(PlayMode& play);
    [[nodiscard]] bool measures() const { return profile_.on; }
    /// Adds the time and the numbers of drawing the frame to the sample of the last tick.
    /// @param seconds  CPU time
    void drew(double seconds, std::size_t drawCalls, std::size_t sprites);

    [[nodiscard]] const std::deque<Sample>& samples() const { return samples_; }
    [[nodiscard]] const std::vector<Zone>& zones() const { return zones_; }
    void clear();

    bool held = false;  ///< true: no new samples are taken, so that the graph stands still

    void before(World& world) override;
    void after(World& world, std::int64_t tick, bool again) override;

private:
    static constexpr int kFramesOfWish = 2;  // frames for which one call of `want` is valid

    std::size_t zoneOf(std::string_view name);

    PhysicsTimes& times_;
    Profile profile_;
    std::deque<Sample> samples_;
    std::vector<Zone> zones_;
    double start_ = 0.0;  // s: CPU time at the start of the tick
    int wanted_ = 0;      // remaining frames of the last call of `want`
};

/// Returns the rows of the profiler table: all zones by mean time, highest first, with the physics stages
/// below the physics system.
/// @param chosen  index of the selected sample
std::vector<Profiler::Row> rowsOf(const std::deque<Profiler::Sample>& samples,
                                  const std::vector<Profiler::Zone>& zones, std::size_t chosen);

/// Returns the indices of the samples that took much longer than the median.
std::vector<std::size_t> spikesOf(const std::deque<Profiler::Sample>& samples);

}  // namespace plumb::editor
