#include "tests/accuracy/report/sweep.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "tests/accuracy/reference_error.hpp"

namespace plumb::accuracy {

namespace {

constexpr double kEnoughTime = 0.5;  // longer runs are not repeated, as their times vary little, s
constexpr physics::Quality kIterated[] = {0, 2, 4};  // qualities that are also run with more iterations

std::vector<physics::Quality> qualitiesOf(const SweepOptions& options) {
    if (!options.qualities.empty()) return options.qualities;
    if (options.quick) return {0, 2, 4};
    return {0, 1, 2, 3, 4, 5, 6};
}

int substepsOf(const Method& method) {
    return method.peer != nullptr || method.quality == physics::kQualityOfWorld ? 0 : 1 << method.quality;
}

/// Estimates the time of a run, in arbitrary units.
double workOf(const Experiment& experiment, const Method& method) {
    const double substeps = std::max(substepsOf(method), 8) * method.iterations;
    return (experiment.quick ? 1.0 : 15.0) * (8.0 + substeps);
}

std::string wordsFor(const Experiment& experiment, const Method& method) {
    const std::string solver = solverName(method, experiment.has(kJoints));
    if (method.peer != nullptr) return solver;
    if (method.quality == physics::kQualityOfWorld) return format("{}, automatic substeps", solver);
    return format("{}, {} substeps", solver, substepsOf(method));
}

Row rowOf(const Experiment& experiment, const Method& method, const Finding& finding) {
    return {.scene = std::string{experiment.name},
            .figure = finding.name,
            .method = method,
            .solver = solverName(method, experiment.has(kJoints)),
            .integrator = method.peer != nullptr ? "its own" : std::string{integratorName(method.integrator)},
            .substeps = substepsOf(method),
            .error = finding.error,
            .unit = finding.unit,
            .target = finding.target,
            .usTarget = experiment.micros};
}

}  // namespace

std::vector<Method> methodsOf(const Experiment& experiment, const SweepOptions& options) {
    using physics::IntegratorKind;
    std::vector<Method> methods;
    const std::vector<physics::Quality> qualities = qualitiesOf(options);
    const auto addAll = [&](const Method& like) {
        for (const physics::Quality quality : qualities) {
            methods.push_back(like);
            methods.back().quality = quality;
        }
    };
    addAll({});
    if (experiment.has(kJoints)) addAll({.jointTrees = false});
    if (experiment.has(kSmoothForces)) {
        for (const IntegratorKind kind :
             {IntegratorKind::ExplicitEuler, IntegratorKind::Verlet, IntegratorKind::Rk4})
            addAll({.integrator = kind});
    }
    // Solver settings have no effect on scenes with only smooth forces.
    if (!options.quick && options.qualities.empty() && !experiment.has(kSmoothForces)) {
        for (const bool trees : {true, false}) {
            if (!trees && !experiment.has(kJoints)) continue;
            for (const physics::Quality quality : kIterated) {
                if (!experiment.quick && quality != Method{}.quality) continue;  // would take minutes
                for (const int iterations : {2, 4, 8})
                    methods.push_back({.quality = quality, .iterations = iterations, .jointTrees = trees});
            }
        }
    }
    if (options.qualities.empty() && !experiment.has(kSmoothForces))
        methods.push_back({.quality = physics::kQualityOfWorld});
    if (experiment.has(kAnyEngine)) {
        for (const scenes::Engine& engine : options.peers) methods.push_back({.peer = &engine});
    }
    return methods;
}

std::vector<const Experiment*> chosen(const SweepOptions& options) {
    std::vector<const Experiment*> list;
    for (const Experiment& experiment : allExperiments()) {
        if (options.scene.empty() ? !options.quick || experiment.quick : options.scene == experiment.name)
            list.push_back(&experiment);
    }
    return list;
}

std::vector<Row> runOne(const Experiment& experiment, const Method& method, const SweepOptions& options) {
    std::vector<Row> rows;
    Metrics metrics;
    double spent = 0.0;  // wall time, s
    for (int run = 0; run < options.runs && (run == 0 || spent < kEnoughTime); ++run) {
        Trial trial{method, experiment.gravity, options.count};
        experiment.run(trial);
        spent += trial.microsPerStep() * trial.time() * 60.0e-6;
        if (run > 0) {
            metrics.microsPerStep = std::min(metrics.microsPerStep, trial.microsPerStep());
            continue;
        }
        if (!trial.scene().missing().empty()) return {};
        metrics = trial.metrics();
        for (const Finding& finding : trial.findings()) rows.push_back(rowOf(experiment, method, finding));
        if (experiment.has(kNoExactAnswer) && trial.start()) {
            if (const auto error =
                    referenceError(experiment.name, *trial.start(), trial.world(), trial.time()))
                // Never the first row, as that is plotted with other engines, which lack this figure.
                rows.push_back(rowOf(experiment, method, {"place", *error * 1000.0, "mm", kNoTarget}));
        }
    }
    if (!rows.empty()) {
        rows.front().main = true;
        rows.front().fails =
            std::any_of(rows.begin() + 1, rows.end(), [](const Row& row) { return !row.met(); });
    }
    for (Row& row : rows) row.metrics = metrics;
    return rows;
}

std::vector<Row> sweep(const SweepOptions& options, const std::function<void(const Progress&)>& progress,
                       const std::function<void(std::span<const Row>)>& done) {
    struct Job {
        const Experiment* experiment;
        Method method;
    };
    std::vector<Job> jobs;
    double all = 0.0, behind = 0.0;
    for (const Experiment* experiment : chosen(options)) {
        for (const Method& method : methodsOf(*experiment, options)) {
            jobs.push_back({experiment, method});
            all += workOf(*experiment, method);
        }
    }
    std::vector<Row> rows;
    std::size_t sceneBegin = 0;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        const auto& [experiment, method] = jobs[i];
        progress({experiment, wordsFor(*experiment, method), i + 1, jobs.size(), behind / all});
        const std::vector<Row> more = runOne(*experiment, method, options);
        rows.insert(rows.end(), more.begin(), more.end());
        behind += workOf(*experiment, method);
        if (i + 1 == jobs.size() || jobs[i + 1].experiment != experiment) {
            done(std::span{rows}.subspan(sceneBegin));
            sceneBegin = rows.size();
        }
    }
    return rows;
}

}  // namespace plumb::accuracy
