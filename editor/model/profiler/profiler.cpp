#include "editor/model/profiler/profiler.hpp"

#include <algorithm>
#include <utility>

#include "core/clock.hpp"
#include "ecs/world.hpp"
#include "physics/simulation.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/physics/physics_times.hpp"
#include "scene/systems/physics_system.hpp"

namespace plumb::editor {
namespace {

constexpr std::string_view kPhysics = PhysicsSystem::kName;
constexpr float kSpikeTimes = 2.5f;  // a spike takes at least this multiple of the median time ...
constexpr float kLeastSpike = 0.5f;  // ... and at least this many ms more than the median

float milliseconds(double seconds) { return static_cast<float>(seconds * 1000.0); }

bool isStage(std::string_view name) {
    const auto stages = physics::stages();
    return name == kPhysicsSync ||
           std::any_of(stages.begin(), stages.end(), [&](const auto& stage) { return stage.name == name; });
}

Profiler::Counts countsOf(const World& world) {
    Profiler::Counts counts;
    counts.entities = static_cast<std::uint32_t>(world.entityCount());
    if (const auto* state = world.findResource<PhysicsState>()) {
        const physics::World& physics = state->world;
        counts.bodies = static_cast<std::uint32_t>(physics.bodies.size() - physics.bodies.free.size());
        counts.awake = static_cast<std::uint32_t>(physics.awake.size());
        counts.requesters = physics.manifest.requesters;
        counts.contacts = static_cast<std::uint32_t>(physics.contacts.size());
    }
    return counts;
}

}  // namespace

void Profiler::update(PlayMode& play) {
    const bool on = wanted_ > 0 && !held && play.running();
    if (wanted_ > 0) --wanted_;
    profile_.on = on;
    play.tickListener = on ? this : nullptr;
}

void Profiler::clear() {
    samples_.clear();
    zones_.clear();
}

std::size_t Profiler::zoneOf(std::string_view name) {
    for (std::size_t i = 0; i < zones_.size(); ++i) {
        if (zones_[i].name == name) return i;
    }
    zones_.push_back({name, isStage(name)});
    return zones_.size() - 1;
}

void Profiler::before(World& world) {
    if (world.service<Profile>() != &profile_) {
        world.provide(profile_);
        clear();
    }
    profile_.reset();
    start_ = threadSeconds();
}

void Profiler::after(World& world, std::int64_t tick, bool again) {
    Sample sample{.tick = tick, .again = again, .milliseconds = milliseconds(threadSeconds() - start_)};
    sample.counts = countsOf(world);
    for (const Profile::Zone& zone : profile_.zones()) {
        const std::size_t at = zoneOf(zone.name);
        if (sample.zones.size() <= at) sample.zones.resize(at + 1), sample.threads.resize(at + 1);
        sample.zones[at] = milliseconds(zone.seconds);
        sample.threads[at].shared = milliseconds(zone.rounds);
        for (const double busy : zone.busy) sample.threads[at].busy.push_back(milliseconds(busy));
    }
    times_.take(profile_);
    samples_.push_back(std::move(sample));
    if (samples_.size() > kTicks) samples_.pop_front();
}

void Profiler::drew(double seconds, std::size_t drawCalls, std::size_t sprites) {
    if (samples_.empty() || held) return;
    Sample& last = samples_.back();
    last.drawing = milliseconds(seconds);
    last.counts.drawCalls = static_cast<std::uint32_t>(drawCalls);
    last.counts.sprites = static_cast<std::uint32_t>(sprites);
}

namespace {

/// Means over all samples, including those in which only one thread worked on the zone.
Profiler::Threads threadsOf(const std::deque<Profiler::Sample>& samples, std::size_t zone) {
    Profiler::Threads mean;
    const float part = 1.0f / static_cast<float>(std::max<std::size_t>(samples.size(), 1));
    for (const Profiler::Sample& sample : samples) {
        if (zone >= sample.threads.size()) continue;
        const Profiler::Threads& threads = sample.threads[zone];
        mean.shared += part * threads.shared;
        mean.busy.resize(std::max(mean.busy.size(), threads.busy.size()));
        for (std::size_t i = 0; i < threads.busy.size(); ++i) mean.busy[i] += part * threads.busy[i];
    }
    return mean;
}

}  // namespace

std::vector<Profiler::Row> rowsOf(const std::deque<Profiler::Sample>& samples,
                                  const std::vector<Profiler::Zone>& zones, std::size_t chosen) {
    std::vector<Profiler::Row> rows(zones.size());
    for (std::size_t zone = 0; zone < rows.size(); ++zone) {
        Profiler::Row& row = rows[zone];
        row.zone = zone;
        row.threads = threadsOf(samples, zone);
        float sum = 0.0f;
        for (const Profiler::Sample& sample : samples) {
            const float time = zone < sample.zones.size() ? sample.zones[zone] : 0.0f;
            sum += time;
            if (time > row.worst) row.worst = time, row.worstTick = sample.tick;
        }
        if (!samples.empty()) row.mean = sum / static_cast<float>(samples.size());
        if (chosen < samples.size() && zone < samples[chosen].zones.size())
            row.chosen = samples[chosen].zones[zone];
    }
    // The stages of the physics are sorted directly below the system that runs them.
    const auto systemCost = [&](const Profiler::Row& row) {
        if (!zones[row.zone].inPhysics) return row.mean;
        for (const Profiler::Row& other : rows) {
            if (zones[other.zone].name == kPhysics) return other.mean;
        }
        return 0.0f;
    };
    std::vector<std::pair<float, Profiler::Row>> sorted;
    for (const Profiler::Row& row : rows) sorted.emplace_back(systemCost(row), row);
    std::stable_sort(sorted.begin(), sorted.end(), [&](const auto& a, const auto& b) {
        if (a.first != b.first) return a.first > b.first;
        const bool partA = zones[a.second.zone].inPhysics;
        const bool partB = zones[b.second.zone].inPhysics;
        return partA != partB ? partB : a.second.mean > b.second.mean;
    });
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = sorted[i].second;
    return rows;
}

std::vector<std::size_t> spikesOf(const std::deque<Profiler::Sample>& samples) {
    std::vector<float> times;
    for (const Profiler::Sample& sample : samples) times.push_back(sample.milliseconds);
    if (times.empty()) return {};
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    const float least = std::max(*middle * kSpikeTimes, *middle + kLeastSpike);
    std::vector<std::size_t> spikes;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (samples[i].milliseconds >= least) spikes.push_back(i);
    }
    return spikes;
}

}  // namespace plumb::editor
