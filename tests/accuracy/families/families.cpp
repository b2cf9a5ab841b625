#include "tests/accuracy/families/families.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <thread>
#include <unistd.h>

#include "core/text.hpp"
#include "tests/accuracy/families/costs.hpp"
#include "tests/accuracy/families/report.hpp"

namespace plumb::families {

namespace {

constexpr std::string_view kUsage =
    "usage: ./plumb accuracy --families N [options]\n"
    "Plays N random members of each family, and compares how they do in variations that may not matter.\n"
    "  --family F     one family alone; may be repeated\n"
    "  --relation R   one relation alone; may be repeated\n"
    "  --seed S       of the first member (1)\n"
    "  --threads T    members at a time (all processors)\n"
    "  --no-peers     Plumb alone\n"
    "  --costs        instead: what twice as many of each kind of thing cost, on a quiet machine\n"
    "  --shrink       leaves out bodies of the worst member of each failure until it holds\n"
    "  --out DIR      where families.csv and families.html go (build/accuracy)\n"
    "  --docs DIR     where families.md goes as well\n";

struct Options {
    RunOptions run;
    Path out;
    Path docs;
    bool shrinks = false;
    bool peers = true;
    bool costs = false;
    bool help = false;
};

template <class T>
std::string namesOf(std::span<const T> rows) {
    std::string names;
    for (const T& row : rows) names += format(" {}", row.name);
    return names;
}

/// @return what is wrong; empty if nothing
std::string take(Options& options, std::string_view word, std::string_view value) {
    const auto number = parseInt(value);
    const bool positive = number && *number >= 1 && *number <= 100000000;
    if (word == "--family") {
        options.run.families.push_back(findFamily(value));
        if (options.run.families.back() == nullptr)
            return format("no such family; there are{}", namesOf(allFamilies()));
    } else if (word == "--relation") {
        options.run.relations.push_back(findRelation(value));
        if (options.run.relations.back() == nullptr)
            return format("no such relation; there are{}", namesOf(allRelations()));
    } else if (word == "--seed") {
        if (!positive) return "a seed is a whole number from 1";
        options.run.firstSeed = static_cast<std::uint64_t>(*number);
    } else if (word == "--threads") {
        if (!positive || *number > 256) return "threads are 1 to 256";
        options.run.threads = static_cast<int>(*number);
    } else if (word == "--out") {
        options.out = Path{value};
    } else if (word == "--docs") {
        options.docs = Path{value};
    } else {
        return format("unknown option\n{}", kUsage);
    }
    return {};
}

std::string read(std::span<const std::string_view> words, Options& options) {
    std::size_t i = 0;
    if (!words.empty() && !words[0].starts_with("-")) {
        const auto members = parseInt(words[0]);
        if (!members || *members < 1 || *members > 10000000)
            return "expected how many members to play, as 100";
        options.run.members = static_cast<int>(*members);
        i = 1;
    }
    for (; i < words.size(); ++i) {
        if (words[i] == "--help") {
            options.help = true;
        } else if (words[i] == "--no-peers") {
            options.peers = false;
        } else if (words[i] == "--costs") {
            options.costs = true;
        } else if (words[i] == "--shrink") {
            options.shrinks = true;
        } else {
            if (i + 1 == words.size())
                return format("'{}' is unknown or lacks its value\n{}", words[i], kUsage);
            const std::string wrong = take(options, words[i], words[i + 1]);
            if (!wrong.empty()) return format("{} {}: {}", words[i], words[i + 1], wrong);
            ++i;
        }
    }
    return {};
}

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// One line of a terminal, or a line for each tenth of a file.
class ProgressLine {
public:
    void show(std::size_t done, std::size_t all) {
        const auto percent = static_cast<int>(100 * done / all);
        const bool terminal = isatty(STDERR_FILENO) != 0;
        if (percent == last_ || (!terminal && percent < last_ + 10 && done != all)) return;
        last_ = percent;
        const double spent = seconds() - start_;
        const double left = spent * static_cast<double>(all - done) / static_cast<double>(done);
        std::fprintf(stderr, "%s%zu of %zu members, about %d s left%s", terminal ? "\r\033[K" : "", done, all,
                     static_cast<int>(left) + 1, terminal && done != all ? "" : "\n");
    }

private:
    int last_ = 0;
    double start_ = seconds();
};

void printShrunk(const Verdict& verdict, const Family& family) {
    const std::vector<bool> dropped = shrink(*verdict.relation, family, verdict.seed);
    if (dropped.empty()) {
        std::printf("    %s, seed %llu: holds when played alone\n",
                    std::string(verdict.relation->name).c_str(),
                    static_cast<unsigned long long>(verdict.seed));
        return;
    }
    std::string kept;
    for (std::size_t body = 0; body < dropped.size(); ++body)
        if (!dropped[body]) kept += format(" {}", body);
    std::printf("    %s, seed %llu: still fails with bodies%s alone\n",
                std::string(verdict.relation->name).c_str(), static_cast<unsigned long long>(verdict.seed),
                kept.c_str());
}

bool write(const Path& path, std::string_view text) {
    const auto written = writeFile(path, text);
    if (!written) std::fprintf(stderr, "%s\n", written.error().text().c_str());
    return written.ok();
}

int printCosts() {
    const std::vector<CostRow> rows = measureCosts();
    std::printf("%s", textOf(rows).c_str());
    const bool flat = std::all_of(rows.begin(), rows.end(),
                                  [](const CostRow& row) { return row.exponent() <= kMaxExponent; });
    return flat ? 0 : 1;
}

}  // namespace

int runFamilyCommand(std::span<const std::string_view> words, std::vector<scenes::Engine> peers,
                     const Path& out) {
    Options options;
    options.out = out;
    options.run.threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 256u));
    if (const std::string wrong = read(words, options); !wrong.empty()) {
        std::fprintf(stderr, "plumb accuracy --families: %s\n", wrong.c_str());
        return 2;
    }
    if (options.help) {
        std::printf("%s\nfamilies:%s\nrelations:%s\n", std::string(kUsage).c_str(),
                    namesOf(allFamilies()).c_str(), namesOf(allRelations()).c_str());
        return 0;
    }
    if (options.costs) return printCosts();
    if (options.peers) options.run.peers = std::move(peers);
    ProgressLine line;
    const double start = seconds();
    const std::vector<FamilyResult> results =
        runFamilies(options.run, [&](std::size_t done, std::size_t all) { line.show(done, all); });
    bool holds = true;
    for (const FamilyResult& result : results) {
        std::printf("%s", textOf(result).c_str());
        holds = holds && result.holds();
        for (const Verdict& verdict : result.verdicts)
            if (options.shrinks && !verdict.holds()) printShrunk(verdict, *result.family);
    }
    const std::string how =
        format("./plumb accuracy --families {} --seed {}", options.run.members, options.run.firstSeed);
    std::printf("%s in %d s\n", how.c_str(), static_cast<int>(seconds() - start));
    bool written = write(options.out / "families.csv", csvOf(results)) &&
                   write(options.out / "families.html", htmlOf(results, how));
    if (written && !options.docs.empty())
        written = write(options.docs / "families.md", markdownOf(results, how));
    return written && holds ? 0 : 1;
}

}  // namespace plumb::families
