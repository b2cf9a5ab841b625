#include "tests/accuracy/experiments.hpp"

#include <array>

namespace plumb::accuracy {

namespace {

constexpr Vec2 kWeightless{};

constexpr auto kExperiments = std::to_array<Experiment>({
    {"stack20", 25.0, true, stackOf20},
    {"heavy100", 4.0, true, heavyBox100},
    {"heavy1000", 9.0, true, heavyBox1000},
    {"chain100", 25.0, true, chain100},
    {"chain1000", 50.0, true, chain1000},
    {"pendulum", 4.0, true, pendulum},
    {"pyramid465", 900.0, false, pyramidOf465},
    {"bounces", 0.0, true, tenBounces},
    {"incline", 0.0, true, incline},
    {"freefall", 0.0, true, freeFall},
    {"projectile", 0.0, true, projectile},
    {"collisions", 0.0, true, elasticPairs, kWeightless},
    {"cradle", 0.0, true, newtonsCradle, kWeightless},
    {"oblique", 0.0, true, obliqueDiscs, kWeightless},
    {"rolling", 0.0, true, rollingDisc},
    {"rocking", 0.0, true, rockingPlank},
    {"ballandchain", 0.0, true, ballAndChain},
    {"bridge160", 0.0, false, bridge160},
    {"jointgrid100", 0.0, false, jointGrid},
    {"heavyontwo", 0.0, true, heavyOnTwo},
    {"heavyonten", 0.0, true, heavyOnTen},
    {"heavytops", 0.0, false, heavyTops},
    {"stack15", 0.0, true, stackOf15},
    {"stack50", 0.0, false, stackOf50},
    {"stack100", 0.0, false, stackOf100},
    {"arch", 0.0, true, arch},
    {"cardhouse", 0.0, true, cardHouse},
    {"pile500", 0.0, false, pileOf500},
    {"recovery", 0.0, true, overlapRecovery},
    {"cramped", 0.0, false, crampedCircles, kWeightless},
    {"farpyramid", 0.0, true, farPyramid},
});

}  // namespace

std::span<const Experiment> allExperiments() { return kExperiments; }

}  // namespace plumb::accuracy
