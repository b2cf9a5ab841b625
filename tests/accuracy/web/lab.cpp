#include "tests/accuracy/web/lab.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

#include "core/text.hpp"
#include "tests/accuracy/command/pages.hpp"
#include "tests/accuracy/report/chart.hpp"
#include "tests/accuracy/report/scene_texts.hpp"
#include "tests/accuracy/report/sweep.hpp"
#include "tests/accuracy/report/tables.hpp"

namespace plumb::accuracy {

namespace {

/// The reference solver takes too long for a page, so scenes without an exact answer are left out.
bool isOnPage(const Experiment& experiment) { return !experiment.has(kNoExactAnswer); }

const Experiment* findOnPage(std::string_view name) {
    const Experiment* found = findExperiment(name);
    return found != nullptr && isOnPage(*found) ? found : nullptr;
}

std::string sceneTextJson(const Experiment& experiment) {
    const SceneText& text = textOf(experiment.name);
    const auto field = [](std::string_view name, std::string_view value) {
        return format("\"{}\":{},", name, quotedForJson(value));
    };
    return format("{{}{}{}{}{}\"joints\":{},\"smooth\":{}}", field("name", experiment.name),
                  field("title", text.title), field("answer", text.answer), field("shows", text.shows),
                  field("choose", text.choose), experiment.has(kJoints), experiment.has(kSmoothForces));
}

/// Mean time of a step, µs. Clocks of browsers advance by up to 1 ms, so single steps say nothing, but their
/// mean is exact.
double microsOf(const Experiment& experiment, const Method& method, double seconds) {
    double time = 0.0;
    std::size_t steps = 0;
    do {
        Trial trial{method, experiment.gravity};
        experiment.run(trial);
        const auto times = trial.stepTimes();
        time = std::accumulate(times.begin(), times.end(), time);
        steps += times.size();
        if (times.empty()) break;
    } while (time < seconds);
    return steps > 0 ? 1.0e6 * time / static_cast<double>(steps) : 0.0;
}

}  // namespace

std::string Lab::scenesJson() {
    std::string list;
    for (const Experiment& experiment : allExperiments())
        if (isOnPage(experiment))
            list += format("{}{}", list.empty() ? "" : ",\n", sceneTextJson(experiment));
    return format("[{}]", list);
}

std::string Lab::measure(std::string_view scene, const Method& method, double seconds) {
    const Experiment* experiment = findOnPage(scene);
    if (experiment == nullptr) return "[]";
    std::vector<Row> rows = runOne(*experiment, method, {.runs = 1});
    const double micros = microsOf(*experiment, method, seconds);
    for (Row& row : rows) row.metrics.microsPerStep = micros;
    std::vector<Row>& all = rows_[std::string{scene}];
    std::erase_if(all, [&](const Row& row) { return row.method == method; });
    all.insert(all.end(), rows.begin(), rows.end());
    std::stable_sort(all.begin(), all.end(),
                     [](const Row& a, const Row& b) { return a.substeps < b.substeps; });
    return jsonOf(rows);
}

std::string Lab::record(std::string_view scene, const Method& method) {
    const Experiment* experiment = findOnPage(scene);
    if (experiment == nullptr) return "null";
    recording_ = accuracy::record(*experiment, method);
    return sceneJson(recording_);
}

std::string Lab::chart(std::string_view scene) const {
    const auto found = rows_.find(scene);
    return found != rows_.end() ? svgOf(chartOf(textOf(scene).title, found->second)) : std::string{};
}

Method methodOf(int substeps, int integrator, bool jointTrees) {
    Method method{.jointTrees = jointTrees};
    method.quality = substeps > 0
                         ? static_cast<physics::Quality>(std::bit_width(static_cast<unsigned>(substeps)) - 1)
                         : physics::kQualityOfWorld;
    method.integrator = static_cast<physics::IntegratorKind>(integrator);
    return method;
}

}  // namespace plumb::accuracy
