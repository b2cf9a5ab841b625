#include "tests/accuracy/stability/stability.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>

#include "core/text.hpp"
#include "tests/accuracy/command/progress_line.hpp"
#include "tests/accuracy/command/words.hpp"
#include "tests/accuracy/stability/random_run.hpp"
#include "tests/accuracy/stability/report.hpp"

namespace plumb::stability {

namespace {

constexpr std::string_view kUsage =
    "plumb accuracy --stability [--quick] [--map NAME] [--random N] [--threads N] [--out DIR] [--docs DIR]\n"
    "  --quick      only quality 2 and automatic quality; takes some seconds\n"
    "  --map NAME   only this map\n"
    "  --random N   instead of the maps: N extreme random scenes, whose numbers must stay finite, and N fair "
    "ones,\n"
    "               whose energy must not grow\n"
    "  --out DIR    output folder for stability.csv, .json and .html (default: current folder)\n"
    "  --docs DIR   also writes DIR/stability.md and its images\n"
    "Maps:";

struct Options {
    Choice choice;
    Path out{"."};
    Path docs;
    int random = 0;
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

std::string take(Options& options, std::string_view word, std::string_view value) {
    if (word == "--map") {
        options.choice.map = value;
        return isMap(value) ? "" : "unknown map";
    }
    if (word == "--random")
        return accuracy::readCount(value, std::numeric_limits<int>::max(), options.random);
    if (word == "--threads") return accuracy::readCount(value, accuracy::kMaxThreads, options.choice.threads);
    if (word != "--out" && word != "--docs") return accuracy::kUnknownWord;
    (word == "--out" ? options.out : options.docs) = Path{value};
    return value.empty() ? "expected a folder" : "";
}

/// Parses command-line arguments. @return the error message; empty: success
std::string read(std::span<const std::string_view> words, Options& options) {
    const accuracy::Flag flags[] = {{"--help", &options.help}, {"--quick", &options.choice.quick}};
    return accuracy::readWords(words, flags, [&](std::string_view word, std::string_view value) {
        return take(options, word, value);
    });
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
    accuracy::ProgressLine line{"times 256 random scenes"};
    const RandomFindings found =
        playRandomScenes(static_cast<std::size_t>(options.random), options.choice.threads,
                         [&](std::size_t done, std::size_t all) { line.show(done, all); });
    std::printf("%s", textOf(found).c_str());
    return found.isSound() ? 0 : 1;
}

}  // namespace

int runStability(std::span<const std::string_view> words) {
    Options options;
    options.choice.threads = accuracy::processors();
    if (const std::string wrong = read(words, options); !wrong.empty()) {
        std::fprintf(stderr, "plumb accuracy --stability: %s\n", wrong.c_str());
        return usage(2);
    }
    if (options.help) return usage(0);
    if (options.random > 0) return playRandom(options);
    accuracy::ProgressLine line{"cells"};
    const std::vector<PlayedMap> maps =
        play(options.choice, [&](std::size_t done, std::size_t all) { line.show(done, all); });
    for (const PlayedMap& map : maps) print(map);
    const Counts counts = countsOf(maps);
    for (std::size_t i = counts.size(); i-- > 0;)
        std::printf("%6zu  %s\n", counts[i], std::string(infoOf(static_cast<Score>(i)).word).c_str());
    if (!written(writeReport(maps, options.out))) return 1;
    if (!options.docs.empty() && !written(writeDocs(maps, options.docs))) return 1;
    return counts[static_cast<std::size_t>(Score::BlowsUp)] == 0 ? 0 : 1;
}

}  // namespace plumb::stability
