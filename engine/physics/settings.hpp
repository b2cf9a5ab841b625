#pragma once

#include <cstdint>

#include "physics/broadphase/broad_phase.hpp"
#include "physics/model/body.hpp"

namespace plumb::physics {

enum class IntegratorKind : std::uint8_t { ExplicitEuler, SemiImplicitEuler, Verlet, Rk4, Count };

/// Settings of the simulation, a part of the world. The next step clamps them by bringIntoRange().
struct Settings {
    Vec2 gravity{0.0f, 10.0f};  ///< m/s2

    IntegratorKind integrator = IntegratorKind::SemiImplicitEuler;
    /// The broad phase algorithm, which affects only the duration of a step, not its result. It may be
    /// changed between steps. README.md compares the algorithms. An invalid value counts as Tree.
    BroadPhaseKind broadPhase = BroadPhaseKind::Tree;
    /// 2^quality substeps: each further level costs 1.3 to 2 times the time and makes errors 3 to 4 times
    /// smaller. If `tolerance` is set: initial quality of islands.
    Quality quality = 2;
    /// Velocity iterations per substep, 1 to 64. A higher quality is nearly always the better use of time.
    std::uint8_t iterations = 1;
    /// Islands that are hard to solve (mass ratios, high stacks, long chains) get more substeps.
    bool automaticQuality = false;
    /// m: maximum overlap of bodies and maximum error of joints. Each island uses the lowest quality whose
    /// errors are smaller, if there is one, and begins with the quality estimated as for automaticQuality. 0:
    /// off. Values up to a few times the overlap of a resting crate (0.5 mm at quality 0) cost much time.
    float tolerance = 0.0f;
    /// Solves joints that form trees (chains, pendulums, bridges) all at once, by a direct method. They then
    /// hold at any mass ratio, and neither gain nor lose energy. Contacts between their bodies are solved
    /// separately: touching links separate under a load of some hundred times their mass.
    bool directJoints = true;

    /// Frequency of the contact springs, as a fraction s of the substep rate 1/h. A load F compresses a
    /// contact of effective mass m by F h^2 / (m (2 pi s)^2), so larger values make stacks more stable. With
    /// steps of h a spring is unstable if (2 pi s)^2 >= 4 (s >= 0.32), between equal bodies if it is >= 2 (s
    /// >= 0.225). So pyramids of 12 rows and more sway by 1 to 5 mm until they sleep; with 0.22 they do not.
    float contactStiffness = 0.27f;
    float jointStiffness = 0.25f;  ///< frequency of joint springs / substep rate
    /// Far above 1, so that bodies do not bounce when overlaps are corrected. Above 5 pyramids sway, below 4
    /// stacks with mass ratios of 1000 collapse.
    float contactDampingRatio = 4.0f;
    float jointDampingRatio = 2.0f;
    /// m/s: maximum speed at which overlapping bodies are separated, and (in rad/s) angles return to limits
    /// that were changed; deepPushRate (1/s) adds to it for each metre of overlap.
    /// Larger values make deep overlaps explode; without deepPushRate the bodies of a crowd in too small a
    /// box sink into each other.
    float pushSpeed = 3.0f;
    float deepPushRate = 6.0f;
    /// m: overlap that is not corrected, so that resting contacts do not repeatedly begin and end.
    float slop = 0.005f;
    /// m: contact points are already computed for shapes that are closer to each other than this.
    float speculativeDistance = 0.02f;
    /// m: touching bodies keep their contact points and normals until they have slid along each other by this
    /// distance (or by a tenth of the smaller body's half size, if that is less). Smaller values compute
    /// points more often, which costs time and makes card houses fall; larger ones make rocking gain energy.
    float recycleDistance = 0.01f;
    /// m: bounds are enlarged by this (at most an eighth of the shape's size), so that shapes seldom leave
    /// them. A larger value gives fewer searches and more pairs.
    float boundsMargin = 0.05f;
    float bounceSpeed = 1.0f;  ///< m/s: minimum approach speed for a bounce
    float sleepTime = 0.5f;    ///< s: an island falls asleep after resting for this time
    float maxSpeed = 4000.0f;  ///< m/s: speed limit of bodies
    /// Continuous collision detection: fast bodies are swept and do not tunnel through static ones.
    bool continuous = true;
    bool sleeping = true;
    bool stayEvents = false;  ///< continuing contacts produce a Stayed event in each step
};

/// Clamps each value to its range; a NaN becomes the default.
void bringIntoRange(Settings& settings);

}  // namespace plumb::physics
