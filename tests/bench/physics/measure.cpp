#include "tests/bench/physics/measure.hpp"

#include <algorithm>
#include <numeric>

#include "core/clock.hpp"
#include "core/text.hpp"
#include "tests/bench/physics/progress.hpp"

namespace plumb::scenes {

namespace {

constexpr int kContactSample = 16;  // steps between two counts of contacts
constexpr int kErrorSamples = 16;   // error samples in the second half of a run
constexpr int kLostSample = 8;      // steps between two checks for a lost scene
constexpr double kMinTime = 0.3;    // s: small scenes run at least this long
constexpr int kMaxRuns = 200;
constexpr double kMilliseconds = 1e3;

/// A contender and its results so far.
struct Lane {
    Contender contender;
    Measurement measurement;
    std::vector<double> best;  ///< s per step, minimum of each sample over all runs
    double seconds = 0.0;      ///< total time of all runs
    int runs = 0;
    std::vector<double> samples;  ///< s per step, of the current run
};

int stepsOf(const Scene& scene, const MeasureOptions& options) {
    const int steps = options.steps > 0 ? std::min(options.steps, scene.steps) : scene.steps;
    return std::max(steps / scene.batch, 1) * scene.batch;
}

/// Mean number of contacts, counted outside of the measured time.
class ContactMean {
public:
    void look(const SceneBuilder& world, int step) {
        if (step < next_) return;
        next_ = step + kContactSample;
        sum_ += static_cast<double>(world.contactCount());
        ++count_;
    }
    [[nodiscard]] double mean() const { return count_ > 0 ? sum_ / count_ : 0.0; }

private:
    int next_ = 0;
    int count_ = 0;
    double sum_ = 0.0;
};

/// Mean error over the second half of a run, because a single sample of tumbling bodies would be random.
class ErrorMean {
public:
    explicit ErrorMean(int steps) : next_{steps / 2}, pause_{std::max(steps / (2 * kErrorSamples), 1)} {}

    void look(const SceneBuilder& world, int step) {
        if (step < next_) return;
        next_ = step + pause_;
        add(errorOf(world));
    }
    /// Returns the mean of all samples. @param last  error at the end of the run, the last sample
    [[nodiscard]] SceneError mean(const SceneError& last) {
        add(last);
        sum_.maxPenetration /= count_;
        sum_.meanPenetration /= count_;
        sum_.overlaps = last.overlaps;
        sum_.maxJointError /= count_;
        sum_.meanJointError /= count_;
        return sum_;
    }

private:
    void add(const SceneError& error) {
        sum_.maxPenetration += error.maxPenetration;
        sum_.meanPenetration += error.meanPenetration;
        sum_.maxJointError += error.maxJointError;
        sum_.meanJointError += error.meanJointError;
        sum_.finite = sum_.finite && error.finite;
        ++count_;
    }

