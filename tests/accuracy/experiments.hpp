#pragma once

#include <span>
#include <string_view>

#include "tests/accuracy/trial.hpp"

namespace plumb::accuracy {

/// What a scene is made of, and so what is tried on it.
enum Trait : unsigned {
    kJoints = 1,        ///< joints: with and without trees
    kSmoothForces = 2,  ///< fields alone: all integrators
    kAnyEngine = 4,     ///< nothing but what a SceneBuilder has: other engines too
    kNoExactAnswer = 8  ///< the reference solver is asked
};

/// A scene whose outcome is known, or was measured in the best engines.
struct Experiment {
    std::string_view name;
    double micros = 0.0;  ///< target: a step takes no longer; 0 where none is set
    bool quick = true;    ///< a fraction of a second at the default quality
    void (*run)(Trial& trial) = nullptr;
    unsigned traits = 0;  ///< bits of Trait
    Vec2 gravity{0.0f, -static_cast<float>(kGravity)};

    [[nodiscard]] bool has(Trait trait) const { return (traits & trait) != 0; }
};

/// All: those of exact answers, then those with marks to reach, then those for the reference solver.
std::span<const Experiment> allExperiments();
const Experiment* findExperiment(std::string_view name);

// Of one thing whose motion has a formula: motion_experiments.cpp.
void freeFall(Trial& trial);
void projectile(Trial& trial);
void incline(Trial& trial);
void rollingDisc(Trial& trial);
void rockingPlank(Trial& trial);
void elasticPairs(Trial& trial);
void newtonsCradle(Trial& trial);
void obliqueDiscs(Trial& trial);

// Of what is driven by springs, drag and pulls alone: smooth_experiments.cpp.
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

// Of what swings: pendulum_experiments.cpp.
void pendulum(Trial& trial);
void pendulum90(Trial& trial);
void pendulum170(Trial& trial);
void doublePendulum(Trial& trial);

// Of blows: impact_experiments.cpp.
void tenBounces(Trial& trial);
void bounces09(Trial& trial);
void bounces05(Trial& trial);
void bullet(Trial& trial);

// Of what just holds: limit_experiments.cpp.
void frictionThreshold(Trial& trial);
void ladder(Trial& trial);
void stoneArch(Trial& trial);

// Of what should stay where it is: standing_experiments.cpp.
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

// Of masonry and cards: building_experiments.cpp.
void arch(Trial& trial);
void cardHouse(Trial& trial);

// Of heaps and overlaps: crowd_experiments.cpp.
void pileOf500(Trial& trial);
void overlapRecovery(Trial& trial);
void crampedCircles(Trial& trial);
void pit1000(Trial& trial);
void ragdollPile(Trial& trial);
void farAway(Trial& trial);

// Of joints: joint_experiments.cpp.
void chain100(Trial& trial);
void chain1000(Trial& trial);
void catenary(Trial& trial);
void ballAndChain(Trial& trial);
void bridge160(Trial& trial);
void jointGrid(Trial& trial);

}  // namespace plumb::accuracy
