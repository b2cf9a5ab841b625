#include "tests/accuracy/families/run.hpp"

#include <algorithm>

namespace plumb::families {

namespace {

constexpr std::size_t kMissesKept = 8;

/// Results of one member (random scene of a family) in all engines and for all relations.
struct MemberResult {
    std::vector<EngineShare> engines;
    std::vector<Verdict> verdicts;
    std::uint64_t seed = 0;
    std::string missed;
};

EngineShare shareOf(std::string_view engine, const Outcome& outcome) {
    EngineShare share;
    share.engine = engine;
    share.missing = outcome.missing;
    if (!outcome.missing.empty()) return share;
    share.members = 1;
    share.reached = outcome.reached ? 1 : 0;
    share.micros = outcome.microsPerStep;
    share.maxOverlap = outcome.maxOverlap;
    share.maxJointError = outcome.maxJointError;
    return share;
}

MemberResult playMember(const RunOptions& options, const Family& family, std::uint64_t seed) {
    const Blueprint plan = memberOf(family, seed);
    MemberResult result;
    result.seed = seed;
    const Outcome usual = play(plan);
    result.missed = usual.missed;
    result.engines.push_back(shareOf("plumb", usual));
    for (const scenes::Engine& peer : options.peers)
        result.engines.push_back(shareOf(peer.name, play(plan, {.peer = &peer})));
    for (const Relation* relation : options.relations)
        result.verdicts.push_back(judge(*relation, family, plan, seed, usual));
    return result;
}

void add(EngineShare& sum, const EngineShare& more) {
    sum.micros =
        (sum.micros * sum.members + more.micros * more.members) / std::max(sum.members + more.members, 1);
    sum.members += more.members;
    sum.reached += more.reached;
    sum.maxOverlap = std::max(sum.maxOverlap, more.maxOverlap);
    sum.maxJointError = std::max(sum.maxJointError, more.maxJointError);
    if (sum.missing.empty()) sum.missing = more.missing;
}

/// Adds the results of a member to those of the family. Called in the order
/// of the seeds, so that the sum does not depend on thread timing.
void add(FamilyResult& sum, const MemberResult& more) {
    if (sum.engines.empty()) {
        sum.engines = more.engines;
        sum.verdicts = more.verdicts;
    } else {
        for (std::size_t i = 0; i < more.engines.size(); ++i) add(sum.engines[i], more.engines[i]);
        for (std::size_t i = 0; i < more.verdicts.size(); ++i) sum.verdicts[i].add(more.verdicts[i]);
    }
    if (more.missed.empty()) return;
    if (sum.firstMiss.empty()) sum.firstMiss = more.missed;
    if (sum.missedSeeds.size() < kMissesKept) sum.missedSeeds.push_back(more.seed);
}

template <class T>
std::vector<const T*> allOf(std::span<const T> rows, const std::vector<const T*>& chosen) {
    if (!chosen.empty()) return chosen;
    std::vector<const T*> all;
    for (const T& row : rows) all.push_back(&row);
    return all;
}

bool fails(const Relation& relation, const Family& family, Blueprint plan, std::uint64_t seed,
           const std::vector<bool>& dropped) {
    // Removed bodies remain as static bodies without shapes, so that the indices of the others do not change.
    for (std::size_t body = 0; body < dropped.size(); ++body) {
        if (!dropped[body]) continue;
        plan.bodies[body].shapes.clear();
        plan.bodies[body].loops.clear();
        plan.bodies[body].setup.motion = Motion::Static;
        std::erase_if(plan.joints, [&](const JointSetup& joint) {
            return joint.a.index == body || joint.b.index == body;
        });
    }
    const Verdict verdict = judge(relation, family, plan, seed, play(plan));
    return verdict.differing > 0 || verdict.worse > 0;
}

}  // namespace

bool FamilyResult::holds() const {
    return std::all_of(verdicts.begin(), verdicts.end(),
                       [](const Verdict& verdict) { return verdict.holds(); });
}

std::vector<FamilyResult> runFamilies(const RunOptions& chosen, const accuracy::ShowDone& show) {
    RunOptions options = chosen;
    options.families = allOf(allFamilies(), chosen.families);
    options.relations = allOf(allRelations(), chosen.relations);
    const auto members = static_cast<std::size_t>(options.members);
    const std::size_t all = members * options.families.size();
    std::vector<MemberResult> results(all);
    const auto playOne = [&](std::size_t i) {
        results[i] = playMember(options, *options.families[i / members], options.firstSeed + i % members);
    };
    accuracy::onThreads(options.threads, all, playOne, show);

    std::vector<FamilyResult> families;
    for (std::size_t i = 0; i < all; ++i) {
        if (i % members == 0) families.push_back({.family = options.families[i / members]});
        add(families.back(), results[i]);
    }
    return families;
}

std::vector<bool> shrink(const Relation& relation, const Family& family, std::uint64_t seed) {
    const Blueprint plan = memberOf(family, seed);
    std::vector<bool> dropped(plan.bodies.size(), false);
    if (!fails(relation, family, plan, seed, dropped)) return {};
    // Tries to remove half of all bodies, quarters, ... single bodies. Source: A. Zeller and R. Hildebrandt,
    // "Simplifying and Isolating Failure-Inducing Input", 2002.
    for (std::size_t piece = dropped.size() / 2; piece > 0; piece /= 2) {
        for (std::size_t first = 0; first < dropped.size(); first += piece) {
            std::vector<bool> fewer = dropped;
            for (std::size_t i = first; i < std::min(first + piece, dropped.size()); ++i) fewer[i] = true;
            if (fewer != dropped && fails(relation, family, plan, seed, fewer)) dropped = fewer;
        }
    }
    return dropped;
}

}  // namespace plumb::families
