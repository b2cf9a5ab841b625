#include "tests/accuracy/families/relation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/hash.hpp"
#include "core/random.hpp"

namespace plumb::families {

namespace {

/// Accepted difference of two success rates in standard deviations: chance exceeds it in one of 1000 cases.
constexpr double kSigmas = 3.3;
/// Maximum displacement without velocity in a step, m. Settings::pushSpeed separates overlapping bodies by up
/// to 5 cm in a step, and torn joints close at ten times that speed.
constexpr double kMaxJump = 0.5;
constexpr double kMaxGain = 0.01;  // maximum energy gain, ratio to the converted energy

Variation asDefault(std::uint64_t) { return {}; }

Variation withoutSleep(std::uint64_t) { return {.sleeping = false}; }
Variation withoutTrees(std::uint64_t) { return {.directJoints = false}; }
Variation withAllEffects(std::uint64_t) { return {.allEffects = true}; }
Variation atQuality1(std::uint64_t) { return {.quality = 1}; }
Variation atQuality3(std::uint64_t) { return {.quality = 3}; }
Variation atQuality4(std::uint64_t) { return {.quality = 4}; }
Variation atAutomaticQuality(std::uint64_t) { return {.quality = physics::kQualityOfWorld}; }
Variation inOtherOrder(std::uint64_t draw) { return {.shuffle = draw | 1}; }
Variation later(std::uint64_t draw) { return {.delay = 1 + static_cast<int>(draw % 17)}; }
Variation onTwoThreads(std::uint64_t) { return {.threads = 2}; }
Variation restored(std::uint64_t) { return {.restoreEvery = 7}; }

Variation inOtherBroadPhase(std::uint64_t draw) {
    constexpr std::uint64_t kOthers = static_cast<std::uint64_t>(physics::BroadPhaseKind::Count) - 1;
    return {.broadPhase = static_cast<physics::BroadPhaseKind>(1 + draw % kOthers)};
}

Variation placed(const Placement& placement) {
    Variation variation;
    variation.placement = placement;
    return variation;
}

Variation mirrored(std::uint64_t) { return placed({.mirrored = true}); }
Variation turned(std::uint64_t draw) { return placed({.quarterTurns = 1 + static_cast<int>(draw % 3)}); }
Variation smaller(std::uint64_t) { return placed({.scale = 0.125f}); }
Variation larger(std::uint64_t) { return placed({.scale = 8.0f}); }
Variation farAway(std::uint64_t draw) {
    return placed({.originX = draw % 2 == 0 ? 10000.0 : -10000.0, .originY = draw % 4 < 2 ? 0.0 : 10000.0});
}

double jumpOf(const Blueprint&, const Outcome& outcome) { return outcome.maxJump; }
double gainOf(const Blueprint& plan, const Outcome& outcome) {
    return plan.closed ? outcome.energyGain : 0.0;
}
double badNumbersOf(const Blueprint&, const Outcome& outcome) { return outcome.sound ? 0.0 : 1.0; }

constexpr std::string_view kSameShare =
    "the numbers of members that reach their goal in only one of the two differ by no more than 3.3 "
    "standard deviations; where both do, the results agree within the family's tolerance";

constexpr auto kRelations = std::to_array<Relation>({
    {"numbers", "all numbers stay finite", "all", Rule::Bound, nullptr, nullptr, badNumbersOf, 0.0},
    {"jump", "no body moves further in a step than its velocity, and impacts within the step, explain",
     "0.5 m: ten times the push-out speed for a step, at which torn joints close", Rule::Bound, nullptr,
     nullptr, jumpOf, kMaxJump},
    {"energy", "scenes without motors and kinematic bodies gain no energy",
     "1 % of the energy that was converted", Rule::Bound, nullptr, nullptr, gainOf, kMaxGain},
    {"energy-at-4",
     "scenes without motors gain no energy at quality 4, with joints and contacts 16 times as stiff",
     "1 % of the energy that was converted", Rule::Bound, atQuality4, nullptr, gainOf, kMaxGain},
    {"sleep", "the result does not depend on whether bodies may sleep", kSameShare, Rule::SameOutcome,
     withoutSleep},
    {"direct-joints", "the direct solver for joints is never worse than the iterative one",
     "members that reach their goal only with the iterative solver, by no more than chance", Rule::NotFewer,
     asDefault, withoutTrees},
    {"all-effects", "an effect that nothing requires changes nothing", "the same bits", Rule::SameBits,
     withAllEffects},
    {"broad-phase", "every broad phase finds the same pairs", "the same bits", Rule::SameBits,
     inOtherBroadPhase},
    {"threads", "two threads give the same result as one", "the same bits", Rule::SameBits, onTwoThreads},
    {"restore", "replacing the world by a copy in every 7th step changes nothing", "the same bits",
     Rule::SameBits, restored},
    {"later", "starting 1 to 17 steps later changes nothing", "the same bits", Rule::SameBits, later},
    {"quality-2-over-1", "quality 2 is never worse than 1", "by no more than chance", Rule::NotFewer,
     asDefault, atQuality1},
    {"quality-3-over-2", "quality 3 is never worse than 2", "by no more than chance", Rule::NotFewer,
     atQuality3, asDefault},
    {"quality-4-over-3", "quality 4 is never worse than 3", "by no more than chance", Rule::NotFewer,
     atQuality4, atQuality3},
    {"automatic-over-2", "automatic quality is never worse than 2", "by no more than chance", Rule::NotFewer,
     atAutomaticQuality, asDefault},
    {"order", "the result does not depend on the order in which bodies and joints are created", kSameShare,
     Rule::SameOutcome, inOtherOrder},
    {"mirror", "the mirrored scene gives the mirrored result", kSameShare, Rule::SameOutcome, mirrored},
    {"quarter-turns", "the scene rotated together with gravity gives the rotated result", kSameShare,
     Rule::SameOutcome, turned},
    {"far-away", "the result is the same 10 km from the origin", kSameShare, Rule::SameOutcome, farAway},
    {"smaller", "lengths, speeds, gravity and the length settings times 1/8: the same result", kSameShare,
     Rule::SameOutcome, smaller},
    {"larger", "lengths, speeds, gravity and the length settings times 8: the same result", kSameShare,
     Rule::SameOutcome, larger},
});

bool exceedsChance(int one, int other) {
    return static_cast<double>(one - other) > kSigmas * std::sqrt(static_cast<double>(one + other));
}

void note(Verdict& verdict, std::uint64_t seed, double figure) {
    if (verdict.hasSeed && figure <= verdict.largest) return;
    verdict.largest = figure;
    verdict.seed = seed;
    verdict.hasSeed = true;
}

std::uint64_t drawOf(const Relation& relation, std::uint64_t seed) {
    Hasher mixed;
    mixed.add(relation.name);
    mixed.add(seed);
    return mixed.value();
}

}  // namespace

std::span<const Relation> allRelations() { return kRelations; }

const Relation* findRelation(std::string_view name) {
    const auto found = std::find_if(kRelations.begin(), kRelations.end(),
                                    [name](const Relation& relation) { return relation.name == name; });
    return found == kRelations.end() ? nullptr : &*found;
}

bool Verdict::holds() const {
    switch (relation->rule) {
        case Rule::SameBits:
        case Rule::Bound: return differing == 0;
        case Rule::SameOutcome:
            return differing == 0 && !exceedsChance(worse, better) && !exceedsChance(better, worse);
        case Rule::NotFewer: return !exceedsChance(worse, better);
    }
    return false;
}

void Verdict::add(const Verdict& more) {
    if (more.hasSeed && (!hasSeed || more.largest > largest)) {
        largest = more.largest;
        seed = more.seed;
        hasSeed = true;
    }
    members += more.members;
    baseReached += more.baseReached;
    variedReached += more.variedReached;
    worse += more.worse;
    better += more.better;
    differing += more.differing;
}

Verdict judge(const Relation& relation, const Family& family, const Blueprint& plan, std::uint64_t seed,
              const Outcome& usual) {
    Verdict verdict;
    verdict.relation = &relation;
    verdict.members = 1;
    const std::uint64_t draw = drawOf(relation, seed);
    if (relation.rule == Rule::Bound) {
        const Outcome judged = relation.vary == nullptr ? usual : play(plan, relation.vary(draw));
        const double figure = relation.figure(plan, judged);
        note(verdict, seed, figure);
        verdict.differing = figure > relation.largest ? 1 : 0;
        verdict.baseReached = judged.reached ? 1 : 0;
        return verdict;
    }
    const Outcome base =
        relation.base == nullptr || relation.base == &asDefault ? usual : play(plan, relation.base(draw));
    const Outcome varied = relation.vary == &asDefault ? usual : play(plan, relation.vary(draw));
    verdict.baseReached = base.reached ? 1 : 0;
    verdict.variedReached = varied.reached ? 1 : 0;
    verdict.worse = base.reached && !varied.reached ? 1 : 0;
    verdict.better = !base.reached && varied.reached ? 1 : 0;
    if (relation.rule == Rule::SameBits) {
        verdict.differing = base.bits != varied.bits ? 1 : 0;
        if (verdict.differing > 0) note(verdict, seed, largestDistance(base, varied));
        return verdict;
    }
    if (relation.rule == Rule::SameOutcome && family.tolerance > 0.0 && base.reached && varied.reached) {
        const double distance = largestDistance(base, varied);
        note(verdict, seed, distance);
        verdict.differing = distance > family.tolerance ? 1 : 0;
    }
    if (verdict.worse > 0 || (verdict.better > 0 && relation.rule == Rule::SameOutcome))
        note(verdict, seed, 1.0e9);
    return verdict;
}

}  // namespace plumb::families
