#pragma once

#include "core/profile.hpp"
#include "physics/kernels.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

struct StepContext {
    World& world;
    Workspace& work;
    float dt;  ///< s
    TaskPool* pool;
    ContactHooks hooks;
    std::uint32_t effects;  ///< bits of the effects that run in this step

    /// True if a loop over `count` elements is divided among threads in pieces of `grain`.
    [[nodiscard]] bool isShared(int count, int grain) const { return pool != nullptr && count > grain; }
    [[nodiscard]] bool runs(Effect effect) const { return (effects & Manifest::bit(effect)) != 0; }
    /// True if the effect runs; counts the run for runsOf(). For effects that are a part of a stage.
    [[nodiscard]] bool starts(Effect effect) const {
        if (!runs(effect)) return false;
        work.effectsRun |= Manifest::bit(effect);
        return true;
    }
    /// True if no body in the world can rotate: contacts have one point and no lever arms, and the solver can
    /// use its reduced kernels. Only the full kernels support restitution, rolling resistance and joints.
    [[nodiscard]] bool isWithoutRotation() const {
        constexpr auto kTurning = static_cast<std::size_t>(Effect::Rotation);
        return !runs(Effect::Rotation) && !runs(Effect::SoftBodies) &&
               world.manifest.requesters[kTurning] == 0 && !runs(Effect::Restitution) &&
               !runs(Effect::Rolling) && !runs(Effect::Joints);
    }
};

/// Calls a callback of StepOptions::hooks, during which the world must not be changed.
template <class Call>
auto ask(World& world, Call&& call) {
    struct Asking {  // resets the flag even if the callback throws
        bool& flag;
        ~Asking() { flag = false; }
    };
    const Asking asking{world.work.isInCallback = true};
    return call();
}

/// True if the callback ContactHooks::filter allows these two shapes to collide.
inline bool mayMeet(const StepContext& step, std::uint32_t a, std::uint32_t b) {
    return step.hooks.filter == nullptr || ask(step.world, [&] {
               return step.hooks.filter(step.hooks.context, step.world, idOfShape(step.world, a),
                                        idOfShape(step.world, b));
           });
}

/// True if the callback ContactHooks::preSolve lets this contact exert forces.
inline bool mayPush(const StepContext& step, const Contact& contact) {
    const ContactHooks& hooks = step.hooks;
    return hooks.preSolve == nullptr ||
           ask(step.world, [&] { return hooks.preSolve(hooks.context, step.world, contact); });
}

constexpr int piecesOf(int count, int grain) { return (count + grain - 1) / grain; }

/// Splits 0..count-1 into pieces of `grain` and runs `act(begin, end, piece)` for each, on all threads.
template <class Act>
void forPieces(TaskPool* pool, int count, int grain, Act&& act) {
    if (count == 0) return;
    if (pool == nullptr || count <= grain) return act(0, count, 0);
    const int pieces = piecesOf(count, grain);
    // Captures by value, so that the compiler can keep the captures of `act` in registers.
    pool->run(pieces, [=](int piece, int) {
        act(piece * grain, piece + 1 < pieces ? (piece + 1) * grain : count, piece);
    });
}

/// Runs `act(i)` for 0..count-1, divided among threads in pieces of `grain`.
template <class Act>
void forEach(TaskPool* pool, std::size_t count, int grain, Act&& act) {
    forPieces(pool, static_cast<int>(count), grain, [&](int begin, int end, int) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) act(i);
    });
}

/// Runs `act(begin, end, found)` for pieces of `grain` elements; `found` is the element of `all` for this
/// piece. The elements of `all`, in this order, contain the same results as with a single thread.
template <class Found, class Act>
void forPieces(TaskPool* pool, std::size_t count, int grain, std::vector<Found>& all, Act&& act) {
    const auto pieces = static_cast<std::size_t>(piecesOf(static_cast<int>(count), grain));
    if (all.size() < pieces) all.resize(pieces);
    for (Found& found : all) found.clear();
    forPieces(pool, static_cast<int>(count), grain, [&](int begin, int end, int piece) {
        act(static_cast<std::size_t>(begin), static_cast<std::size_t>(end),
            all[static_cast<std::size_t>(piece)]);
    });
}

