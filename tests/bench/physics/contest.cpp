#include "tests/bench/physics/contest.hpp"

#include <algorithm>
#include <cstdio>

#include "core/text.hpp"
#include "tests/bench/physics/report.hpp"

namespace plumb::scenes {

namespace {

constexpr int kQuickest = 10;     // a quick run has 1/10 of the steps
constexpr int kQuickSize = 1000;  // a quick run skips scaling scenes with more bodies

std::string_view nameOf(SceneGroup group) {
    switch (group) {
        case SceneGroup::Reference: return "reference";
        case SceneGroup::Comparison: return "comparison";
        case SceneGroup::Scaling: break;
    }
    return "scaling";
}

void usage() {
    std::fprintf(
        stderr,
        "plumb-bench physics [--scene NAME]... [--engine NAME]... [--threads N] [--steps N] [--runs N]\n"
        "                    [--json FILE] [--quick]\n"
        "  NAME may be a part of a name, or a group of scenes: reference, comparison or scaling.\n"
        "  All scenes take half an hour.\n"
        "scenes:");
    for (const Scene& scene : allScenes()) std::fprintf(stderr, " %s", scene.name.c_str());
    std::fprintf(stderr, "\n");
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

bool wants(const Scene& scene, const ContestOptions& options) {
    if (options.quick && scene.group == SceneGroup::Scaling && scene.size > kQuickSize) return false;
    if (options.scenes.empty()) return true;
    return std::any_of(options.scenes.begin(), options.scenes.end(), [&scene](const std::string& name) {
        if (findScene(name) != nullptr) return scene.name == name;
        return name == nameOf(scene.group) || contains(scene.name, name);
    });
}

bool wants(const Engine& engine, std::span<const Engine> engines, const ContestOptions& options) {
    if (options.engines.empty()) return true;
    return std::any_of(options.engines.begin(), options.engines.end(), [&](const std::string& name) {
        const bool exact = std::any_of(engines.begin(), engines.end(),
                                       [&name](const Engine& other) { return other.name == name; });
        return exact ? engine.name == name : contains(engine.name, name);
    });
}

std::vector<Contender> contendersOf(std::span<const Engine> engines, const ContestOptions& options) {
    std::vector<Contender> contenders;
    for (const int threads : {1, 2}) {
        if (options.threads != 0 && options.threads != threads) continue;
        for (const Engine& engine : engines) {
            if (engine.maxThreads >= threads && wants(engine, engines, options))
                contenders.push_back({&engine, threads});
        }
    }
    return contenders;
}

}  // namespace

bool readOptions(std::span<const std::string> arguments, ContestOptions& options) {
    for (std::size_t i = 0; i < arguments.size(); i += 2) {
        const std::string& name = arguments[i];
        const std::string value = i + 1 < arguments.size() ? arguments[i + 1] : "";
        const auto count = parseInt(value);
        const auto positive = [&](int& to) {
            if (!count || *count < 1 || *count > 1000000) return false;
            to = static_cast<int>(*count);
            return true;
        };
        const bool understood = name == "--scene" && !value.empty() ? (options.scenes.push_back(value), true)
                                : name == "--engine" && !value.empty()
                                    ? (options.engines.push_back(value), true)
                                : name == "--threads" ? positive(options.threads)
                                : name == "--steps"   ? positive(options.measure.steps)
                                : name == "--runs"    ? positive(options.measure.runs)
                                                      : false;
        if (!understood) {
            std::fprintf(stderr, "%s %s: unknown option or invalid value\n", name.c_str(), value.c_str());
            usage();
            return false;
        }
    }
    return true;
}

int runContest(std::span<const Engine> engines, const ContestOptions& options) {
    const std::vector<Contender> contenders = contendersOf(engines, options);
    std::vector<Measurement> all;
    printMeasurementHeader();
    for (const Scene& scene : allScenes()) {
        if (!wants(scene, options)) continue;
        MeasureOptions measuring = options.measure;
        if (options.quick) {
            measuring.runs = 1;
            if (measuring.steps == 0) measuring.steps = std::max(scene.steps / kQuickest, 1);
        }
        const std::vector<Measurement> rows = measure(scene, contenders, measuring);
        printMeasurements(rows);
        all.insert(all.end(), rows.begin(), rows.end());
    }
    if (all.empty()) return usage(), 2;
    printExponents(all);
    return options.jsonPath.empty() || writeMeasurements(options.jsonPath, all) ? 0 : 1;
}

}  // namespace plumb::scenes
