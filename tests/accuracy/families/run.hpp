#pragma once

#include <string>
#include <vector>

#include "tests/accuracy/command/threads.hpp"
#include "tests/accuracy/families/relation.hpp"

namespace plumb::families {

struct RunOptions {
    std::vector<const Family*> families;     ///< families to run; empty: all
    std::vector<const Relation*> relations;  ///< relations to check; empty: all
    std::vector<scenes::Engine> peers;       ///< other engines, compared by success rate and time
    std::uint64_t firstSeed = 1;             ///< seed of the first member; the next ones follow
    int members = 100;                       ///< number of members per family
    int threads = 1;
};

/// Results of a family in one engine with default settings.
struct EngineShare {
    std::string engine;          ///< name of the engine
    int members = 0;             ///< number of members that the engine supports
    int reached = 0;             ///< number of members that reach their goals
    double micros = 0.0;         ///< time of a step, mean over members, µs
    double maxOverlap = 0.0;     ///< maximum over members, m
    double maxJointError = 0.0;  ///< maximum over members, m
    std::string missing;         ///< feature that the engine lacks for the other members
};

struct FamilyResult {
    const Family* family = nullptr;
    std::vector<EngineShare> engines;        ///< Plumb first
    std::vector<Verdict> verdicts;           ///< one per relation, in order
    std::vector<std::uint64_t> missedSeeds;  ///< seeds of the first members that missed their goals
    std::string firstMiss;                   ///< goal that the first of these members missed

    [[nodiscard]] bool holds() const;  ///< true if all relations hold
};

/// Runs all selected families. @param show receives the number of finished members
std::vector<FamilyResult> runFamilies(const RunOptions& options, const accuracy::ShowDone& show = {});

/// Reduces a member to a small set of bodies with which the relation still fails.
/// @return a flag per body: true if removed; empty if the relation holds in the whole member
std::vector<bool> shrink(const Relation& relation, const Family& family, std::uint64_t seed);

}  // namespace plumb::families