/// Runs `act(begin, end, list)` for pieces of `grain`; joins their lists to `all`. lists: scratch.
template <class T, class Act>
void collect(const StepContext& step, std::size_t count, int grain, std::vector<std::vector<T>>& lists,
             std::vector<T>& all, Act&& act) {
    all.clear();
    if (!step.isShared(static_cast<int>(count), grain)) return act(std::size_t{0}, count, all);
    forPieces(step.pool, count, grain, lists, act);
    for (const std::vector<T>& list : lists) all.insert(all.end(), list.begin(), list.end());
}

/// Lists the indices i of 0..count-1 for which `is(i)` holds, in ascending order, on all threads.
template <class Is>
void collectIf(const StepContext& step, std::size_t count, std::vector<std::uint32_t>& all, Is&& is) {
    constexpr int kGrain = 256;
    collect(step, count, kGrain, step.work.pieceLists, all,
            [&](std::size_t begin, std::size_t end, std::vector<std::uint32_t>& found) {
                for (std::size_t i = begin; i < end; ++i) {
                    if (is(i)) found.push_back(static_cast<std::uint32_t>(i));
                }
            });
}

/// Calls act(i) sequentially for each i of 0..count-1 for which `is(i)` holds, evaluated on all threads.
template <class Is, class Act>
void forEachIf(const StepContext& step, std::size_t count, Is&& is, Act&& act) {
    collectIf(step, count, step.work.pieceFound, is);
    for (const std::uint32_t i : step.work.pieceFound) act(i);
}

// The stages in their order, each in a file of its name in stages/. Names without `work.` belong to World.

/// Reads: moved, bounds, filters. Writes: contacts (new), work.broadPhase, work.pairs.
void findPairs(StepContext& step);
/// Reads: poses, geometry. Writes: contacts (points, flags), sleepers, islands, events (Ended).
void updateContacts(StepContext& step);
/// Reads: contacts, one-way directions. Writes: contacts (kPassing, kDisabled), events (Ended).
void filterContacts(StepContext& step);
/// Reads: awake joints. Writes: colors of new joints, work.colourMasks.
void colourJoints(StepContext& step);
/// Reads: fields. Writes: velocities of bodies near explosions; fields (removes explosions).
void explode(StepContext& step);
/// Reads: fields, rest times. Writes: fields (removes those of destroyed bodies); wakes bodies on springs.
void prepareFields(StepContext& step);
/// Moves the soft bodies that cannot push a rigid body. Stores the contacts of the others, which solve()
/// moves, in work.softSurroundings. Reads: geometry, poses, islands, work.broadPhase.
void moveSoftBodies(StepContext& step);
/// Reads: drives, masses, settings, soft contacts. Writes: work.slots, .groups, .velocity and others.
void gatherBodies(StepContext& step);
/// Reads: fields, poses, motions, work.slots, work.drive. Writes: work.smooth.
void applyFields(StepContext& step);
/// Reads: contacts, joints, masses. Writes: colors, the constraint blocks in `work`.
void prepareConstraints(StepContext& step);
/// Reads and writes: work.velocity, work.deltaPosition, blocks, soft bodies. Writes: impulses.
void solve(StepContext& step);
/// Applies fields to the bodies of a group that have contacts or joints, before a substep of h seconds that
/// begins `elapsed` seconds after the start of the step.
void driveBodies(StepContext& step, const SolveGroup& group, float h, float elapsed);
/// Computes work.smooth.works after the last substep of a group.
void finishDriving(StepContext& step, const SolveGroup& group);
/// Applies forces and links of the soft bodies of a group in a substep of h seconds, before their contacts.
void springSoft(StepContext& step, const SoftGroup& group, float h, int substep);
/// Computes velocities of particles from their displacements, at the end of a substep.
void closeSoft(const StepContext& step, const SoftGroup& group, float h);
void finishSoft(StepContext& step, const SoftGroup& group, float h);  ///< after the last substep
/// Reads: fields, work.smooth. Writes: work.velocity, work.deltaPosition of bodies in SmoothForces::flyers.
void integrateFreeBodies(StepContext& step);
/// Reads: joints, contacts, islands, work.deltaPosition. Writes: work.velocity, energy shares.
void keepEnergy(StepContext& step);
/// Reads: work.velocity, work.deltaPosition. Writes: poses, motions, bounds, moved.
void finishBodies(StepContext& step);
/// Reads: contacts, flags of bodies that moved fast. Writes: the poses of these bodies.
void sweepFastBodies(StepContext& step);
/// Reads: rest times, islands. Writes: awake, contacts, sleepers.
void putToSleep(StepContext& step);
/// Reads: contacts. Writes: events.
void publishEvents(StepContext& step);

}  // namespace plumb::physics
