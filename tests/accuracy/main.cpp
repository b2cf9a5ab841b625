// Experiments with known answers: what each quality reaches, in which time, beside what it should.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "core/file.hpp"
#include "core/text.hpp"
#include "tests/accuracy/experiments.hpp"

namespace {

using namespace plumb;
using namespace plumb::accuracy;

struct Options {
    std::string scene;  // empty for all
    std::string json;
    bool quick = false;
    int runs = 3;  // of each, of which the fastest counts
    std::vector<physics::Quality> qualities{2, 3, 4, 5, physics::kQualityOfWorld};
};

int usage() {
    std::fprintf(stderr,
                 "plumb-accuracy-physics [--scene NAME] [--quick] [--runs N] [--quality 0..6] [--json FILE]\n"
                 "Scenes:");
    for (const Experiment& experiment : allExperiments())
        std::fprintf(stderr, " %s", std::string(experiment.name).c_str());
    std::fprintf(stderr, "\n");
    return 2;
}

bool read(int argc, char** argv, Options& options) {
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--quick") {
            options.quick = true;
            options.runs = 1;
            continue;
        }
        if (i + 1 == argc) return false;
        const std::string value = argv[++i];
        if (word == "--scene") {
            options.scene = value;
        } else if (word == "--json") {
            options.json = value;
        } else if (word == "--runs") {
            options.runs = std::max(1, std::atoi(value.c_str()));
        } else if (word == "--quality") {
            options.qualities = {static_cast<physics::Quality>(std::clamp(std::atoi(value.c_str()), 0, 6))};
        } else {
            return false;
        }
    }
    return true;
}

std::string jsonOf(const Experiment& experiment, const Finding& finding, int substeps, double micros) {
    const std::string name = finding.name.empty() ? "" : "." + finding.name;
    return format(
        "  {\"scene\": \"{}{}\", \"solver\": \"softStep\", \"integrator\": \"semiImplicitEuler\", "
        "\"substeps\": {}, \"iterations\": 1, \"error\": {}, \"unit\": \"{}\", \"usPerStep\": {}, "
        "\"target\": {}, \"usTarget\": {}}",
        experiment.name, name, substeps, finding.error, finding.unit, micros, finding.target,
        experiment.micros);
}

void print(const Experiment& experiment, const Trial& trial, const std::string& substeps, double micros) {
    for (const Finding& finding : trial.findings()) {
        const bool exact = finding.error <= finding.target;
        const bool fast = experiment.micros <= 0.0 || micros <= experiment.micros;
        std::printf("%-14s %-9s %4s %12s %-6s %9s   %9.2f %8s   %s\n", std::string(experiment.name).c_str(),
                    finding.name.c_str(), substeps.c_str(), fixedText(finding.error, 6).c_str(),
                    finding.unit.c_str(), fixedText(finding.target, 4).c_str(), micros,
                    experiment.micros > 0.0 ? fixedText(experiment.micros, 0).c_str() : "-",
                    !exact ? "MISSED"
                    : fast ? "met"
                           : "met, but slow");
    }
    std::fflush(stdout);
}

void run(const Experiment& experiment, const Options& options, std::vector<std::string>& rows) {
    for (const physics::Quality quality : options.qualities) {
        double micros = 0.0;
        std::unique_ptr<Trial> trial;
        for (int i = 0; i < options.runs; ++i) {
            trial = std::make_unique<Trial>(quality, experiment.gravity);
            experiment.run(*trial);
            micros = i == 0 ? trial->microsPerStep() : std::min(micros, trial->microsPerStep());
        }
        if (!trial->scene().missing().empty()) {
            std::printf("%-14s left out: %s\n", std::string(experiment.name).c_str(),
                        trial->scene().missing().c_str());
            return;
        }
        const bool automatic = quality == physics::kQualityOfWorld;
        print(experiment, *trial, automatic ? "auto" : format("{}", 1 << quality), micros);
        if (automatic) continue;  // no point of a curve
        for (const Finding& finding : trial->findings())
            rows.push_back(jsonOf(experiment, finding, 1 << quality, micros));
    }
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    if (!read(argc, argv, options)) return usage();
    std::printf("%-14s %-9s %4s %12s %-6s %9s   %9s %8s\n", "scene", "figure", "sub", "error", "unit",
                "target", "us/step", "target");
    std::vector<std::string> rows;
    bool found = false;
    for (const Experiment& experiment : allExperiments()) {
        if (options.scene.empty() ? options.quick && !experiment.quick : options.scene != experiment.name)
            continue;
        found = true;
        run(experiment, options, rows);
    }
    if (!found) return usage();
    if (options.json.empty()) return 0;
    std::string text = "[\n";
    for (std::size_t i = 0; i < rows.size(); ++i) text += rows[i] + (i + 1 < rows.size() ? ",\n" : "\n");
    const auto written = writeFile(options.json, text + "]\n");
    if (!written) std::fprintf(stderr, "%s\n", written.error().text().c_str());
    return written ? 0 : 1;
}
