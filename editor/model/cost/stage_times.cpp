#include "editor/model/cost/stage_times.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/simulation.hpp"
#include "scene/physics/physics_times.hpp"
#include "scene/systems/physics_system.hpp"

namespace plumb::editor {
namespace {

constexpr std::size_t kSecond = 60;  // ticks

struct StageDoc {
    std::string_view stage;
    std::string_view doc;
};
constexpr StageDoc kDocs[] = {
    {"broad phase", "Finds pairs of shapes whose boxes overlap"},
    {"narrow phase", "Computes the contact points of touching shapes"},
    {"prepare constraints", "Prepares contacts and joints for the solver"},
    {"solve", "Solves the substeps; quality sets their number"},
    {"integrators", "Moves bodies on which only fields and springs act"},
    {"finish bodies", "Stores the new poses of bodies"},
    {"continuous", "Stops fast bodies at obstacles they would pass through (CCD)"},
    {"events", "Reports contact events"},
    {"sleep", "Puts resting islands to sleep"},
    {kPhysicsSync, "Copies data between components and bodies, in both directions"},
    {"animation", "Updates frames and states of animations"},
    {"picture", "Draws the scene"},
};

StageTime timeOf(std::string_view name, bool inPhysics, std::vector<float> times) {
    StageTime time{name, {}, inPhysics, 0.0f, 0.0f};
    for (const StageDoc& row : kDocs) {
        if (row.stage == name) time.doc = row.doc;
    }
    if (times.empty()) return time;
    std::sort(times.begin(), times.end());
    time.median = times[times.size() / 2];
    const auto rank = static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(times.size())));
    time.p99 = times[rank - 1];
    return time;
}

template <class Take>
std::vector<float> lastSecond(const std::deque<Profiler::Sample>& samples, Take&& take) {
    std::vector<float> times;
    for (std::size_t i = samples.size() - std::min(samples.size(), kSecond); i < samples.size(); ++i)
        times.push_back(take(samples[i]));
    return times;
}

/// Returns the sort position of a part: stages in the order of the step, then synchronization, then systems.
std::size_t placeOf(const StageTime& time) {
    const auto stages = physics::stages();
    if (time.name == kPhysicsSync) return stages.size();
    if (!time.inPhysics) return stages.size() + 1;
    const auto found = std::find_if(stages.begin(), stages.end(),
                                    [&](const auto& stage) { return stage.name == time.name; });
    return static_cast<std::size_t>(found - stages.begin());
}

}  // namespace

std::vector<StageTime> stageTimes(const std::deque<Profiler::Sample>& samples,
                                  const std::vector<Profiler::Zone>& zones) {
    std::vector<StageTime> all;
    for (std::size_t zone = 0; zone < zones.size(); ++zone) {
        if (zones[zone].name == PhysicsSystem::kName) continue;  // its stages are listed instead
        const auto take = [zone](const Profiler::Sample& sample) {
            return zone < sample.zones.size() ? sample.zones[zone] : 0.0f;
        };
        all.push_back(timeOf(zones[zone].name, zones[zone].inPhysics, lastSecond(samples, take)));
    }
    std::stable_sort(all.begin(), all.end(), [](const StageTime& a, const StageTime& b) {
        const std::size_t placeA = placeOf(a), placeB = placeOf(b);
        return placeA != placeB ? placeA < placeB : !a.inPhysics && a.median > b.median;
    });
    all.push_back(timeOf("picture", false,
                         lastSecond(samples, [](const Profiler::Sample& sample) { return sample.drawing; })));
    std::erase_if(all, [](const StageTime& time) { return time.p99 <= 0.0f; });
    return all;
}

StageTime tickTime(const std::deque<Profiler::Sample>& samples) {
    return timeOf("tick", false,
                  lastSecond(samples, [](const Profiler::Sample& sample) { return sample.milliseconds; }));
}

}  // namespace plumb::editor
