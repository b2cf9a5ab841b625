#include "tests/accuracy/tuning/tuning.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

#include "core/text.hpp"
#include "tests/accuracy/command/pages.hpp"
#include "tests/accuracy/command/progress_line.hpp"
#include "tests/accuracy/command/threads.hpp"
#include "tests/accuracy/command/words.hpp"
#include "tests/accuracy/tuning/report.hpp"

namespace plumb::tuning {

namespace {

constexpr const char* kUsage =
    "usage: ./plumb accuracy --tuning [options]\n"
    "Simulates the families and the quick part of the stability map with one constant of the physics at a\n"
    "time changed to half and to double. Reuses results in DIR/tuning.csv if the default results are "
    "unchanged.\n"
    "  --families N   number of members per family (150)\n"
    "  --constant C   only this constant; may be repeated\n"
    "  --factor F     factor instead of 0.5 and 2; may be repeated\n"
    "  --quick        at most 40 members per family\n"
    "  --no-maps      only families\n"
    "  --threads T    number of members simulated in parallel (number of processors)\n"
    "  --out DIR      output folder for tuning.csv and tuning.html (build/accuracy)\n"
    "  --docs DIR     output folder for tuning.md\n";

struct Options {
    SweepOptions sweep;
    bool noMaps = false;
    std::vector<const Constant*> constants;
    std::vector<double> factors;
    Path out;
    Path docs;
    bool help = false;
};

std::string take(Options& options, std::string_view word, std::string_view value) {
    if (word == "--constant") {
        for (const Constant* constant : allConstants())
            if (constant->name == value) return options.constants.push_back(constant), std::string{};
        return "unknown constant; see engine/physics/tuning.hpp";
    }
    if (word == "--factor") {
        const auto factor = parseFloat(value);
        if (!factor || *factor < 0.0f) return "expected a number of at least 0";
        options.factors.push_back(static_cast<double>(*factor));
    } else if (word == "--families") {
        return accuracy::readCount(value, 1000000, options.sweep.members);
    } else if (word == "--threads") {
        return accuracy::readCount(value, accuracy::kMaxThreads, options.sweep.threads);
    } else if (word == "--out" || word == "--docs") {
        (word == "--out" ? options.out : options.docs) = Path{value};
    } else {
        return accuracy::kUnknownWord;
    }
    return {};
}

/// Parses command-line arguments. @return the error message; empty: success
std::string read(std::span<const std::string_view> words, Options& options) {
    const accuracy::Flag flags[] = {
        {"--help", &options.help}, {"--quick", &options.sweep.quick}, {"--no-maps", &options.noMaps}};
    const std::string wrong = accuracy::readWords(
        words, flags,
        [&](std::string_view word, std::string_view value) { return take(options, word, value); });
    options.sweep.maps = !options.noMaps;
    if (options.constants.empty()) options.constants = allConstants();
    if (options.factors.empty()) options.factors = {0.5, 2.0};
    return wrong;
}

void showTrial(const Trial& trial, std::size_t done, std::size_t all, double start) {
    const double part = static_cast<double>(done) / static_cast<double>(all);
    std::fprintf(stderr, "%zu of %zu%s: %s", done, all,
                 accuracy::timeLeft(wallSeconds() - start, part).c_str(), textOf(trial).c_str());
}

const Constant* findConstant(std::string_view name) {
    for (const Constant* constant : allConstants())
        if (constant->name == name) return constant;
    return nullptr;
}

/// Reads the stored results of an earlier run, if its results at the default values are the same.
std::vector<Trial> readTrials(const Path& path, const std::string& first) {
    std::vector<Trial> trials;
    const auto text = readFile(path);
    if (!text || !text->starts_with(first)) return trials;
    for (const std::string_view line : split(*text, '\n')) {
        const auto cells = split(line, ',');
        const Constant* constant = cells.size() == 11 ? findConstant(cells[0]) : nullptr;
        if (constant == nullptr || cells[1] != format("{}", constant->value)) continue;
        const double factor = static_cast<double>(parseFloat(cells[2]).value_or(0.0f));
        if (trials.empty() || trials.back().constant != constant || trials.back().factor != factor)
            trials.push_back({constant, factor, {}});
        const auto number = [&](std::size_t i) { return static_cast<int>(parseInt(cells[i]).value_or(0)); };
        trials.back().moves.push_back({std::string{cells[3]}, number(4) != 0, number(5), number(6), number(7),
                                       number(8), number(9), number(10) != 0});
    }
    return trials;
}

bool isPlayed(const std::vector<Trial>& trials, const Constant* constant, double factor) {
    return std::any_of(trials.begin(), trials.end(), [&](const Trial& trial) {
        return trial.constant == constant && trial.factor == factor;
    });
}

int sweepAll(const Options& options) {
    const Sweep sweep{options.sweep};
    const std::string first = format("# {} members, {}\n", options.sweep.members, hexText(sweep.signature()));
    const Path csv = options.out / "tuning.csv";
    std::vector<Trial> trials = readTrials(csv, first);
    const std::size_t all = options.constants.size() * options.factors.size();
    std::size_t done = 0;
    const double start = wallSeconds();
    bool written = true;
    for (const Constant* constant : options.constants) {
        for (const double factor : options.factors) {
            ++done;
            if (isPlayed(trials, constant, factor)) continue;
            trials.push_back(sweep.trial(*constant, factor));
            showTrial(trials.back(), done, all, start);
            written = accuracy::write(csv, first + csvOf(trials));
        }
    }
    const std::string how = format("./plumb accuracy --tuning --families {}", options.sweep.members);
    written = accuracy::write(options.out / "tuning.html", htmlOf(trials, how)) && written;
    if (!options.docs.empty())
        written = accuracy::write(options.docs / "tuning.md", markdownOf(trials, how)) && written;
    bool explained = true;
    for (const Constant* constant : options.constants) {
        if (!needsReason(trials, *constant) || !reasonOf(constant->name).empty()) continue;
        std::printf("%s changes a share by more than 2 %%: explain it in tests/accuracy/tuning/reasons.cpp\n",
                    constant->name);
        explained = false;
    }
    return written && explained ? 0 : 1;
}

}  // namespace

int runTuningCommand(std::span<const std::string_view> words, const Path& out) {
    if (allConstants().empty()) {
        std::fprintf(
            stderr,
            "The constants of this build cannot be changed. ./plumb accuracy --tuning builds plumb-accuracy\n"
            "with -DPLUMB_TUNABLE=ON in build/tunable and runs it.\n");
        return 2;
    }
    Options options;
    options.out = out;
    options.sweep.threads = accuracy::processors();
    if (const std::string wrong = read(words, options); !wrong.empty()) {
        std::fprintf(stderr, "plumb accuracy --tuning: %s\n%s", wrong.c_str(), kUsage);
        return 2;
    }
    if (options.help) {
        std::printf("%s", kUsage);
        return 0;
    }
    return sweepAll(options);
}

}  // namespace plumb::tuning
