#include <algorithm>
#include <cmath>

#include "physics/islands/quality.hpp"
#include "physics/islands/sleeping.hpp"
#include "physics/measure/measures.hpp"
#include "physics/solver/contact_extras.hpp"
#include "physics/solver/joint_lanes.hpp"
#include "physics/solver/passes.hpp"
#include "physics/stages.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

constexpr int kEnergyGrain = 256;

bool moves(const World& world, std::uint32_t body) {
    const BodyMotion& motion = world.bodies.motion[body];
    return !isDynamic(world, body) && (motion.velocity != Vec2{} || motion.angularVelocity != 0.0f);
}

/// True for joints that store or add energy. A motor of speed 0 is a brake.
bool isPowered(const World& world, std::uint32_t index) {
    const Joint& joint = world.joints.hot[index];
    const bool drives = (joint.flags & kDriven) != 0 && world.joints.definition[index].motor.speed != 0.0f;
    return drives || (joint.flags & (kSprung | kSoft | kEdited)) != 0 || joint.kind == JointKind::Mouse ||
           joint.kind == JointKind::Motor;
}

EnergyAccount& accountOf(const World& world, Workspace& work, std::uint32_t a, std::uint32_t b) {
    return work.accounts[work.roots[isDynamic(world, b) ? b : a]];
}

float energyOf(const BodyMass& mass, Vec2 velocity, float spin) {
    return 0.5f * (mass.mass * lengthSquared(velocity) + mass.inertia * spin * spin);
}

/// Returns the work (J) of external forces on a body in this step.
float workOn(const BodyMass& mass, const Workspace& work, std::size_t slot) {
    const Float4 &deltaPosition = work.deltaPosition[slot], &drive = work.drive[slot];
    const float ofFields = work.smooth.works.empty() ? 0.0f : work.smooth.works[slot];
    return mass.mass * (drive.x * deltaPosition.x + drive.y * deltaPosition.y) +
           mass.inertia * drive.z * deltaPosition.z + ofFields;
}

/// Returns the kinetic energy (J) of a body before this step.
float energyBefore(const World& world, std::uint32_t body) {
    const BodyMotion& before = world.bodies.motion[body];
    return energyOf(world.bodies.mass[body], before.velocity, before.angularVelocity);
}

/// Returns the number of slots of groups with rotation, which come first. Other bodies cannot gain energy.
std::size_t slotsWithRotation(const Workspace& work) {
    std::int32_t end = 0;
    for (const SolveGroup& group : work.groups) end = group.withoutRotation ? end : group.end;
    return static_cast<std::size_t>(end);
}

/// Finds bodies that gained kinetic energy by contacts, from other bodies or by solver errors.
void findGainers(StepContext& step) {
    const World& world = step.world;
    Workspace& work = step.work;
    work.gainers.clear();
    if (!step.runs(Effect::Contacts)) return;
    const std::size_t room = world.bodies.info.capacity();  // maximum, so that impacts allocate nothing
    work.accounts.reserve(room);
    for (auto* list : {&work.gainers, &work.openAccounts, &work.roots, &work.bookedBodies})
        list->reserve(room);
    const float slow = kCreeping * world.settings.pushSpeed;
    const bool bounces = step.runs(Effect::Restitution);
    const Float4* const velocities = work.velocity.data();
    const auto gains = [&](std::size_t slot) {
        const Float4& velocity = velocities[slot];
        // Coarse test, with the angular velocity as the speed at a radius of 1 m. Idle slots have speed 0.
        const float square = velocity.x * velocity.x + velocity.y * velocity.y + velocity.z * velocity.z;
        if (square <= slow * slow) return false;
        const std::uint32_t body = work.bodyOf[slot];
        const BodyMass& mass = world.bodies.mass[body];
        if (work.colourMasks[body] == 0 || (mass.inverseInertia == 0.0f && !bounces)) return false;
        const float energy = energyOf(mass, {velocity.x, velocity.y}, velocity.z);
        const float gain = energy - energyBefore(world, body) - workOn(mass, work, slot);
        return gain > std::max(kContactGain * energy, 0.5f * mass.mass * slow * slow);
    };
    collectIf(step, slotsWithRotation(work), work.gainers, gains);
    for (std::uint32_t& gainer : work.gainers) gainer = work.bodyOf[gainer];
}

