#include <algorithm>
#include <cmath>

#include "physics/joints/joint_types.hpp"
#include "physics/sleeping.hpp"
#include "physics/solver/hardness.hpp"
#include "physics/solver/joint_lanes.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

/// s: for so long energy that went somewhere (into joints that gave way, a blow) may come back. A taut bridge
/// takes a quarter of a second to throw what fell on it.
constexpr float kMemory = 2.0f;
/// s: for so long the most that a group moved at counts as what rounding is measured by.
constexpr float kPeakMemory = 4.0f;
/// Of that peak, joints may add this part in all.
constexpr float kMostGain = 0.005f;
/// Ratio to Settings::pushSpeed: who is no faster is let be. What hangs too low, in joints that gave way, is
/// lifted at such speeds.
constexpr float kCreeping = 0.1f;
/// Who has so many times the energy that it had, or that it has at ten times the speed at which joints close,
/// is not slowed down but stopped: its places are wrong as well.
constexpr float kWild = 100.0f;
constexpr float kWildPush = kWild * kJointPushing * kJointPushing;

bool isPushed(const World& world, std::uint32_t body) {
    return world.bodies.info[body].kind == BodyKind::Dynamic;
}

bool moves(const World& world, std::uint32_t body) {
    const BodyMotion& motion = world.bodies.motion[body];
    return !isPushed(world, body) && (motion.velocity != Vec2{} || motion.angularVelocity != 0.0f);
}

/// True for joints that store energy or give some.
bool isPowered(const Joint& joint) {
    return (joint.flags & (kDriven | kSprung | kSoft)) != 0 || joint.kind == JointKind::Mouse ||
           joint.kind == JointKind::Motor;
}

EnergyAccount& accountOf(World& world, Workspace& work, std::uint32_t a, std::uint32_t b) {
    return work.accounts[rootOf(world, isPushed(world, b) ? b : a)];
}

/// The roots of all awake bodies that can be pushed, and an account for each island with joints.
void openAccounts(World& world, Workspace& work) {
    work.accounts.resize(world.bodies.size());
    work.roots.resize(world.awake.size());
    for (std::size_t i = 0; i < world.awake.size(); ++i) {
        const std::uint32_t body = world.awake[i];
        work.roots[i] = isPushed(world, body) ? islandOf(world, body) : kNone;
        work.accounts[body].isOpen = false;
    }
    for (std::size_t i = 0; i < world.awake.size(); ++i) {
        if (work.roots[i] == kNone || world.bodies.info[world.awake[i]].firstJoint == kNone) continue;
        EnergyAccount& account = work.accounts[work.roots[i]];
        if (!account.isOpen) account = {.isOpen = true};
    }
}

/// Few joints are powered or hold to what cannot be pushed: only for these is the island looked up.
void noteJoints(World& world, Workspace& work) {
    for (const std::uint32_t j : world.joints.awake) {
        const Joint& joint = world.joints.hot[j];
        const bool powered = isPowered(joint), between = joint.colour < kFirstFixedColour;
        if (!powered && between) continue;
        EnergyAccount& account = accountOf(world, work, joint.bodyA, joint.bodyB);
        account.isDriven |= powered || moves(world, joint.bodyA) || moves(world, joint.bodyB);
        account.isRooted |= !isPushed(world, joint.bodyA) || !isPushed(world, joint.bodyB);
    }
}

/// Whoever touches what its owner moves gets energy from there, and momentum from all that cannot be pushed.
void noteHolders(StepContext& step) {
    World& world = step.world;
    const Workspace& work = step.work;
    const bool drivers = step.runs(Effect::Kinematics) || step.runs(Effect::Conveyor);
    for (std::size_t i = 0; i < work.contactKeys.size(); ++i) {
        const std::uint16_t key = work.contactKeys[i];
        if ((key & kKeyColour) == kKeyIdle || (!drivers && (key & kKeyFixed) == 0)) continue;
        const Contact& contact = world.contacts[i];
        EnergyAccount& account = accountOf(world, step.work, contact.bodyA, contact.bodyB);
        account.isRooted |= (key & kKeyFixed) != 0;
        account.isDriven |=
            contact.surfaceSpeed != 0.0f || moves(world, contact.bodyA) || moves(world, contact.bodyB);
    }
}

float energyOf(const BodyMass& mass, Vec2 velocity, float spin) {
    return 0.5f * (mass.mass * lengthSquared(velocity) + mass.inertia * spin * spin);
}

/// What moved the bodies did so much work; the rest of what they gained came from joints and contacts.
void book(const World& world, const Workspace& work, std::uint32_t body, EnergyAccount& account) {
    const auto slot = static_cast<std::size_t>(work.slots[body]);
    const BodyMass& mass = world.bodies.mass[body];
    const BodyMotion& before = world.bodies.motion[body];
    const Float4 &after = work.velocity[slot], &shift = work.shift[slot], &drive = work.drive[slot];
    const float now = energyOf(mass, {after.x, after.y}, after.z);
    const float work1 =
        mass.mass * (drive.x * shift.x + drive.y * shift.y) + mass.inertia * drive.z * shift.z;
    account.energy += now;
    account.gain += now - energyOf(mass, before.velocity, before.angularVelocity) - work1;
    account.momentum += mass.mass * Vec2{after.x, after.y};
    account.mass += mass.mass;
    const EnergyShare& share = world.bodies.energies[body];
    account.credit += share.credit;
    account.peak += share.peak;
}

