#pragma once

#include <cstdint>

#include "physics/joints/joint_block.hpp"
#include "physics/narrowphase/collide.hpp"
#include "physics/solver/contact_block.hpp"

namespace plumb::physics {

/// Input of ContactKernels::prepare: contacts and bodies as rows of four floats.
struct ContactSource {
    const Float4* contacts;     ///< kContactRows rows for each contact
    const Float4* masses;       ///< indexed by body: inverse mass, inverse inertia
    const Float4* motions;      ///< indexed by body: velocity x, y, angular velocity
    const std::int32_t* slots;  ///< indexed by body: its solver slot
    std::int32_t idleSlot;      ///< first of eight slots without a body
    bool turning;               ///< some body can rotate
    bool surfaces;              ///< some contact has a surface speed
    bool kinematics;            ///< some body is kinematic
};

/// The passes over constraints. The biased pass (Push) computes the velocities that move the bodies,
/// including those that close position errors; the relax pass removes the latter.
enum class PassKind : std::uint8_t { WarmStart, Push, Relax };

/// Functions for one kind of contact block. `begin` and `end` are a range of indices of blocks.
template <class Block, class Bodies>
struct ContactKernels {
    void (*prepare)(const ContactSource& source, const BlockLanes* lanes, Block* blocks, int begin, int end);
    /// The passes, indexed by PassKind.
    void (*passes[3])(const Bodies& bodies, const ContactPass& pass, const BlockLanes* lanes, Block* blocks,
                      int begin, int end);
    void (*store)(Float4* contacts, const BlockLanes* lanes, const Block* blocks, int begin, int end);
};

/// Kernels for groups in which bodies can rotate (SolverBodies) or none can (BodiesWithoutRotation).
template <class Bodies>
struct GroupKernels {
    // [0] without friction, [1] with it. two: between dynamic bodies; fixed: A is static or kinematic.
    ContactKernels<typename Bodies::TwoBlock, Bodies> two[2];
    ContactKernels<typename Bodies::FixedBlock, Bodies> fixed[2];

    // In the following, `begin` and `end` are a range of slots, in multiples of eight.

    /// Applies external accelerations and drag. From the second substep on it also adds the velocity change
    /// by all impulses of the previous substep: warm starting with one addition per body.
    void (*accelerate)(const Bodies& bodies, float h, bool first, int begin, int end);
    void (*move)(const Bodies& bodies, float h, int begin, int end);
};

/// Passes over blocks of joints of one kind: [PassKind][1 if each joint moves only one of its bodies].
template <class Block>
struct JointPasses {
    void (*passes[3][2])(const SolverBodies& bodies, const JointPass& pass, const BlockLanes* lanes,
                         Block* blocks, int begin, int end);
};

struct JointKernels : JointPasses<PointBlock>,
                      JointPasses<HingeBlock>,
                      JointPasses<RodBlock>,
                      JointPasses<SliderBlock> {};

/// Inner loops of the step in eight SIMD lanes, built for each instruction set and selected at run time. All
/// give the same bits, also kernels with and without rotation, because the omitted terms are exactly zero.
struct SolverKernels {
    const char* name;
    GroupKernels<SolverBodies> rotating;
    GroupKernels<BodiesWithoutRotation> withoutRotation;
    /// Moves the bodies in the slots begin to end - 1 by velocity * h, without rotating them.
    void (*moveWithoutRotation)(const SolverBodies& bodies, float h, int begin, int end);
    void (*collideBoxes)(const BoxPairs& pairs, float speculative, BoxTouches& touches);
    JointKernels joints;
};

/// Returns the kernels for this machine's widest instruction set, or for that set by setSimdWidth().
const SolverKernels& solverKernels();

/// Kernels for SimdWidth::Scalar, a reference for tests. Null unless the program calls linkScalarKernels(),
/// so that other programs do not contain them.
extern const SolverKernels* scalarKernels;
void linkScalarKernels();

}  // namespace plumb::physics
