#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/outcome.hpp"

namespace plumb::families {

/// How two variations of a scene have to compare.
enum class Rule : std::uint8_t {
    SameBits,     ///< every bit of every pose and motion
    SameOutcome,  ///< as many members reach their goals, and where a family is not chaotic, at the same
                  ///< places
    NeverWorse,   ///< at least as many members reach their goals
    Bound         ///< a figure of each single outcome
};

/// Something that must hold for every scene, whatever its right answer is.
struct Relation {
    std::string_view name;
    std::string_view what;   ///< one sentence
    std::string_view bound;  ///< of its rule, with where it comes from
    Rule rule = Rule::SameOutcome;
    /// How a member is simulated for the comparison, from a number that is drawn for it, or of Bound, for the
    /// outcome that is judged; null for the default.
    Variation (*vary)(std::uint64_t draw) = nullptr;
    /// With what the varied outcome is compared; null: the default.
    Variation (*base)(std::uint64_t draw) = nullptr;
    /// Of Bound: the figure and its largest value, in the same unit.
    double (*figure)(const Blueprint& plan, const Outcome& outcome) = nullptr;
    double largest = 0.0;
};

std::span<const Relation> allRelations();
const Relation* findRelation(std::string_view name);

/// What one relation found in members of one family.
struct Verdict {
    const Relation* relation = nullptr;
    int members = 0;
    int baseReached = 0;  ///< of the members
    int variedReached = 0;
    int worse = 0;           ///< members that only the base reached
    int better = 0;          ///< members that only the variation reached
    int differing = 0;       ///< members whose bits differ, or that end elsewhere, or break the bound
    double largest = 0.0;    ///< figure, or distance of the ends (m)
    std::uint64_t seed = 0;  ///< of the worst member, or of the first that got worse
    bool hasSeed = false;

    /// Whether the relation holds in the family.
    [[nodiscard]] bool holds() const;
    void add(const Verdict& more);
};

/// The verdict on one member. @param base  the outcome at the default, which several relations share
Verdict judge(const Relation& relation, const Family& family, const Blueprint& plan, std::uint64_t seed,
              const Outcome& base);

}  // namespace plumb::families
