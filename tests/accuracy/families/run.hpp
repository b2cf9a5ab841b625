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

/// Results of a family in one engine with its defaults.
struct EngineShare {
    std::string engine;
    int members = 0;  ///< number that it supports
    int reached = 0;
    double micros = 0.0;  ///< per step, mean over members
    double maxOverlap = 0.0;
    double maxJointError = 0.0;
    std::string missing;  ///< missing feature for the others
};

struct FamilyResult {
    const Family* family = nullptr;
    std::vector<EngineShare> engines;        ///< ours first
    std::vector<Verdict> verdicts;           ///< in the order of the relations
    std::vector<std::uint64_t> missedSeeds;  ///< of the first members that missed their goals with the
                                             ///< defaults
    std::string firstMiss;

    [[nodiscard]] bool holds() const;
};

/// Runs all of them. @param show receives the progress in members
std::vector<FamilyResult> runFamilies(const RunOptions& options, const accuracy::ShowDone& show = {});

/// The smallest set of bodies with which a relation still fails in a member: removes one body after the
/// other.
/// @return by body, whether it is removed; empty if the relation holds in the whole member
std::vector<bool> shrink(const Relation& relation, const Family& family, std::uint64_t seed);

}  // namespace plumb::families
