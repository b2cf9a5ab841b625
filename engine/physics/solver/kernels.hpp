#pragma once

#include <cstdint>

#include "physics/narrowphase/box_lanes.hpp"
#include "physics/solver/contact_block.hpp"

namespace plumb::physics {

/// What `prepare` reads: rows of four floats of contacts, and of bodies by body index.
struct ContactSource {
    const Float4* contacts;     ///< kContactRows for each
    const Float4* masses;       ///< inverse mass, inverse inertia
    const Float4* motions;      ///< velocity x, y, angular velocity
    const std::int32_t* slots;  ///< by body
    std::int32_t idleSlot;      ///< the first of eight that belong to nobody
    bool turning;               ///< bodies turn
    bool surfaces;              ///< some contact has a surface speed
    bool kinematics;            ///< some body is kinematic
};

/// What is done with contacts of a kind. Ranges are blocks.
template <class Block, class Bodies = SolverBodies>
struct ContactKernels {
    void (*prepare)(const ContactSource& source, const BlockLanes* lanes, Block* blocks, int begin, int end);
    void (*warmStart)(const Bodies& bodies, const BlockLanes* lanes, Block* blocks, int begin, int end);
    /// With errors pushed out: ends with the velocities that move the bodies.
    void (*push)(const Bodies& bodies, const ContactPass& pass, const BlockLanes* lanes, Block* blocks,
                 int begin, int end);
    /// Without: takes back the velocity that only pushed errors out.
    void (*relax)(const Bodies& bodies, const ContactPass& pass, const BlockLanes* lanes, Block* blocks,
                  int begin, int end);
    void (*store)(Float4* contacts, const BlockLanes* lanes, const Block* blocks, int begin, int end);
};

/// The inner loops of the step, in lanes of eight: built for each instruction set, chosen at run time, all
/// with the same bits. So do all kinds of contacts that a scene could be solved with: what is left out would
/// have added zero.
struct SolverKernels {
    const char* name;
    // By whether something rubs.
    ContactKernels<ContactBlock> contacts[2];
    ContactKernels<FixedContactBlock> fixedContacts[2];
    ContactKernels<PlainBlock, PlainBodies> plain[2];  ///< where nobody turns
    ContactKernels<PlainFixedBlock, PlainBodies> plainFixed[2];

    // Ranges are bodies in multiples of eight.

    /// Velocities grow by what drives the bodies; from the second substep on the impulses of the one before
    /// are given again, all at once.
    void (*accelerate)(const SolverBodies& bodies, float h, bool first, int begin, int end);
    void (*move)(const SolverBodies& bodies, float h, int begin, int end);
    void (*moveUnturned)(const SolverBodies& bodies, float h, int begin, int end);
    void (*acceleratePlain)(const PlainBodies& bodies, float h, bool first, int begin, int end);
    void (*movePlain)(const PlainBodies& bodies, int begin, int end);

    /// The same bits as collideBoxes() of one pair.
    void (*collideBoxes)(const BoxPairs& pairs, float speculative, BoxTouches& touches);
};

/// The kernels of this machine's widest instruction set, or those that setSimdWidth() asks for.
const SolverKernels& solverKernels();

}  // namespace plumb::physics
