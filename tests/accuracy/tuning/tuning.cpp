#include "tests/accuracy/tuning/tuning.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <thread>
#include <unistd.h>

#include "core/text.hpp"
#include "tests/accuracy/tuning/report.hpp"

namespace plumb::tuning {

namespace {

constexpr std::string_view kUsage =
    "usage: ./plumb accuracy --tuning [options]\n"
    "Plays the families and the quick part of the stability map with each constant of the physics at half "
    "and at\n"
    "double, one after the other. What is in DIR/tuning.csv already is not played again while nothing else "
    "changed.\n"
    "  --families N   members of each family (150)\n"
    "  --constant C   one alone; may be repeated\n"
    "  --factor F     other factors than 0.5 and 2; may be repeated\n"
    "  --quick        40 members of each family at most\n"
    "  --no-maps      families alone\n"
    "  --threads T    members at a time (all processors)\n"
    "  --out DIR      where tuning.csv and tuning.html go (build/accuracy)\n"
    "  --docs DIR     where tuning.md goes as well\n";

struct Options {
    SweepOptions sweep;
    std::vector<const Constant*> constants;
    std::vector<double> factors;
    Path out;
    Path docs;
    bool help = false;
};

/// @return what is wrong; empty if nothing
std::string take(Options& options, std::string_view word, std::string_view value) {
    const auto number = parseInt(value);
    if (word == "--constant") {
        for (const Constant* constant : allConstants())
            if (constant->name == value) return options.constants.push_back(constant), std::string{};
        return "no such constant in engine/physics/tuning.hpp";
    }
    if (word == "--factor") {
        const auto factor = parseFloat(value);
        if (!factor || *factor < 0.0f) return "a factor is a number from 0";
        options.factors.push_back(static_cast<double>(*factor));
    } else if (word == "--families" || word == "--threads") {
        if (!number || *number < 1 || *number > 1000000) return "expected a whole number from 1";
        (word == "--families" ? options.sweep.members : options.sweep.threads) = static_cast<int>(*number);
    } else if (word == "--out" || word == "--docs") {
        (word == "--out" ? options.out : options.docs) = Path{value};
    } else {
        return format("unknown option\n{}", kUsage);
    }
    return {};
}

std::string read(std::span<const std::string_view> words, Options& options) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--help") {
            options.help = true;
        } else if (words[i] == "--quick") {
            options.sweep.quick = true;
        } else if (words[i] == "--no-maps") {
            options.sweep.maps = false;
        } else {
            if (i + 1 == words.size())
                return format("'{}' is unknown or lacks its value\n{}", words[i], kUsage);
            const std::string wrong = take(options, words[i], words[i + 1]);
            if (!wrong.empty()) return format("{} {}: {}", words[i], words[i + 1], wrong);
            ++i;
        }
    }
    if (options.constants.empty()) options.constants = allConstants();
    if (options.factors.empty()) options.factors = {0.5, 2.0};
    return {};
}

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void showProgress(const Trial& trial, std::size_t done, std::size_t all, double start) {
    const double spent = seconds() - start;
    const double left =
        spent * static_cast<double>(all - done) / static_cast<double>(std::max<std::size_t>(done, 1));
    std::fprintf(stderr, "%s%zu of %zu, about %d s left: %s", isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "",
                 done, all, static_cast<int>(left) + 1, textOf(trial).c_str());
}

bool write(const Path& path, std::string_view text) {
    const auto written = writeFile(path, text);
    if (!written) std::fprintf(stderr, "%s\n", written.error().text().c_str());
    return written.ok();
}

const Constant* findConstant(std::string_view name) {
    for (const Constant* constant : allConstants())
        if (constant->name == name) return constant;
    return nullptr;
}

/// What an earlier run with the same outcomes at the values of the table left.
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
    const double start = seconds();
    bool written = true;
    for (const Constant* constant : options.constants) {
        for (const double factor : options.factors) {
            ++done;
            if (isPlayed(trials, constant, factor)) continue;
            trials.push_back(sweep.trial(*constant, factor));
            showProgress(trials.back(), done, all, start);
            written = write(csv, first + csvOf(trials));
        }
    }
    const std::string how = format("./plumb accuracy --tuning --families {}", options.sweep.members);
    written = write(options.out / "tuning.html", htmlOf(trials, how)) && written;
    if (!options.docs.empty())
        written = write(options.docs / "tuning.md", markdownOf(trials, how)) && written;
    bool explained = true;
    for (const Constant* constant : options.constants) {
        if (!needsReason(trials, *constant) || !reasonOf(constant->name).empty()) continue;
        std::printf("%s moves a share by more than 2 %%: say why in tests/accuracy/tuning/reasons.cpp\n",
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
            "The constants of this build are fixed. ./plumb accuracy --tuning builds plumb-accuracy with\n"
            "-DPLUMB_TUNABLE=ON in build/tunable and runs that.\n");
        return 2;
    }
    Options options;
    options.out = out;
    options.sweep.threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 256u));
    if (const std::string wrong = read(words, options); !wrong.empty()) {
        std::fprintf(stderr, "plumb accuracy --tuning: %s\n", wrong.c_str());
        return 2;
    }
    if (options.help) {
        std::printf("%s", std::string(kUsage).c_str());
        return 0;
    }
    return sweepAll(options);
}

}  // namespace plumb::tuning
