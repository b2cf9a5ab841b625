#include "tests/accuracy/report/options.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "tests/accuracy/report/scene_texts.hpp"

namespace plumb::accuracy {

namespace {

struct Option {
    std::string_view name;
    std::string_view value;  ///< placeholder of the option's value in the help; empty: no value
    std::string_view help;
};

constexpr Option kOptions[] = {
    {"--scene", "NAME", "only this scene; --list prints all names"},
    {"--quick", "", "only fast scenes, three qualities, one run of each: takes less than a minute"},
    {"--quality", "0..6", "only 2^N substeps, instead of 1 to 64"},
    {"--runs", "N", "number of runs of each scene and method; the fastest counts (3)"},
    {"--out", "DIR", "output folder for results.csv, results.json and accuracy.html (build/accuracy)"},
    {"--docs", "DIR", "output folder for accuracy.md and its diagrams (docs updates the documentation)"},
    {"--no-peers", "", "does not run other engines"},
    {"--list", "", "prints the names of all scenes"},
    {"--stability", "", "instead runs the stability map of hard cases; all later options belong to it"},
    {"--families", "",
     "instead checks properties that must hold in random scenes; all later options belong to it"},
    {"--tuning", "",
     "instead measures the effect of doubling or halving each constant; all later options belong to it"},
    {"--help", "", "prints this text"},
};

std::string optionsText() {
    std::string text;
    for (const Option& option : kOptions) {
        const std::string name = format("{} {}", option.name, option.value);
        text +=
            format("  {}{}{}\n", name,
                   std::string(std::max<std::size_t>(18, name.size() + 1) - name.size(), ' '), option.help);
    }
    return text;
}

Error badWord(std::string_view word, std::string_view what) {
    return {format("plumb accuracy {}", word), std::string{what}, format("options:\n{}", optionsText())};
}

std::string sceneNames() {
    std::string names;
    for (const Experiment& experiment : allExperiments())
        names += format("{}{}", names.empty() ? "" : " ", experiment.name);
    return names;
}

Error noScene(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Experiment& experiment : allExperiments()) names.push_back(experiment.name);
    const std::string_view near = closestName(name, names);
    return {format("plumb accuracy --scene {}", name), "unknown scene",
            format("{}the scenes: {}", near.empty() ? std::string{} : format("did you mean '{}'? ", near),
                   sceneNames())};
}

/// Parses the value of an option. @return the error message; empty: success
std::string take(Options& options, std::string_view name, std::string_view value) {
    const auto number = parseInt(value);
    if (name == "--out") {
        options.out = Path{value};
    } else if (name == "--docs") {
        options.docs = Path{value};
    } else if (name == "--scene") {
        options.sweep.scene = value;
    } else if (name == "--quality") {
        if (!number || *number < 0 || *number > physics::kMaxQuality)
            return "expected a whole number from 0 to 6";
        options.sweep.qualities = {static_cast<physics::Quality>(*number)};
    } else if (name == "--runs") {
        if (!number || *number < 1 || *number > 1000) return "expected a whole number from 1 to 1000";
        options.sweep.runs = static_cast<int>(*number);
    }
    return {};
}

}  // namespace

std::string helpText() {
    return format(
        "usage: ./plumb accuracy [options]\n\nMeasures error and time of each method in scenes whose exact "
        "result is known.\n\n{}\nscenes: {}\n",
        optionsText(), sceneNames());
}

Result<Options> readOptions(std::span<const std::string_view> words) {
    Options options;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string_view word = words[i];
        const auto found = std::find_if(std::begin(kOptions), std::end(kOptions),
                                        [word](const Option& option) { return option.name == word; });
        if (found == std::end(kOptions)) return badWord(word, "unknown option");
        if (!found->value.empty()) {
            if (i + 1 == words.size()) return badWord(word, format("{} is missing", found->value));
            const std::string_view value = words[++i];
            if (const std::string wrong = take(options, word, value); !wrong.empty())
                return badWord(format("{} {}", word, value), wrong);
            if (word == "--scene" && findExperiment(value) == nullptr) return noScene(value);
        } else if (word == "--quick") {
            options.sweep.quick = true;
            options.sweep.runs = 1;
        } else if (word == "--no-peers") {
            options.peers = false;
        } else if (word == "--stability" || word == "--families" || word == "--tuning") {
            (word == "--stability"  ? options.stability
             : word == "--families" ? options.families
                                    : options.tuning) = true;
            options.otherWords.assign(words.begin() + static_cast<std::ptrdiff_t>(i) + 1, words.end());
            return options;
        } else {
            (word == "--list" ? options.list : options.help) = true;
        }
    }
    return options;
}

std::string sceneList() {
    std::string text;
    for (const Experiment& experiment : allExperiments())
        text += format(
            "{}{}{}\n", experiment.name,
            std::string(std::max<std::size_t>(14, experiment.name.size() + 1) - experiment.name.size(), ' '),
            textOf(experiment.name).title);
    return text;
}

}  // namespace plumb::accuracy