void open(Workspace& work, std::uint32_t root, bool isJointed) {
    EnergyAccount& account = work.accounts[root];
    if (account.isOpen) return;
    account = {{.isLively = isJointed}, true, isJointed};
    work.openAccounts.push_back(root);
}

/// Opens an account for each island with joints or gainers.
void openAccounts(const World& world, Workspace& work) {
    work.accounts.resize(world.bodies.size());
    for (const std::uint32_t j : world.joints.awake) {
        const Joint& joint = world.joints.hot[j];
        for (const std::uint32_t body : {joint.bodyA, joint.bodyB}) {
            if (isDynamic(world, body)) open(work, work.roots[body], true);
        }
    }
    for (const std::uint32_t body : work.gainers) open(work, work.roots[body], false);
}

/// Sets isDriven and isRooted for joints that are powered or attached to a static or kinematic body.
void noteJoints(StepContext& step) {
    World& world = step.world;
    const std::vector<std::uint32_t>& awake = world.joints.awake;
    const auto matters = [&](std::size_t i) {
        return world.joints.hot[awake[i]].colour >= kFirstFixedColour || isPowered(world, awake[i]);
    };
    forEachIf(step, awake.size(), matters, [&](std::uint32_t i) {
        const std::uint32_t j = awake[i];
        Joint& joint = world.joints.hot[j];
        EnergyAccount& account = accountOf(world, step.work, joint.bodyA, joint.bodyB);
        account.isDriven |= isPowered(world, j) || moves(world, joint.bodyA) || moves(world, joint.bodyB);
        account.isRooted |= !isDynamic(world, joint.bodyA) || !isDynamic(world, joint.bodyB);
        if ((joint.flags & kEdited) != 0 && openingOf(world, j) <= world.settings.slop)
            joint.flags = static_cast<std::uint8_t>(joint.flags & ~kEdited);
    });
}

bool hasDrivers(const StepContext& step) {
    return step.runs(Effect::Kinematics) || step.runs(Effect::Conveyor);
}

/// Sets isDriven for contacts with moving kinematic bodies and conveyors, which do work on the island, and
/// isRooted for all contacts with static or kinematic bodies, which exchange momentum.
void noteHolders(StepContext& step) {
    const auto drives = [&](const Contact& contact) {
        return hasDrivers(step) && (contact.surfaceSpeed != 0.0f || moves(step.world, contact.bodyA));
    };
    forStores(step.work, blocksOf(step.work, false), [&](const auto& store, BlockRange range) {
        constexpr bool kFixed = decltype(store.blocks[0].a)::kFixed;
        if (!kFixed && !step.runs(Effect::Conveyor)) return;
        const auto contactAt = [&](std::size_t i) -> const Contact& {
            return step.world.contacts[static_cast<std::size_t>(store.lanes[i / kLanes].index[i % kLanes])];
        };
        const auto accountAt = [&](std::size_t i) -> EnergyAccount& {
            return accountOf(step.world, step.work, contactAt(i).bodyA, contactAt(i).bodyB);
        };
        const auto matters = [&](std::size_t i) {
            if (static_cast<std::int32_t>(i % kLanes) >= store.lanes[i / kLanes].count) return false;
            const EnergyAccount& account = accountAt(i);
            return (kFixed && !account.isRooted) || (!account.isDriven && drives(contactAt(i)));
        };
        forEachIf(step, static_cast<std::size_t>(range.end) * kLanes, matters, [&](std::uint32_t i) {
            accountAt(i).isRooted |= kFixed;
            accountAt(i).isDriven |= drives(contactAt(i));
        });
    });
}

/// Sets isDriven for islands that soft bodies may touch, because these do work on them.
void noteSoft(const StepContext& step) {
    if (!step.runs(Effect::SoftBodies)) return;
    for (const auto& [root, soft] : step.work.softSurroundings.neighbours)
        step.work.accounts[step.work.roots[root]].isDriven = true;
}

