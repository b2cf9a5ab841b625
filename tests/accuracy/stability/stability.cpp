#include "tests/accuracy/stability/stability.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <thread>
#include <unistd.h>

#include "core/text.hpp"
#include "tests/accuracy/stability/random_run.hpp"
#include "tests/accuracy/stability/report.hpp"

namespace plumb::stability {

namespace {

constexpr std::string_view kUsage =
    "plumb accuracy --stability [--quick] [--map NAME] [--random N] [--threads N] [--out DIR] [--docs DIR]\n"
    "  --quick      quality 2 and automatic alone, some seconds\n"
    "  --map NAME   one map alone\n"
    "  --random N   instead of the maps: N random scenes, none of which may have bad numbers, and N fair "
    "ones,\n"
    "               whose energy may not grow\n"
    "  --out DIR    where stability.csv, .json and .html go (default: here)\n"
    "  --docs DIR   writes DIR/stability.md and its pictures too\n"
    "Maps:";

struct Options {
    Choice choice;
    std::string out = ".";
    std::string docs;
    std::size_t random = 0;
    bool help = false;
};

int usage(int code) {
    std::string text{kUsage};
    for (const Map& map : allMaps()) text += format(" {}", map.name);
    std::fprintf(code == 0 ? stdout : stderr, "%s\n", text.c_str());
    return code;
}

bool isMap(std::string_view name) {
    const auto maps = allMaps();
    return std::any_of(maps.begin(), maps.end(), [name](const Map& map) { return map.name == name; });
}

bool take(std::string_view word, std::string_view value, Options& options) {
    if (word == "--map" && isMap(value)) {
        options.choice.map = value;
    } else if (word == "--out" && !value.empty()) {
        options.out = value;
    } else if (word == "--docs" && !value.empty()) {
        options.docs = value;
    } else {
        const auto number = parseInt(value);
        if (!number || *number < 1) return false;
        if (word == "--random") {
            options.random = static_cast<std::size_t>(*number);
        } else if (word == "--threads" && *number <= 256) {
            options.choice.threads = static_cast<int>(*number);
        } else {
            return false;
        }
    }
    return true;
}

bool read(std::span<const std::string_view> words, Options& options) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--help") {
            options.help = true;
        } else if (words[i] == "--quick") {
            options.choice.quick = true;
        } else if (i + 1 == words.size() || !take(words[i], words[i + 1], options)) {
            std::fprintf(stderr, "'%s' is not understood here\n", std::string(words[i]).c_str());
            return false;
        } else {
            ++i;
        }
    }
    return true;
}

/// How much is done: in one line of a terminal, which each percent writes anew; where a file listens, a line
/// for each tenth.
Progress percentages(std::string_view what) {
    const bool inPlace = isatty(STDERR_FILENO) != 0;
    return [what, inPlace, told = std::size_t{0}](std::size_t done, std::size_t all) mutable {
        const std::size_t percent = 100 * done / std::max<std::size_t>(all, 1);
        if (percent == told || (!inPlace && percent < told + 10 && done != all)) return;
        told = percent;
        std::fprintf(stderr, "%s%s: %zu of %zu (%zu %%)%s", inPlace ? "\r\033[K" : "",
                     std::string(what).c_str(), done, all, percent, !inPlace || done == all ? "\n" : "");
    };
}

void print(const PlayedMap& map) {
    std::printf("%s (%s)\n", std::string(map.map->title).c_str(), std::string(map.map->columns.name).c_str());
    for (std::size_t row = 0; row < map.rows.size(); ++row) {
        std::string signs;
        for (const Score score : map.scoresOf(row)) signs += format(" {}", infoOf(score).sign);
        std::printf("  %8s %-20s holds %-14s within 1 %% %s\n", map.rowLabel(row).c_str(), signs.c_str(),
                    map.holds(row, Score::Soft).c_str(), map.holds(row, Score::Close).c_str());
    }
}

bool written(const Result<Done>& result) {
    if (!result) std::fprintf(stderr, "%s\n", result.error().text().c_str());
    return result.ok();
}

int playRandom(const Options& options) {
    const RandomFindings found =
        playRandomScenes(options.random, options.choice.threads, percentages("random scenes"));
    std::printf("%s", textOf(found).c_str());
    return found.isSound() ? 0 : 1;
}

}  // namespace

int runStability(std::span<const std::string_view> words) {
    Options options;
    options.choice.threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 256u));
    if (!read(words, options)) return usage(2);
    if (options.help) return usage(0);
    if (options.random > 0) return playRandom(options);
    const std::vector<PlayedMap> maps = play(options.choice, percentages("cells"));
    for (const PlayedMap& map : maps) print(map);
    const Counts counts = countsOf(maps);
    for (std::size_t i = counts.size(); i-- > 0;)
        std::printf("%6zu  %s\n", counts[i], std::string(infoOf(static_cast<Score>(i)).word).c_str());
    if (!written(writeReport(maps, options.out))) return 1;
    if (!options.docs.empty() && !written(writeDocs(maps, options.docs))) return 1;
    return counts[static_cast<std::size_t>(Score::BlowsUp)] == 0 ? 0 : 1;
}

}  // namespace plumb::stability
