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

/// Measures the game that plays, tick by tick: each system, each stage of the physics, and what there is to
/// do. Costs nothing while it is not shown. The simulation itself knows no clock: it only gets the profile
/// that its schedule fills when there is one.
class Profiler final : public TickWatch {
public:
    static constexpr std::size_t kTicks = 600;  ///< kept: 10 s

    /// How much there was to do in a tick.
    struct Counts {
        std::uint32_t entities = 0;
        std::uint32_t bodies = 0;
        std::uint32_t awake = 0;     ///< bodies
        std::uint32_t contacts = 0;  ///< awake
        std::uint32_t drawCalls = 0;
        std::uint32_t sprites = 0;
        std::array<std::uint32_t, physics::kEffects> callers{};  ///< of each effect of the physics
    };
    /// How several threads shared a stage of the physics.
    struct Threads {
        float shared = 0.0f;      ///< ms, on the wall: of the main thread's rounds of shared work
        std::vector<float> busy;  ///< ms: how long each thread worked in these, the main one first
    };
    /// One tick. Times are CPU time of the main thread.
    struct Sample {
        std::int64_t tick = 0;
        bool again = false;            ///< played again, to look at the past
        float milliseconds = 0.0f;     ///< the whole tick
        float drawing = 0.0f;          ///< ms: the picture after it; 0 where another tick came before that
        std::vector<float> zones;      ///< ms, in the order of `zones()`
        std::vector<Threads> threads;  ///< in the same order
        Counts counts;
    };
    /// Something that is measured.
    struct Zone {
        std::string_view name;
        bool inPhysics = false;  ///< a stage of the physics: a part of what its system takes
    };
    /// One line of the table.
    struct Row {
        std::size_t zone = 0;
        float chosen = 0.0f;  ///< ms in the chosen tick
        float mean = 0.0f;    ///< ms a tick
        float worst = 0.0f;   ///< ms
        std::int64_t worstTick = 0;
        Threads threads;  ///< means; of none if one thread did it all
    };

    explicit Profiler(PhysicsTimes& times) : times_{times} { profile_.on = false; }

    /// It is shown in this frame.
    void want() { wanted_ = kFramesOfWish; }
    /// Once a frame: begins and ends to measure.
    void tend(PlayMode& play);
    [[nodiscard]] bool measures() const { return profile_.on; }
    /// The picture of the last tick was drawn.
    void drew(double seconds, std::size_t drawCalls, std::size_t sprites);

    [[nodiscard]] const std::deque<Sample>& samples() const { return samples_; }
    [[nodiscard]] const std::vector<Zone>& zones() const { return zones_; }
    void clear();

    bool held = false;  ///< nothing new is taken: the graph stands still

    void before(World& world) override;
    void after(World& world, std::int64_t tick, bool again) override;

private:
    static constexpr int kFramesOfWish = 2;

    std::size_t zoneOf(std::string_view name);

    PhysicsTimes& times_;
    Profile profile_;
    std::deque<Sample> samples_;
    std::vector<Zone> zones_;
    double start_ = 0.0;  // s
    int wanted_ = 0;
};

/// The table: all zones, the costliest first, a stage of the physics below its system.
/// @param chosen  of the samples
std::vector<Profiler::Row> rowsOf(const std::deque<Profiler::Sample>& samples,
                                  const std::vector<Profiler::Zone>& zones, std::size_t chosen);

/// The ticks that took much longer than most of them, for jumping to: indices of the samples.
std::vector<std::size_t> spikesOf(const std::deque<Profiler::Sample>& samples);

}  // namespace plumb::editor