/// Sets isLively for islands with bounces. Without rotation and bounces contacts cannot add energy.
void noteBounces(StepContext& step) {
    if (!step.runs(Effect::Restitution)) return;
    const World& world = step.world;
    const auto bounces = [&](std::size_t i) {
        return pushes(step.work.contactKeys[i]) && world.contacts[i].bounciness != 0.0f;
    };
    forEachIf(step, step.work.contactKeys.size(), bounces, [&](std::uint32_t i) {
        accountOf(world, step.work, world.contacts[i].bodyA, world.contacts[i].bodyB).isLively = true;
    });
}

EnergySums sumsOf(const World& world, const Workspace& work, std::uint32_t body) {
    const auto slot = static_cast<std::size_t>(work.slots[body]);
    const Float4 &velocity = work.velocity[slot], &deltaPosition = work.deltaPosition[slot];
    const BodyMass& mass = world.bodies.mass[body];
    EnergySums sums;
    sums.energy = energyOf(mass, {velocity.x, velocity.y}, velocity.z);
    sums.work = workOn(mass, work, slot);
    sums.gain = sums.energy - energyBefore(world, body) - sums.work;
    sums.momentum = mass.mass * Vec2{velocity.x, velocity.y};
    sums.mass = mass.mass;
    sums.isLively = mass.inverseInertia > 0.0f;
    sums.displacement =
        0.5f * mass.mass * (deltaPosition.x * deltaPosition.x + deltaPosition.y * deltaPosition.y);
    return sums;
}

void add(const EnergySums& body, const EnergyShare& share, EnergyAccount& account) {
    account.energy += body.energy;
    account.work += body.work;
    account.gain += body.gain;
    account.momentum += body.momentum;
    account.mass += body.mass;
    account.isLively |= body.isLively;
    account.displacement += body.displacement;
    account.credit += share.credit;
    account.peak += share.peak;
}

/// Returns the factor in a step of a value that decays within `memory` seconds.
float fade(float dt, float memory) { return std::max(0.0f, 1.0f - dt / memory); }

/// Computes the excess energy by contacts, which unlike joints store no energy: there is no credit.
void settleContacts(EnergyAccount& account) {
    // finishBodies() handles bodies with a non-finite state.
    if (!std::isfinite(account.gain)) return;
    if (account.gain > kContactGain * account.energy) account.excess = account.gain;
}

/// Computes the excess energy by joints, which may return energy that they took shortly before (credit).
void settleJoints(EnergyAccount& account, float pushSpeed, float dt) {
    const float pushed = 0.5f * account.mass * pushSpeed * pushSpeed;
    const float wildPush = kWild * kJointPushing * kJointPushing;
    account.isWild = !std::isfinite(account.energy) ||
                     (!account.isDriven && account.energy > kWild * account.peak + wildPush * pushed);
    if (account.isWild) return;
    const float due = account.energy - account.gain + std::max(account.credit, 0.0f);
    account.peak = std::max(std::min(account.energy, due), account.peak * fade(dt, 2.0f * kMemory));
    account.credit -= account.gain;
    const float maximum = kIslandGain * account.peak, excess = -maximum - account.credit;
    if (account.isDriven) {
        account.credit = 0.0f;
    } else if (excess > 0.0f) {
        account.excess = excess;
        account.credit = -maximum;
    }
    const float farthest = (account.peak / (kWhipped * kWhipped) + pushed) * dt * dt;
    if (!account.isDriven && account.displacement > farthest)
        account.part = std::sqrt(farthest / account.displacement);
    // A credit up to `maximum` does not fade, because a pendulum takes and returns it in half a period.
    const float fading = account.credit - maximum;
    if (fading > 0.0f) account.credit = maximum + fading * fade(dt, kMemory);
}

/// Allows for the displacements by which joints close their errors in this step.
void allowClosing(StepContext& step) {
    const World& world = step.world;
    const float maximum = kJointPushing * world.settings.pushSpeed * step.dt;
    for (const std::uint32_t j : world.joints.awake) {
        EnergyAccount& account =
            accountOf(world, step.work, world.joints.hot[j].bodyA, world.joints.hot[j].bodyB);
        if (account.part == 1.0f) continue;
        const float closed = std::min(openingOf(world, j), maximum);
        const float more = 0.5f * account.mass * closed * closed / account.displacement;
        account.part = std::min(std::sqrt(account.part * account.part + more), 1.0f);
    }
}

