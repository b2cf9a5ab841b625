#pragma once

#include <string>
#include <vector>

#include "tests/accuracy/command/threads.hpp"
#include "tests/accuracy/families/relation.hpp"

namespace plumb::families {

struct RunOptions {
    std::vector<const Family*> families;     ///< empty: all
    std::vector<const Relation*> relations;  ///< empty: all
    std::vector<scenes::Engine> peers;       ///< compared by the members that reach their goals, and by time
    std::uint64_t firstSeed = 1;
    int members = 100;  ///< of each family
    int threads = 1;
};

/// How members of a family did in one engine, at its defaults.
struct EngineShare {
    std::string engine;
    int members = 0;  ///< that it could be asked for
    int reached = 0;
    double micros = 0.0;  ///< a step, mean over members
    double maxOverlap = 0.0;
    double maxJointError = 0.0;
    std::string missing;  ///< what it lacks for the others
};

struct FamilyResult {
    const Family* family = nullptr;
    std::vector<EngineShare> engines;        ///< ours first
    std::vector<Verdict> verdicts;           ///< in the order of the relations
    std::vector<std::uint64_t> missedSeeds;  ///< of the first members that missed their goals at the default
    std::string firstMiss;

    [[nodiscard]] bool holds() const;
};

/// Plays all of them. @param show  of members
std::vector<FamilyResult> runFamilies(const RunOptions& options, const accuracy::ShowDone& show = {});

/// The fewest bodies with which a relation still fails in a member: one body after the other is left out.
/// @return by body, whether it is left out; empty if the relation holds in the whole member
std::vector<bool> shrink(const Relation& relation, const Family& family, std::uint64_t seed);

}  // namespace plumb::families
