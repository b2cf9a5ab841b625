#pragma once

#include <cstdint>

#include "physics/broadphase/broad_phase.hpp"
#include "physics/model/body.hpp"

namespace plumb::physics {

enum class IntegratorKind : std::uint8_t { ExplicitEuler, SemiImplicitEuler, Verlet, Rk4, Count };

/// All tolerances of the simulation, a part of the world. The next step clamps them: see bringIntoRange().
struct Settings {
    Vec2 gravity{0.0f, 10.0f};  ///< m/s2

    IntegratorKind integrator = IntegratorKind::SemiImplicitEuler;
    /// The algorithm that finds overlapping bounds. It changes only the time a step takes, not its result,
    /// and may change between any two steps; README.md says which is fastest when. Invalid: Tree.
    BroadPhaseKind broadPhase = BroadPhaseKind::Tree;
    /// 2^quality substeps: each further level costs 1.3 to 2 times the time and makes errors 3 to 4 times
    /// smaller. With a tolerance, the level at which islands begin.
    Quality quality = 2;
    /// Velocity iterations per substep, 1 to 64. A higher quality nearly always uses the time better:
    /// README.md.
    std::uint8_t iterations = 1;
    /// Islands that are hard to solve (mass ratios, high stacks, long chains) get more substeps.
    bool automaticQuality = false;
    /// m: maximum overlap of bodies and maximum error of joints. Each island uses the lowest quality that
    /// keeps to it, if there is one; it begins with the estimate of automaticQuality. 0: off, the quality of
    /// an island is fixed. A value below a few times the sag of one crate (0.5 mm at quality 0) costs time in
    /// every scene.
    float tolerance = 0.0f;
    /// Solves joints that form trees (chains, pendulums, bridges) all at once, by a direct method. They then
    /// hold at any mass ratio, and neither gain nor lose energy. Contacts between their bodies are solved
    /// apart: links that touch each other are pressed apart under a load of some hundred times their mass.
    bool directJoints = true;

    /// Frequency of the contact springs, as a fraction s of the substep rate 1/h. A load F presses a contact
    /// of effective mass m in by F h^2 / (m (2 pi s)^2), so stacks and piles hold the better the larger it
    /// is. A spring sampled in steps of h grows from (2 pi s)^2 = 4, s = 0.32, on; among equal bodies from 2,
    /// s = 0.225: pyramids of 12 rows and more sway by 1 to 5 mm until they sleep, and not at all with 0.22.
    float contactStiffness = 0.27f;
    float jointStiffness = 0.25f;  ///< the same for joints
    /// Far above 1: overlaps end without a bounce. Above 5 pyramids sway, below 4 mass ratios of 1000
    /// collapse.
    float contactDampingRatio = 4.0f;
    float jointDampingRatio = 2.0f;
    /// m/s: maximum speed at which overlapping bodies are separated; deepPushRate (1/s) adds to it for each
    /// metre of overlap. Larger values make deep overlaps explode; without deepPushRate the bodies of a crowd
    /// in too small a box sink into each other, because a deeper overlap is not corrected faster.
    float pushSpeed = 3.0f;
    float deepPushRate = 6.0f;
    /// m: overlap that is not corrected, so that resting contacts do not begin and end all the time.
    float slop = 0.005f;
    /// m: shapes closer than this have contact points before they touch.
    float speculativeDistance = 0.02f;
    /// m: touching bodies keep their contact points and normals until they have slid along each other by this
    /// much (or by a tenth of the smaller body's half size, if that is less). A smaller value computes points
    /// more often, which costs time and lets card houses fall; a larger one adds energy to rocking bodies.
    float recycleDistance = 0.01f;
    /// m: bounds are enlarged by this much, at most an eighth of the shape's size, so that few movements
    /// leave them. A larger value gives fewer searches and more pairs.
    float boundsMargin = 0.05f;
    float bounceSpeed = 1.0f;  ///< m/s: minimum approach speed for a bounce
    float sleepTime = 0.5f;    ///< s: an island that has been at rest for this long falls asleep
    float maxSpeed = 4000.0f;  ///< m/s: faster bodies are slowed down to it
    /// Continuous collision detection: fast bodies are swept and do not tunnel through static ones.
    bool continuous = true;
    bool sleeping = true;
    bool stayEvents = false;  ///< contacts that continue produce a Stayed event in each step
};

/// Clamps each value to its range; a NaN becomes the default.
void bringIntoRange(Settings& settings);

}  // namespace plumb::physics