/// Adds the kinetic energy of a body to `own`, and the part that is never removed to `minimum`.
void bookOwn(const World& world, const Workspace& work, std::uint32_t body, EnergyAccount& account) {
    const Float4& velocity = work.velocity[static_cast<std::size_t>(work.slots[body])];
    const BodyMass& mass = world.bodies.mass[body];
    const float own = energyOf(mass, Vec2{velocity.x, velocity.y} - account.middle, velocity.z);
    const float creeping = kCreeping * world.settings.pushSpeed;
    account.own += own;
    account.minimum += std::min(own, 0.5f * mass.mass * creeping * creeping);
}

/// Returns the velocity factor that removes the excess energy of an island.
float keptOf(const EnergyAccount& account) {
    if (!(account.own > account.minimum)) return 1.0f;
    return std::sqrt(std::max(account.own - account.excess, account.minimum) / account.own);
}

/// Returns the displacement factor, without which bodies would keep height from the removed energy.
float partOf(const EnergyAccount& account) {
    const float kept = account.keep * account.keep * account.own;
    const float unpaid = account.excess - (account.own - kept), raised = -account.work;
    if (!(unpaid > 0.0f && raised > 0.0f)) return account.part;
    return std::min(account.part, std::max(account.keep * account.keep, 1.0f - unpaid / raised));
}

void findParts(EnergyAccount& account) {
    if (account.excess > 0.0f) account.keep = keptOf(account);
    if (account.isJointed && account.keep < kWhipped) account.part = partOf(account);
    if (account.part == 1.0f) return;
    // With a smaller displacement gravity also does less work.
    account.excess += (1.0f - account.part) * std::max(account.work, 0.0f);
    account.keep = keptOf(account);
}

void scaleAbout(Vec2 middle, float factor, Float4& row) {
    row.x = middle.x + factor * (row.x - middle.x);
    row.y = middle.y + factor * (row.y - middle.y);
}

/// Keeps a body of an island with implausible energy at its pose and former velocity for this step.
void hold(const World& world, Workspace& work, std::uint32_t body) {
    const auto slot = static_cast<std::size_t>(work.slots[body]);
    const BodyMotion& motion = world.bodies.motion[body];
    work.velocity[slot] = {motion.velocity.x, motion.velocity.y, motion.angularVelocity,
                           work.velocity[slot].w};
    work.deltaPosition[slot] = {};
}

/// Scales a body's motion and stores its share of the account, by mass, because islands split and merge.
void share(StepContext& step, std::uint32_t body, const EnergyAccount& account) {
    Workspace& work = step.work;
    if (account.isWild) return hold(step.world, work, body);
    const float part = step.world.bodies.mass[body].mass / account.mass;
    if (account.isJointed) step.world.bodies.energies[body] = {account.credit * part, account.peak * part};
    const auto slot = static_cast<std::size_t>(work.slots[body]);
    if (account.keep < 1.0f) {
        Float4& velocity = work.velocity[slot];
        scaleAbout(account.middle, account.keep, velocity);
        velocity.z *= account.keep;
    }
    if (account.part < 1.0f) {
        // Otherwise the body would keep potential energy from the unstable substep.
        Float4& deltaPosition = work.deltaPosition[slot];
        scaleAbout(step.dt * account.middle, account.part, deltaPosition);
        deltaPosition.z *= account.part;
        deltaPosition.w *= account.part;
    }
}

/// Lists the bodies of islands with an account. Clears the shares of bodies in islands without joints.
void findBooked(StepContext& step) {
    World& world = step.world;
    Workspace& work = step.work;
    std::vector<EnergyShare>& shares = world.bodies.energies;
    const bool hasJoints = !world.joints.awake.empty();
    if (hasJoints) shares.resize(world.bodies.size());
    const std::size_t rotating = slotsWithRotation(work);
    collectIf(step, world.awake.size(), work.bookedBodies, [&](std::size_t i) {
        const std::uint32_t body = world.awake[i];
        const bool rotates = static_cast<std::size_t>(work.slots[body]) < rotating;
        const EnergyAccount* account = rotates ? &work.accounts[work.roots[body]] : nullptr;
        // The energy that contacts add to a driven island is not limited.
        const bool isBooked =
            account != nullptr && account->isOpen && (account->isJointed || !account->isDriven);
        if (hasJoints && !(isBooked && account->isJointed)) shares[body] = {};
        return isBooked;
    });
    for (std::uint32_t& booked : work.bookedBodies) booked = world.awake[booked];
}

