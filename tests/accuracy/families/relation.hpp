#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/outcome.hpp"

namespace plumb::families {

/// How two variations of a scene are compared.
enum class Rule : std::uint8_t {
    SameBits,     ///< every bit of every pose and motion
    SameOutcome,  ///< equally many members reach their goals, and unless
                  ///< a family is chaotic, with equal final positions
    NeverWorse,   ///< at least as many members reach their goals
    Bound         ///< a figure of each single outcome
};

/// A property that must hold for every scene, whatever the exact result is.
struct Relation {
    std::string_view name;
    std::string_view what;   ///< one sentence
    std::string_view bound;  ///< explanation of its rule
    Rule rule = Rule::SameOutcome;
    /// How a member is simulated for the comparison, by a random number
    /// for it; for Bound, the outcome that is judged; null: the default.
    Variation (*vary)(std::uint64_t draw) = nullptr;
    /// The other outcome of the comparison; null: the default.
    Variation (*base)(std::uint64_t draw) = nullptr;
    /// For Bound: the figure and its maximum, in the same unit.
    double (*figure)(const Blueprint& plan, const Outcome& outcome) = nullptr;
    double largest = 0.0;
};

std::span<const Relation> allRelations();
const Relation* findRelation(std::string_view name);

/// Results of one relation in members of one family.
struct Verdict {
    const Relation* relation = nullptr;
    int members = 0;
    int baseReached = 0;  ///< of the members
    int variedReached = 0;
    int worse = 0;           ///< members that only the base reached
    int better = 0;          ///< members that only the variation reached
    int differing = 0;       ///< members whose bits differ, or that end elsewhere, or exceed the bound
    double largest = 0.0;    ///< figure, or distance of the ends (m)
    std::uint64_t seed = 0;  ///< of the worst member, or of the first that got worse
    bool hasSeed = false;

    /// True if the relation holds in the family.
    [[nodiscard]] bool holds() const;
    void add(const Verdict& more);
};

/// The result for one member. @param base the default outcome, which several relations share
Verdict judge(const Relation& relation, const Family& family, const Blueprint& plan, std::uint64_t seed,
              const Outcome& base);

}  // namespace plumb::families