    int next_;
    int pause_;
    int count_ = 0;
    SceneError sum_;
};

void judge(Lane& lane, const SceneBuilder& world, double contacts, ErrorMean& errors) {
    Measurement& result = lane.measurement;
    result.contacts = contacts;
    result.lastContacts = world.contactCount();
    const auto bodies = world.bodies();
    result.bodies = static_cast<std::size_t>(
        std::count_if(bodies.begin(), bodies.end(), [](const auto& body) { return body.alive; }));
    result.error = errors.mean(errorOf(world));
}

void keepStages(Lane& lane, const SceneBuilder& world, int steps) {
    std::vector<Profile::Zone> stages = world.stages();
    for (Profile::Zone& zone : stages) {
        zone.seconds *= kMilliseconds / steps;
        zone.rounds *= kMilliseconds / steps;
        for (double& busy : zone.busy) busy *= kMilliseconds / steps;
    }
    if (!stages.empty()) lane.measurement.stages = std::move(stages);
}

/// Runs a scene once. @return false if the engine lacks a feature of the scene
bool runOnce(const Scene& scene, Lane& lane, int steps, bool profiled) {
    const double opened = wallSeconds();
    const std::unique_ptr<SceneBuilder> world =
        lane.contender.engine->open({.gravity = scene.gravity,
                                     .sleeping = scene.sleeping,
                                     .quality = scene.quality,
                                     .threads = lane.contender.threads,
                                     .profiled = profiled});
    const BeforeStep before = scene.build(*world, scene.size);
    if (before && world->missing().empty()) before(*world, 0);  // may be the first to use a missing feature
    if (!world->missing().empty()) {
        lane.measurement.missing = world->missing();
        return false;
    }
    world->finish();
    for (int i = 0; i < scene.warmUp; ++i) world->step(kStep);
    lane.samples.clear();
    ContactMean contacts;
    ErrorMean errors{steps};
    for (int step = 0; step < steps; step += scene.batch) {
        const double start = wallSeconds();
        for (int i = step; i < step + scene.batch; ++i) {
            if (before && i > 0) before(*world, i);
            world->step(kStep);
        }
        lane.samples.push_back((wallSeconds() - start) / scene.batch);
        contacts.look(*world, step);
        if (lane.runs == 0) errors.look(*world, step);
        if (step % kLostSample < scene.batch && isLost(*world)) {
            steps = step + scene.batch;
            lane.measurement.lostAfter = steps;
        }
    }
    if (lane.runs == 0) judge(lane, *world, contacts.mean(), errors);
    keepStages(lane, *world, steps);
    lane.seconds += wallSeconds() - opened;
    return true;
}

double meanAfterFirst(const std::vector<double>& samples) {
    if (samples.size() == 1) return samples.front();
    return std::accumulate(samples.begin() + 1, samples.end(), 0.0) / static_cast<double>(samples.size() - 1);
}

void keepBest(Lane& lane) {
    Measurement& result = lane.measurement;
    const double mean = meanAfterFirst(lane.samples) * kMilliseconds;
    if (lane.runs == 0) {
        lane.best = lane.samples;
        result.msPerStep = mean;
    }
    result.msPerStep = std::min(result.msPerStep, mean);
    for (std::size_t i = 0; i < std::min(lane.best.size(), lane.samples.size()); ++i)
        lane.best[i] = std::min(lane.best[i], lane.samples[i]);
    ++lane.runs;
}

void conclude(Lane& lane) {
    Measurement& result = lane.measurement;
    if (lane.best.empty()) return;
    result.firstMs = lane.best.front() * kMilliseconds;
    result.quietMs = meanAfterFirst(lane.best) * kMilliseconds;
    std::vector<double> sorted = lane.best;
    std::sort(sorted.begin(), sorted.end());
    result.medianMs = sorted[sorted.size() / 2] * kMilliseconds;
}

bool wantsMore(const Lane& lane, const MeasureOptions& options) {
    if (!lane.measurement.missing.empty()) return false;
    if (lane.runs == 0) return true;
    if (lane.seconds > options.patience || lane.runs >= kMaxRuns) return false;
    return lane.runs < options.runs || (options.runs > 1 && lane.seconds < kMinTime);
}

void announce(const Scene& scene, const Lane& lane) {
    showProgress(format("{}: {}, {} thread(s), run {}", scene.name, lane.contender.engine->name,
                        lane.contender.threads, lane.runs + 1));
}

}  // namespace

std::vector<Measurement> measure(const Scene& scene, std::span<const Contender> contenders,
                                 const MeasureOptions& options) {
    const int steps = stepsOf(scene, options);
    std::vector<Lane> lanes;
    for (const Contender& contender : contenders) {
        lanes.push_back({contender});
        Measurement& result = lanes.back().measurement;
        result.scene = scene.name;
        result.engine = contender.engine->name;
        result.threads = contender.threads;
        result.size = scene.size;
        result.steps = steps;
    }
    for (bool busy = true; busy;) {
        busy = false;
        for (Lane& lane : lanes) {
            if (!wantsMore(lane, options)) continue;
            if (options.loud) announce(scene, lane);
            if (runOnce(scene, lane, steps, false)) keepBest(lane);
            busy = true;
        }
    }
    for (Lane& lane : lanes) {
        if (!options.stages || !lane.contender.engine->profiles || !lane.measurement.missing.empty())
            continue;
        if (options.loud) announce(scene, lane);
        static_cast<void>(runOnce(scene, lane, steps, true));
    }
    if (options.loud) showProgress({});
    std::vector<Measurement> results;
    for (Lane& lane : lanes) {
        conclude(lane);
        results.push_back(std::move(lane.measurement));
    }
    return results;
}

}  // namespace plumb::scenes
