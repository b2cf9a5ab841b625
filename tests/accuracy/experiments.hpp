#pragma once

#include <span>
#include <string_view>

#include "tests/accuracy/trial.hpp"

namespace plumb::accuracy {

/// A scene whose outcome is known, or was measured in the best engines.
struct Experiment {
    std::string_view name;
    double micros = 0.0;  ///< target: a step takes no longer; 0 where none is set
    bool quick = true;    ///< a fraction of a second at the default quality
    void (*run)(Trial& trial) = nullptr;
    Vec2 gravity{0.0f, -static_cast<float>(kGravity)};
};

/// All, in the order of ../shared/spec/accuracy.md section 3.
std::span<const Experiment> allExperiments();

// Of one thing whose motion has a formula: motion_experiments.cpp.
void freeFall(Trial& trial);
void projectile(Trial& trial);
void tenBounces(Trial& trial);
void incline(Trial& trial);
void rollingDisc(Trial& trial);
void rockingPlank(Trial& trial);
void elasticPairs(Trial& trial);
void newtonsCradle(Trial& trial);
void obliqueDiscs(Trial& trial);

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

// Of joints: joint_experiments.cpp.
void pendulum(Trial& trial);
void chain100(Trial& trial);
void chain1000(Trial& trial);
void ballAndChain(Trial& trial);
void bridge160(Trial& trial);
void jointGrid(Trial& trial);

}  // namespace plumb::accuracy