/// What is left of an island's speeds, so that it has no more energy than it had or was given.
/// @return whether the island has gone wild
bool settle(EnergyAccount& account, float pushSpeed, float dt) {
    const float pushed = 0.5f * account.mass * pushSpeed * pushSpeed;
    account.isWild = !account.isDriven && !(account.energy <= kWild * account.peak + kWildPush * pushed);
    if (account.isWild) return true;
    account.peak = std::max(account.energy, account.peak * std::max(0.0f, 1.0f - dt / kPeakMemory));
    account.credit -= account.gain;
    account.keep = 1.0f;
    const float excess = -kMostGain * account.peak - account.credit;
    if (account.isDriven) {
        account.credit = 0.0f;
    } else if (excess > 0.0f) {
        account.middle = account.isRooted ? Vec2{} : (1.0f / account.mass) * account.momentum;
        const float own = account.energy - 0.5f * account.mass * lengthSquared(account.middle);
        const float least = std::min(own, kCreeping * kCreeping * pushed);
        account.keep = own > least ? std::sqrt(std::max(own - excess, least) / own) : 1.0f;
        account.credit = -kMostGain * account.peak;
    }
    // What a swing takes for half its time and gives back is not forgotten.
    const float kept = kMostGain * account.peak, fading = account.credit - kept;
    if (fading > 0.0f) account.credit = kept + fading * std::max(0.0f, 1.0f - dt / kMemory);
    return false;
}

void slowDown(Float4& velocity, const EnergyAccount& account) {
    velocity.x = account.middle.x + account.keep * (velocity.x - account.middle.x);
    velocity.y = account.middle.y + account.keep * (velocity.y - account.middle.y);
    velocity.z *= account.keep;
}

/// A body of an island that went wild waits for a better step, at the speed that it had.
void hold(const World& world, Workspace& work, std::uint32_t body) {
    const auto slot = static_cast<std::size_t>(work.slots[body]);
    const BodyMotion& motion = world.bodies.motion[body];
    work.velocity[slot] = {motion.velocity.x, motion.velocity.y, motion.angularVelocity,
                           work.velocity[slot].w};
    work.shift[slot] = {};
}

/// Which starts from nothing: it went wild by what was given again.
void forgetImpulses(World& world, Workspace& work) {
    for (const std::uint32_t j : world.joints.awake) {
        Joint& joint = world.joints.hot[j];
        if (!accountOf(world, work, joint.bodyA, joint.bodyB).isWild) continue;
        joint.force = {};
        joint.torque = 0.0f;
        std::fill(std::begin(joint.rows), std::end(joint.rows), 0.0f);
    }
    for (std::size_t i = 0; i < work.contactKeys.size(); ++i) {
        if ((work.contactKeys[i] & kKeyColour) == kKeyIdle) continue;
        Contact& contact = world.contacts[i];
        if (!accountOf(world, work, contact.bodyA, contact.bodyB).isWild) continue;
        contact.impulse0 = contact.impulse1 = contact.frictionImpulse = contact.rollingImpulse = 0.0f;
    }
}

/// Everybody has a share of the island's account by mass, as islands fall apart and others come together.
void share(World& world, Workspace& work, std::uint32_t body, const EnergyAccount& account) {
    if (account.isWild) return hold(world, work, body);
    const float part = world.bodies.mass[body].mass / account.mass;
    world.bodies.energies[body] = {account.credit * part, account.peak * part};
    if (account.keep < 1.0f) slowDown(work.velocity[static_cast<std::size_t>(work.slots[body])], account);
}

}  // namespace

// Joints do no work, and contacts only take energy. Solved by turns, in substeps that may be too long for
// what whips or is squeezed, they seem to do some. So each island with joints has an account: what it gained
// that nobody gave it is taken back, all speeds alike, but for what it lost a moment before. Source: the
// "energy tanks" of passive control, e.g. B. Hannaford and J.-H. Ryu, "Time-Domain Passivity Control of
// Haptic Interfaces", IEEE Transactions on Robotics and Automation 18, 2002.
void keepEnergy(StepContext& step) {
    World& world = step.world;
    Workspace& work = step.work;
    if (world.joints.awake.empty()) return;
    if (world.islandsStale) rebuildIslands(world);
    world.bodies.energies.resize(world.bodies.size());
    openAccounts(world, work);
    noteJoints(world, work);
    noteHolders(step);
    const auto forBodies = [&](auto&& act) {
        for (std::size_t i = 0; i < world.awake.size(); ++i) {
            if (work.roots[i] != kNone) act(world.awake[i], work.accounts[work.roots[i]]);
        }
    };
    forBodies([&](std::uint32_t body, EnergyAccount& account) {
        if (account.isOpen) book(world, work, body, account);
    });
    bool wild = false;
    for (std::size_t i = 0; i < world.awake.size(); ++i) {
        EnergyAccount& account = work.accounts[world.awake[i]];
        if (work.roots[i] == world.awake[i] && account.isOpen)
            wild |= settle(account, world.settings.pushSpeed, step.dt);
    }
    forBodies([&](std::uint32_t body, const EnergyAccount& account) {
        if (account.isOpen) return share(world, work, body, account);
        world.bodies.energies[body] = {};
    });
    if (wild) forgetImpulses(world, work);
}

}  // namespace plumb::physics