/// Computes the sums of the accounts, in the order of bodies. Threads only compute the summands.
void bookAll(StepContext& step) {
    Workspace& work = step.work;
    const auto all = work.bookedBodies.size();
    work.bookings.resize(step.isShared(static_cast<int>(all), kEnergyGrain) ? all : 0);
    forEach(step.pool, work.bookings.size(), kEnergyGrain,
            [&](std::size_t i) { work.bookings[i] = sumsOf(step.world, work, work.bookedBodies[i]); });
    for (std::size_t i = 0; i < all; ++i) {
        const std::uint32_t body = work.bookedBodies[i];
        EnergyAccount& account = work.accounts[work.roots[body]];
        const EnergySums sums = work.bookings.empty() ? sumsOf(step.world, work, body) : work.bookings[i];
        add(sums, account.isJointed ? step.world.bodies.energies[body] : EnergyShare{}, account);
    }
}

bool exceeds(const EnergyAccount& account) { return account.excess > 0.0f || account.part < 1.0f; }

/// Computes the factors of islands with excess energy.
void limit(World& world, Workspace& work) {
    for (const std::uint32_t root : work.openAccounts) {
        EnergyAccount& account = work.accounts[root];
        if (account.isDriven || !account.isLively) account.excess = 0.0f;
        if (!account.isRooted) account.middle = (1.0f / account.mass) * account.momentum;
    }
    for (const std::uint32_t body : work.bookedBodies) {
        EnergyAccount& account = work.accounts[work.roots[body]];
        if (exceeds(account)) bookOwn(world, work, body, account);
    }
    for (const std::uint32_t root : work.openAccounts) {
        if (exceeds(work.accounts[root])) findParts(work.accounts[root]);
    }
}

}  // namespace

// Energy guard. Real joints do no work and contacts only dissipate, but the iterative solver adds energy if
// substeps are too long for fast or squeezed bodies. So each island with joints has an account: energy gained
// without a force is removed by scaling all velocities, except energy lost shortly before. An island without
// joints has an account only in steps in which a body gained energy.
// Source: the "energy tanks" of passive control, e.g. B. Hannaford and J.-H. Ryu, "Time-Domain
// Passivity Control of Haptic Interfaces", IEEE Transactions on Robotics and Automation 18, 2002.
void keepEnergy(StepContext& step) {
    World& world = step.world;
    Workspace& work = step.work;
    const bool hasJoints = !world.joints.awake.empty();
    findGainers(step);
    if (!hasJoints && work.gainers.empty()) return;
    findRoots(step);
    openAccounts(world, work);
    if (hasJoints) noteJoints(step);
    // Without joints and drivers, contacts must be visited only if an island has too much energy.
    const bool asksFirst = hasJoints || hasDrivers(step);
    if (asksFirst) noteHolders(step);
    noteSoft(step);
    findBooked(step);
    bookAll(step);
    bool wild = false, tooMuch = false, far = false;
    for (const std::uint32_t root : work.openAccounts) {
        EnergyAccount& account = work.accounts[root];
        account.isJointed ? settleJoints(account, world.settings.pushSpeed, step.dt)
                          : settleContacts(account);
        wild |= account.isWild;
        tooMuch |= exceeds(account);
        far |= account.part < 1.0f;
    }
    if (far) allowClosing(step);
    if (tooMuch) {
        if (!asksFirst) noteHolders(step);
        noteBounces(step);
        limit(world, work);
    }
    if (hasJoints || tooMuch) {
        forEach(step.pool, work.bookedBodies.size(), kEnergyGrain, [&](std::size_t i) {
            share(step, work.bookedBodies[i], work.accounts[work.roots[work.bookedBodies[i]]]);
        });
    }
    if (wild) {
        forgetImpulses(step,
                       [&](std::uint32_t a, std::uint32_t b) { return accountOf(world, work, a, b).isWild; });
    }
    for (const std::uint32_t root : work.openAccounts) work.accounts[root].isOpen = false;
    work.openAccounts.clear();
}

}  // namespace plumb::physics
