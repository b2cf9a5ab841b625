#pragma once

#include <span>
#include <string_view>

#include "tests/accuracy/trial.hpp"

namespace plumb::accuracy {

/// Properties of a scene, which determine the solver settings (Method, trial.hpp) that it is run with.
enum Trait : unsigned {
    kJoints = 1,        ///< has joints: run with and without the direct solver for joints that form trees
    kSmoothForces = 2,  ///< only smooth forces, no contacts: run with all integrators
    kAnyEngine = 4,     ///< built with SceneBuilder only: run in other engines too
    kNoExactAnswer = 8  ///< no exact result: compared with the reference solver (reference/README.md)
};

/// A test scene that measures errors and compares them with goals. The
/// goals come from exact results or from the best results of engines.
struct Experiment {
    std::string_view name;
    double micros = 0.0;  ///< goal: maximum time of a step, µs; 0: no goal
    bool quick = true;    ///< true if it runs in less than a second at the default quality
    void (*run)(Trial& trial) = nullptr;
    unsigned traits = 0;  ///< bit set of Trait values
    Vec2 gravity{0.0f, -static_cast<float>(kGravity)};

    [[nodiscard]] bool has(Trait trait) const { return (traits & trait) != 0; }
};

/// Returns all experiments: those with exact results, then
/// those with goals, then those for the reference solver.
std::span<const Experiment> allExperiments();
const Experiment* findExperiment(std::string_view name);  ///< nullptr if there is none

// Single bodies with a closed-form solution: motion_experiments.cpp.
void freeFall(Trial& trial);
void projectile(Trial& trial);
void incline(Trial& trial);
void rollingDisc(Trial& trial);
void rockingPlank(Trial& trial);
void elasticPairs(Trial& trial);
void newtonsCradle(Trial& trial);
void obliqueDiscs(Trial& trial);

// Springs, drag and attractors without contacts: smooth_experiments.cpp.
void drag(Trial& trial);
void spring05(Trial& trial);
void spring2(Trial& trial);
void spring5(Trial& trial);
void spring10(Trial& trial);
void underdamped(Trial& trial);
void criticallyDamped(Trial& trial);
void overdamped(Trial& trial);
void resonance(Trial& trial);
void orbit(Trial& trial);

// Experiments with pendulums: pendulum_experiments.cpp.
void pendulum(Trial& trial);
void pendulum90(Trial& trial);
void pendulum170(Trial& trial);
void doublePendulum(Trial& trial);

// Experiments with impacts: impact_experiments.cpp.
void tenBounces(Trial& trial);
void bounces09(Trial& trial);
void bounces05(Trial& trial);
void bullet(Trial& trial);

// Experiments at stability limits: limit_experiments.cpp.
void frictionThreshold(Trial& trial);
void ladder(Trial& trial);
void stoneArch(Trial& trial);

// Experiments with stacks and other bodies at rest: standing_experiments.cpp.
void stackOf20(Trial& trial);
void heavyBox100(Trial& trial);
void heavyBox1000(Trial& trial);
void pyramidOf465(Trial& trial);
void heavyOnTwo(Trial& trial);
void heavyOnTen(Trial& trial);
void heavyTops(Trial& trial);
void stackOf15(Trial& trial);
void stackOf50(Trial& trial);
void stackOf100(Trial& trial);
void farPyramid(Trial& trial);

// Experiments with masonry and cards: building_experiments.cpp.
void arch(Trial& trial);
void cardHouse(Trial& trial);

// Experiments with heaps and overlaps: crowd_experiments.cpp.
void pileOf500(Trial& trial);
void overlapRecovery(Trial& trial);
void crampedCircles(Trial& trial);
void pit1000(Trial& trial);
void ragdollPile(Trial& trial);
void farAway(Trial& trial);

// Experiments with joints: joint_experiments.cpp.
void chain100(Trial& trial);
void chain1000(Trial& trial);
void catenary(Trial& trial);
void ballAndChain(Trial& trial);
void bridge160(Trial& trial);
void jointGrid(Trial& trial);

}  // namespace plumb::accuracy
