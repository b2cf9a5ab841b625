#include "tests/accuracy/families/families.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

#include "core/text.hpp"
#include "tests/accuracy/command/pages.hpp"
#include "tests/accuracy/command/progress_line.hpp"
#include "tests/accuracy/command/words.hpp"
#include "tests/accuracy/families/costs.hpp"
#include "tests/accuracy/families/report.hpp"

namespace plumb::families {

namespace {

constexpr const char* kUsage =
    "usage: ./plumb accuracy --families N [options]\n"
    "Simulates N random scenes (members) of each family, and checks relations between variations of a "
    "scene.\n"
    "  --family F     only this family; may be repeated\n"
    "  --relation R   only this relation; may be repeated\n"
    "  --seed S       seed of the first member (1)\n"
    "  --threads T    number of members simulated in parallel (number of processors)\n"
    "  --no-peers     does not run other engines\n"
    "  --costs        instead: measures how step times grow with the number of objects; needs an idle "
    "machine\n"
    "  --shrink       reduces the worst member of each failed relation to the bodies needed for the failure\n"
    "  --out DIR      output folder for families.csv and families.html (build/accuracy)\n"
    "  --docs DIR     output folder for families.md\n";

struct Options {
    RunOptions run;
    Path out;
    Path docs;
    bool shrinks = false;
    bool noPeers = false;
    bool costs = false;
    bool help = false;
};

template <class T>
std::string namesOf(std::span<const T> rows) {
    std::string names;
    for (const T& row : rows) names += format(" {}", row.name);
    return names;
}

std::string take(Options& options, std::string_view word, std::string_view value) {
    if (word == "--family") {
        options.run.families.push_back(findFamily(value));
        if (options.run.families.back() == nullptr)
            return format("unknown family; available:{}", namesOf(allFamilies()));
    } else if (word == "--relation") {
        options.run.relations.push_back(findRelation(value));
        if (options.run.relations.back() == nullptr)
            return format("unknown relation; available:{}", namesOf(allRelations()));
    } else if (word == "--seed") {
        int seed = 0;
        const std::string wrong = accuracy::readCount(value, 100000000, seed);
        options.run.firstSeed = static_cast<std::uint64_t>(seed);
        return wrong;
    } else if (word == "--threads") {
        return accuracy::readCount(value, accuracy::kMaxThreads, options.run.threads);
    } else if (word == "--out") {
        options.out = Path{value};
    } else if (word == "--docs") {
        options.docs = Path{value};
    } else {
        return accuracy::kUnknownWord;
    }
    return {};
}

/// Parses command-line arguments. @return the error message; empty: success
std::string read(std::span<const std::string_view> words, Options& options) {
    if (!words.empty() && !words[0].starts_with("-")) {
        if (std::string wrong = accuracy::readCount(words[0], 10000000, options.run.members); !wrong.empty())
            return wrong;
        words = words.subspan(1);
    }
    const accuracy::Flag flags[] = {{"--help", &options.help},
                                    {"--no-peers", &options.noPeers},
                                    {"--costs", &options.costs},
                                    {"--shrink", &options.shrinks}};
    return accuracy::readWords(words, flags, [&](std::string_view word, std::string_view value) {
        return take(options, word, value);
    });
}

void printShrunk(const Verdict& verdict, const Family& family) {
    const std::vector<bool> dropped = shrink(*verdict.relation, family, verdict.seed);
    if (dropped.empty()) {
        std::printf("    %s, seed %llu: the relation holds if only this member is checked\n",
                    std::string(verdict.relation->name).c_str(),
                    static_cast<unsigned long long>(verdict.seed));
        return;
    }
    std::string kept;
    for (std::size_t body = 0; body < dropped.size(); ++body)
        if (!dropped[body]) kept += format(" {}", body);
    std::printf("    %s, seed %llu: still fails with only the bodies%s\n",
                std::string(verdict.relation->name).c_str(), static_cast<unsigned long long>(verdict.seed),
                kept.c_str());
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
    options.run.threads = accuracy::processors();
    if (const std::string wrong = read(words, options); !wrong.empty()) {
        std::fprintf(stderr, "plumb accuracy --families: %s\n%s", wrong.c_str(), kUsage);
        return 2;
    }
    if (options.help) {
        std::printf("%s\nfamilies:%s\nrelations:%s\n", kUsage, namesOf(allFamilies()).c_str(),
                    namesOf(allRelations()).c_str());
        return 0;
    }
    if (options.costs) return printCosts();
    if (!options.noPeers) options.run.peers = std::move(peers);
    accuracy::ProgressLine line{"members"};
    const double start = wallSeconds();
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
    std::printf("%s in %d s\n", how.c_str(), static_cast<int>(wallSeconds() - start));
    bool written = accuracy::write(options.out / "families.csv", csvOf(results)) &&
                   accuracy::write(options.out / "families.html", htmlOf(results, how));
    if (written && !options.docs.empty())
        written = accuracy::write(options.docs / "families.md", markdownOf(results, how));
    return written && holds ? 0 : 1;
}

}  // namespace plumb::families
