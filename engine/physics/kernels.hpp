#pragma once

#include <cstdint>

#include "physics/joints/joint_block.hpp"
#include "physics/narrowphase/collide.hpp"
#include "physics/solver/contact_block.hpp"

namespace plumb::physics {

/// Input of `prepare`: rows of four floats of contacts, and of bodies by body index.
struct ContactSource {
    const Float4* contacts;     ///< kContactRows for each
    const Float4* masses;       ///< inverse mass, inverse inertia
    const Float4* motions;      ///< velocity x, y, angular velocity
    const std::int32_t* slots;  ///< by body
    std::int32_t idleSlot;      ///< first of eight slots without a body
    bool turning;               ///< bodies can rotate
    bool surfaces;              ///< some contact has a surface speed
    bool kinematics;            ///< some body is kinematic
};

/// The passes over constraints. The biased pass (Push) also closes errors, and leaves the velocities that
/// move the bodies; the relax pass takes back the velocity that only closed errors.
enum class PassKind : std::uint8_t { WarmStart, Push, Relax };

/// Operations on contacts of one kind. Ranges are blocks.
template <class Block, class Bodies>
struct ContactKernels {
    void (*prepare)(const ContactSource& source, const BlockLanes* lanes, Block* blocks, int begin, int end);
    /// By PassKind.
    void (*passes[3])(const Bodies& bodies, const ContactPass& pass, const BlockLanes* lanes, Block* blocks,
                      int begin, int end);
    void (*store)(Float4* contacts, const BlockLanes* lanes, const Block* blocks, int begin, int end);
};

/// Kernels of the groups in which bodies can rotate, or of those in which none can.
template <class Bodies>
struct GroupKernels {
    // Without and with friction.
    ContactKernels<typename Bodies::TwoBlock, Bodies> two[2];
    ContactKernels<typename Bodies::FixedBlock, Bodies> fixed[2];

    // Ranges are bodies in multiples of eight.

    /// Applies external accelerations and drag. From the second substep on it also repeats the velocity
    /// change by the impulses of the previous one: warm starting as one sum per body.
    void (*accelerate)(const Bodies& bodies, float h, bool first, int begin, int end);
    void (*move)(const Bodies& bodies, float h, int begin, int end);
};

/// Passes over a range of blocks of one kind: [PassKind][one-sided: the joints move only one of their
/// bodies].
template <class Block>
struct JointPasses {
    void (*passes[3][2])(const SolverBodies& bodies, const JointPass& pass, const BlockLanes* lanes,
                         Block* blocks, int begin, int end);
};

struct JointKernels : JointPasses<PointBlock>,
                      JointPasses<HingeBlock>,
                      JointPasses<RodBlock>,
                      JointPasses<SliderBlock> {};

/// Inner loops of the step in eight SIMD lanes, built for each instruction set and chosen at run time. All
/// builds give the same bits. The reduced kernels give the same bits as the full ones, because the omitted
/// terms are exactly zero.
struct SolverKernels {
    const char* name;
    GroupKernels<SolverBodies> rotating;
    GroupKernels<BodiesWithoutRotation> withoutRotation;
    void (*moveUnturned)(const SolverBodies& bodies, float h, int begin, int end);
    void (*collideBoxes)(const BoxPairs& pairs, float speculative, BoxTouches& touches);
    JointKernels joints;
};

/// The kernels of this machine's widest instruction set, or of the one set by setSimdWidth().
const SolverKernels& solverKernels();

/// Used for SimdWidth::Scalar, which is a reference for tests where the processor has SIMD lanes; without
/// them it is the same as the architecture's baseline. Only programs that link them contain them.
extern const SolverKernels* scalarKernels;
void linkScalarKernels();

}  // namespace plumb::physics
