#pragma once

#include "physics/solver/contact_block.hpp"
#include "physics/solver/joint_block.hpp"

namespace plumb::physics {

/// Passes over a range of blocks of one kind. One-sided: the joints move only one of their bodies.
template <class Block>
struct JointPasses {
    using Run = void (*)(const SolverBodies& bodies, const JointPass& pass, const JointLanes* lanes,
                         Block* blocks, int begin, int end);
    Run warmStart[2];  ///< [one-sided]
    Run push[2];
    Run relax[2];
};

/// Joint constraints in SIMD lanes: see SolverKernels.
struct JointKernels {
    JointPasses<PointBlock> points;
    JointPasses<HingeBlock> hinges;
    JointPasses<RodBlock> rods;
    JointPasses<SliderBlock> sliders;
};

const JointKernels& jointKernels();

}  // namespace plumb::physics
