#include "tests/accuracy/experiments.hpp"

#include <algorithm>
#include <array>

namespace plumb::accuracy {

namespace {

constexpr Vec2 kWeightless{};

constexpr auto kExperiments = std::to_array<Experiment>({
    {"freefall", 0.0, true, freeFall, kAnyEngine},
    {"projectile", 0.0, true, projectile, kAnyEngine},
    {"drag", 0.0, true, drag, kAnyEngine},
    {"spring05", 0.0, true, spring05, kSmoothForces, kWeightless},
    {"spring2", 0.0, true, spring2, kSmoothForces, kWeightless},
    {"spring5", 0.0, true, spring5, kSmoothForces, kWeightless},
    {"spring10", 0.0, true, spring10, kSmoothForces, kWeightless},
    {"underdamped", 0.0, true, underdamped, kSmoothForces, kWeightless},
    {"critical", 0.0, true, criticallyDamped, kSmoothForces, kWeightless},
    {"overdamped", 0.0, true, overdamped, kSmoothForces, kWeightless},
    {"resonance", 0.0, true, resonance, kSmoothForces, kWeightless},
    {"pendulum", 4.0, true, pendulum, kJoints | kAnyEngine},
    {"pendulum90", 0.0, true, pendulum90, kJoints | kAnyEngine},
    {"pendulum170", 0.0, true, pendulum170, kJoints | kAnyEngine},
    {"doublependulum", 0.0, true, doublePendulum, kJoints | kAnyEngine},
    {"orbit", 0.0, true, orbit, kSmoothForces, kWeightless},
    {"incline", 0.0, true, incline, kAnyEngine},
    {"threshold", 0.0, true, frictionThreshold, kAnyEngine},
    {"rolling", 0.0, true, rollingDisc, kAnyEngine},
    {"bounces", 0.0, true, tenBounces, kAnyEngine},
    {"bounces09", 0.0, true, bounces09, kAnyEngine},
    {"bounces05", 0.0, true, bounces05, kAnyEngine},
    {"collisions", 0.0, true, elasticPairs, kAnyEngine, kWeightless},
    {"cradle", 0.0, true, newtonsCradle, kAnyEngine, kWeightless},
    {"oblique", 0.0, true, obliqueDiscs, kAnyEngine, kWeightless},
    {"stack20", 25.0, true, stackOf20, kAnyEngine},
    {"heavy100", 4.0, true, heavyBox100, kAnyEngine},
    {"heavy1000", 9.0, true, heavyBox1000, kAnyEngine},
    {"chain100", 25.0, true, chain100, kJoints | kAnyEngine},
    {"chain1000", 50.0, true, chain1000, kJoints | kAnyEngine},
    {"catenary", 0.0, true, catenary, kJoints | kAnyEngine},
    {"ladder", 0.0, true, ladder, kAnyEngine},
    {"stonearch", 0.0, false, stoneArch, kAnyEngine},
    {"bullet", 0.0, true, bullet, kAnyEngine, kWeightless},

    {"rocking", 0.0, true, rockingPlank, kAnyEngine},
    {"ballandchain", 0.0, true, ballAndChain, kJoints},
    {"bridge160", 0.0, false, bridge160, kJoints | kAnyEngine},
    {"jointgrid100", 0.0, false, jointGrid, kJoints},
    {"heavyontwo", 0.0, true, heavyOnTwo, kAnyEngine},
    {"heavyonten", 0.0, true, heavyOnTen, kAnyEngine},
    {"heavytops", 0.0, false, heavyTops, kAnyEngine},
    {"stack15", 0.0, true, stackOf15, kAnyEngine},
    {"stack50", 0.0, false, stackOf50, kAnyEngine},
    {"stack100", 0.0, false, stackOf100, kAnyEngine},
    {"arch", 0.0, true, arch, 0},
    {"farpyramid", 0.0, true, farPyramid, 0},
    {"pile500", 0.0, false, pileOf500, kAnyEngine},
    {"cramped", 0.0, false, crampedCircles, 0, kWeightless},

    {"pyramid465", 900.0, false, pyramidOf465, kAnyEngine | kNoExactAnswer},
    // Not kAnyEngine: Box2D aborts the program when it creates a card 1 mm thick.
    {"cardhouse", 0.0, true, cardHouse, kNoExactAnswer},
    {"recovery", 0.0, true, overlapRecovery, kAnyEngine | kNoExactAnswer},
    {"ragdolls", 0.0, false, ragdollPile, kJoints | kNoExactAnswer},
    {"far", 0.0, true, farAway, kNoExactAnswer},
    {"pit1000", 0.0, false, pit1000, kAnyEngine | kNoExactAnswer},
});

}  // namespace

std::span<const Experiment> allExperiments() { return kExperiments; }

const Experiment* findExperiment(std::string_view name) {
    const auto found = std::find_if(kExperiments.begin(), kExperiments.end(),
                                    [name](const Experiment& experiment) { return experiment.name == name; });
    return found != kExperiments.end() ? &*found : nullptr;
}

}  // namespace plumb::accuracy
