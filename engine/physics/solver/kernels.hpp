#pragma once

#include <cstdint>

#include "physics/narrowphase/box_lanes.hpp"
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

/// Operations on contacts of one kind. Ranges are blocks.
template <class Block, class Bodies = SolverBodies>
struct ContactKernels {
    void (*prepare)(const ContactSource& source, const BlockLanes* lanes, Block* blocks, int begin, int end);
    void (*warmStart)(const Bodies& bodies, const BlockLanes* lanes, Block* blocks, int begin, int end);
    /// Biased pass: also pushes overlaps out. Leaves the velocities that move the bodies.
    void (*push)(const Bodies& bodies, const ContactPass& pass, const BlockLanes* lanes, Block* blocks,
                 int begin, int end);
    /// Relax pass, without bias: takes back the velocity that only pushed overlaps out.
    void (*relax)(const Bodies& bodies, const ContactPass& pass, const BlockLanes* lanes, Block* blocks,
                  int begin, int end);
    void (*store)(Float4* contacts, const BlockLanes* lanes, const Block* blocks, int begin, int end);
};

/// Inner loops of the step in eight SIMD lanes, built for each instruction set and chosen at run time. All
/// builds give the same bits. The reduced kernels give the same bits as the full ones, because the omitted
/// terms are exactly zero.
struct SolverKernels {
    const char* name;
    // Without and with friction.
    ContactKernels<ContactBlock> contacts[2];
    ContactKernels<FixedContactBlock> fixedContacts[2];
    ContactKernels<BlockWithoutRotation, BodiesWithoutRotation> plain[2];  ///< for steps without rotation
    ContactKernels<FixedBlockWithoutRotation, BodiesWithoutRotation> plainFixed[2];

    // Ranges are bodies in multiples of eight.

    /// Applies external accelerations and drag. From the second substep on it also repeats the velocity
    /// change by the impulses of the previous one: warm starting as one sum per body.
    void (*accelerate)(const SolverBodies& bodies, float h, bool first, int begin, int end);
    void (*move)(const SolverBodies& bodies, float h, int begin, int end);
    void (*moveUnturned)(const SolverBodies& bodies, float h, int begin, int end);
    void (*acceleratePlain)(const BodiesWithoutRotation& bodies, float h, bool first, int begin, int end);
    void (*movePlain)(const BodiesWithoutRotation& bodies, int begin, int end);

    void (*collideBoxes)(const BoxPairs& pairs, float speculative, BoxTouches& touches);
};

/// The kernels of this machine's widest instruction set, or of the one set by setSimdWidth().
const SolverKernels& solverKernels();

}  // namespace plumb::physics
