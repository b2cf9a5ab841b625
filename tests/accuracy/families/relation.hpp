#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/outcome.hpp"

namespace plumb::families {

/// Rule for comparing the results of a scene simulated in two variations (base and compared one).
enum class Rule : std::uint8_t {
    SameBits,     ///< all final poses and velocities are bit-identical
    SameOutcome,  ///< equally many members reach their goals and, unless
                  ///< the family is chaotic, their final positions agree
    NotFewer,     ///< no fewer members reach their goals than in the base variation,
                  ///< except by a difference that chance explains
    Bound         ///< no comparison: a figure of each outcome is limited
};

/// A property that must hold for every scene (member of a family), even if its exact result is unknown.
struct Relation {
    std::string_view name;
    std::string_view what;   ///< one sentence that states the property
    std::string_view bound;  ///< explanation of the accepted deviation
    Rule rule = Rule::SameOutcome;
    /// Returns the compared variation (for Bound: the checked one). `draw` is a random number of the
    /// member. Null: default variation.
    Variation (*vary)(std::uint64_t draw) = nullptr;
    /// Returns the base variation, with which the other one is compared; null: default variation.
    Variation (*base)(std::uint64_t draw) = nullptr;
    /// Only for Bound: computes the figure. `largest` is its maximum.
    double (*figure)(const Blueprint& plan, const Outcome& outcome) = nullptr;
    double largest = 0.0;
};

std::span<const Relation> allRelations();
const Relation* findRelation(std::string_view name);

/// Results of one relation in members of one family.
struct Verdict {
    const Relation* relation = nullptr;
    int members = 0;         ///< number of members checked
    int baseReached = 0;     ///< number of members that reach their goals in the base variation
    int variedReached = 0;   ///< number of members that reach their goals in the compared variation
    int worse = 0;           ///< members that reach their goals in the base variation only
    int better = 0;          ///< members that reach their goals in the compared variation only
    int differing = 0;       ///< members with different bits or final positions, or a figure above the bound
    double largest = 0.0;    ///< largest figure, or largest distance of final positions (m)
    std::uint64_t seed = 0;  ///< seed of the worst member, or of the first one that got worse; see hasSeed
    bool hasSeed = false;

    /// True if the relation holds in the family.
    [[nodiscard]] bool holds() const;
    void add(const Verdict& more);  ///< adds the results of other members
};

/// Checks a relation in one member, given as `plan` and `seed`.
/// @param base  the member's outcome in the default variation, shared by several relations
Verdict judge(const Relation& relation, const Family& family, const Blueprint& plan, std::uint64_t seed,
              const Outcome& base);

}  // namespace plumb::families
