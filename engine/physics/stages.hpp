#pragma once

#include "core/profile.hpp"
#include "core/task_pool.hpp"
#include "physics/contact_hooks.hpp"
#include "physics/solver/kernels.hpp"
#include "physics/workspace.hpp"
#include "physics/world.hpp"

namespace plumb::physics {

/// What every stage is given.
struct StepContext {
    World& world;
    Workspace& work;
    float dt;  ///< s
    TaskPool* pool;
    ContactHooks hooks;
    std::uint32_t effects;  ///< bits of those that run in this step

    [[nodiscard]] int threads() const { return pool != nullptr ? pool->threads() : 1; }
    [[nodiscard]] bool runs(Effect effect) const { return (effects & Manifest::bit(effect)) != 0; }
    /// Asked by the part of a stage that an effect is, before it runs: counts how often it did (runsOf).
    [[nodiscard]] bool starts(Effect effect) const {
        if (!runs(effect)) return false;
        work.effectsRun |= Manifest::bit(effect);
        return true;
    }
    /// Contacts have one point and no levers, as there is nobody who could be turned. Bounces, rolling and
    /// joints are written for full ones.
    [[nodiscard]] bool isPlain() const {
        constexpr auto kTurning = static_cast<std::size_t>(Effect::Rotation);
        return !runs(Effect::Rotation) && world.manifest.callers[kTurning] == 0 &&
               !runs(Effect::Restitution) && !runs(Effect::Rolling) && !runs(Effect::Joints);
    }
};

/// Cuts 0..count-1 into pieces of `grain` and runs `act(begin, end, piece)` for each, on all threads.
template <class Act>
void forPieces(const StepContext& step, int count, int grain, Act&& act) {
    if (count == 0) return;
    if (step.pool == nullptr || count <= grain) return act(0, count, 0);
    const int pieces = (count + grain - 1) / grain;
    step.pool->run(pieces, [&](int piece, int) {
        act(piece * grain, piece + 1 < pieces ? (piece + 1) * grain : count, piece);
    });
}
constexpr int piecesOf(int count, int grain) { return (count + grain - 1) / grain; }

// One line per stage, in the order of the step; each has a file of its own name in stages/.

/// Reads: moved, bounds, filters. Writes: contacts (new ones), work.broadPhase, work.pairs.
void findPairs(StepContext& step);
/// Reads: poses, geometry. Writes: contacts (points, flags), sleepers (who is woken), islands, events
/// (Ended).
void updateContacts(StepContext& step);
/// Reads: contacts, one-way directions. Writes: contacts (kPassing, kDisabled), events (Ended).
void filterContacts(StepContext& step);
/// Reads: awake joints. Writes: colours of new ones, work.colourMasks.
void colourJoints(StepContext& step);
/// Reads: fields. Writes: motions of bodies near an explosion; fields (it is gone).
void explode(StepContext& step);
/// Reads: fields, rest times. Writes: fields of bodies that are gone; who is woken by a spring.
void prepareFields(StepContext& step);
/// Reads: geometry, poses, contacts, work.broadPhase. Writes: soft bodies; motions of bodies that they push,
/// and work.softSurroundings (with what they push all step long).
void moveSoftBodies(StepContext& step);
/// Reads: drives, masses, settings, pushes of soft bodies. Writes: work.slots, work.groups, work.velocity and
/// its kin.
void gatherBodies(StepContext& step);
/// Reads: fields, poses, motions, work.slots. Writes: work.drive, work.smooth (who is integrated freely).
void applyFields(StepContext& step);
/// Reads: contacts, joints, masses. Writes: colours, work's blocks.
void prepareConstraints(StepContext& step);
/// Reads and writes: work.velocity, work.shift, work's blocks. Writes: impulses of contacts and joints.
void solve(StepContext& step);
/// Reads: fields, work.smooth. Writes: work.velocity, work.shift of bodies that only fields act on.
void integrateFlyers(StepContext& step);
/// Reads: joints, contacts, islands, work.shift. Writes: work.velocity, shares in energy.
void keepEnergy(StepContext& step);
/// Reads: work.velocity, work.shift. Writes: poses, motions, bounds, moved.
void finishBodies(StepContext& step);
/// Reads: contacts, flags of bodies that moved fast. Writes: their poses.
void sweepFastBodies(StepContext& step);
/// Reads: rest times, islands. Writes: awake, contacts, sleepers.
void putToSleep(StepContext& step);
/// Reads: contacts. Writes: events.
void publishEvents(StepContext& step);

}  // namespace plumb::physics
