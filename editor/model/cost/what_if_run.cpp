#include "editor/model/cost/what_if_run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/clock.hpp"
#include "physics/islands/island_report.hpp"
#include "physics/simulation.hpp"

namespace plumb::editor {
namespace {

constexpr float kTick = 1.0f / 60.0f;       // s
constexpr std::size_t kEvery = 3;           // ticks between two samples of the errors
constexpr std::size_t kProbe = 8;           // ticks stepped to estimate the cost
constexpr float kGrown = 1.0e-3f;           // m; chaotic if the nudge grows to more than this …
constexpr float kPartOfDifference = 0.25f;  // … and to more than this part of the distance to the reference

float medianOf(std::vector<float> values) {
    if (values.empty()) return 0.0f;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double substepsOf(const WhatIfPoint& variant) {
    const double steps = std::exp2(variant.quality);
    return variant.kind == WhatIfKind::Reference ? steps * WhatIfRun::kReferenceParts : steps;
}

/// Returns a copy of the start with the settings of a variant. No body sleeps, so that resting bodies are
/// measured too.
physics::World worldFor(const WhatIfPoint& variant, const physics::World& start) {
    physics::World world = start;
    physics::Settings& settings = world.settings;
    settings.sleeping = false;
    settings.tolerance = 0.0f;  // a tolerance would let the errors of islands change their quality
    settings.quality = static_cast<physics::Quality>(variant.quality);
    settings.automaticQuality = variant.kind == WhatIfKind::Automatic;
    if (variant.kind == WhatIfKind::Verlet) settings.integrator = physics::IntegratorKind::Verlet;
    if (variant.kind == WhatIfKind::OneIteration) settings.iterations = 1;
    for (std::uint32_t body = 0; body < world.bodies.size(); ++body) {
        const physics::BodyInfo& info = world.bodies.info[body];
        if (info.kind != physics::BodyKind::Dynamic) continue;
        setAwake(world, {body, info.generation}, true);
        if (variant.kind != WhatIfKind::Nudged) continue;
        physics::WorldPosition& centre = world.bodies.pose[body].centre;
        centre.x += static_cast<double>(body % 2 == 0 ? WhatIfRun::kNudge : -WhatIfRun::kNudge);
    }
    return world;
}

}  // namespace

/// The recorded samples of one run.
struct WhatIfRun::Track {
    WhatIfPoint point;
    /// Displacement from the start, m, by sample and watched body; NaN for a destroyed body.
    std::vector<std::vector<Vec2>> places;
};

const WhatIfPoint* WhatIfResult::find(WhatIfKind kind, int quality) const {
    const auto found = std::find_if(points.begin(), points.end(), [&](const WhatIfPoint& point) {
        return point.kind == kind && (quality < 0 || point.quality == quality);
    });
    return found == points.end() ? nullptr : &*found;
}

WhatIfRun::WhatIfRun(std::shared_ptr<const PhysicsTape> tape) : tape_{std::move(tape)} {
    result_.scale = tape_->scale;
    result_.ticksOnTape = static_cast<int>(tape_->ticks.size());
    result_.bodies = tape_->watched.size();
    result_.settings = tape_->starts.back().world.settings;
    thread_ = std::thread{[this] { work(); }};
}

WhatIfRun::~WhatIfRun() {
    cancelled_ = true;
    wait();
}

void WhatIfRun::wait() {
    if (thread_.joinable()) thread_.join();
}

WhatIfResult WhatIfRun::result() const {
    const std::lock_guard lock{mutex_};
    return result_;
}

std::vector<WhatIfPoint> WhatIfRun::variants() const {
    const physics::Settings& settings = result_.settings;
    const int present = settings.quality;
    std::vector<WhatIfPoint> all;
    const auto add = [&](WhatIfKind kind, int quality) { all.push_back({kind, quality}); };
    for (int quality = 0; quality <= physics::kMaxQuality; ++quality) add(WhatIfKind::Quality, quality);
    add(WhatIfKind::Automatic, present);
    const auto integrator = settings.integrator;
    if (integrator == physics::IntegratorKind::Rk4 || integrator == physics::IntegratorKind::ExplicitEuler)
        add(WhatIfKind::Verlet, present);
    if (settings.iterations > 1) add(WhatIfKind::OneIteration, present);
    add(WhatIfKind::Nudged, present);
    add(WhatIfKind::Reference, physics::kMaxQuality);
    return all;
}

/// Chooses the earliest start that fits into the time budget. All variants step the same ticks, up to the end
/// of the tape.
void WhatIfRun::chooseStart() {
    const PhysicsTape::Start& last = tape_->starts.back();
    const std::size_t probe = std::min(kProbe, tape_->ticks.size() - last.tick);
    const float cheap = follow({WhatIfKind::Quality, 0}, last, probe).point.microseconds;
    const float dear = follow({WhatIfKind::Quality, 4}, last, probe).point.microseconds;
    const double substep = std::max(static_cast<double>(dear - cheap), 0.0) / 15.0;
    double substeps = 0.0;
    double tick = 0.0;  // µs, of all variants
    for (const WhatIfPoint& variant : variants()) {
        substeps += substepsOf(variant);
        tick += static_cast<double>(cheap) + substepsOf(variant) * substep;
    }
    start_ = &last;
    for (const PhysicsTape::Start& start : tape_->starts) {
        const auto count = static_cast<double>(tape_->ticks.size() - start.tick);
        if (count * tick * 1.0e-6 > kBudget) continue;
        start_ = &start;
        break;
    }
    ticks_ = tape_->ticks.size() - start_->tick;
    stepsToDo_ = substeps * static_cast<double>(ticks_);
    stepsDone_ = 0.0;
}

WhatIfRun::Track WhatIfRun::follow(const WhatIfPoint& variant, const PhysicsTape::Start& start,
                                   std::size_t ticks) {
    Track track{variant, {}};
    physics::World world = worldFor(variant, start.world);
    const int parts = variant.kind == WhatIfKind::Reference ? kReferenceParts : 1;
    const float dt = kTick / static_cast<float>(parts);
    std::vector<float> times, overlaps, jointErrors;
    for (std::size_t tick = 0; tick < ticks && !cancelled_; ++tick) {
        const TickInput& input = tape_->ticks[start.tick + tick];
        double seconds = 0.0;
        for (int part = 0; part < parts; ++part) {
            applyInput(world, input, part);
            const double begin = threadSeconds();
            physics::step(world, dt);
            seconds += threadSeconds() - begin;
        }
        times.push_back(static_cast<float>(seconds * 1.0e6));
        stepsDone_ += substepsOf(variant);
        progress_ = static_cast<float>(std::min(stepsDone_ / stepsToDo_, 1.0));
        if (tick < ticks / 2 || (ticks - 1 - tick) % kEvery != 0) continue;
        float overlap = 0.0f, jointError = 0.0f;
        for (const physics::IslandReport& island : physics::reportIslands(world)) {
            overlap = std::max(overlap, island.overlap);
            jointError = std::max(jointError, island.jointError);
        }
        overlaps.push_back(overlap);
        jointErrors.push_back(jointError);
        track.point.peak = std::max({track.point.peak, overlap, jointError});
        std::vector<Vec2>& places = track.places.emplace_back();
        for (const WatchedBody& watched : tape_->watched) {
            const bool known = alive(world, watched.body) && alive(start.world, watched.body);
            places.push_back(known ? centreOf(world, watched.body) - centreOf(start.world, watched.body)
                                   : Vec2{NAN, NAN});
        }
    }
    track.point.microseconds = medianOf(std::move(times));
    track.point.overlap = medianOf(std::move(overlaps));
    track.point.jointError = medianOf(std::move(jointErrors));
    return track;
}

namespace {

/// Returns the distance of the bodies between two variants, m: mean over the samples, median over the bodies;
/// -1 if unknown.
float medianDistance(const std::vector<std::vector<Vec2>>& a, const std::vector<std::vector<Vec2>>& b) {
    if (a.empty() || a.size() != b.size()) return -1.0f;
    std::vector<float> means;
    for (std::size_t body = 0; body < a.front().size(); ++body) {
        float sum = 0.0f;
        for (std::size_t look = 0; look < a.size(); ++look) sum += distance(a[look][body], b[look][body]);
        if (std::isfinite(sum)) means.push_back(sum / static_cast<float>(a.size()));
    }
    return means.empty() ? -1.0f : medianOf(std::move(means));
}

}  // namespace

void WhatIfRun::compare(const std::vector<Track>& tracks) {
    const auto trackOf = [&](WhatIfKind kind, int quality) -> const Track& {
        return *std::find_if(tracks.begin(), tracks.end(), [&](const Track& track) {
            return track.point.kind == kind && track.point.quality == quality;
        });
    };
    const int present = result_.settings.quality;
    const Track& reference = trackOf(WhatIfKind::Reference, physics::kMaxQuality);
    const Track& plain = trackOf(WhatIfKind::Quality, present);
    const float hair = medianDistance(plain.places, trackOf(WhatIfKind::Nudged, present).places);
    const float difference = medianDistance(plain.places, reference.places);
    const std::lock_guard lock{mutex_};
    result_.hair = hair;
    result_.isChaotic = hair > kGrown && hair > kPartOfDifference * difference;
    for (std::size_t i = 0; i < result_.points.size(); ++i) {
        if (!result_.isChaotic) result_.points[i].away = medianDistance(tracks[i].places, reference.places);
    }
    result_.complete = true;
}

void WhatIfRun::work() {
    chooseStart();
    {
        const std::lock_guard lock{mutex_};
        result_.ticks = static_cast<int>(ticks_);
    }
    std::vector<Track> tracks;
    for (const WhatIfPoint& variant : variants()) {
        tracks.push_back(follow(variant, *start_, ticks_));
        if (cancelled_) break;
        const std::lock_guard lock{mutex_};
        result_.points.push_back(tracks.back().point);
    }
    if (!cancelled_) compare(tracks);
    progress_ = 1.0f;
    done_ = true;
}

}  // namespace plumb::editor
