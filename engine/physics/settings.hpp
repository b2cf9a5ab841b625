#pragma once

#include <cstdint>

#include "physics/body.hpp"
#include "physics/broadphase/broad_phase.hpp"

namespace plumb::physics {

/// How velocities and positions are made from each other and from forces.
enum class IntegratorKind : std::uint8_t { ExplicitEuler, SemiImplicitEuler, Verlet, Rk4, Count };

/// Every tolerance of the simulation. Part of the world and its snapshot. Numbers that make no sense are
/// brought into their range by the next step: see bringIntoRange().
struct Settings {
    Vec2 gravity{0.0f, 10.0f};  ///< m/s2

    IntegratorKind integrator = IntegratorKind::SemiImplicitEuler;
    /// Who finds which bounds overlap. Nothing but time depends on it, and it may change between any two
    /// steps; README.md says which is fastest where. A value that is none of them is Tree.
    BroadPhaseKind broadPhase = BroadPhaseKind::Tree;
    /// 2^quality substeps: each more costs 1.3 to 2 times the time and makes errors 3 to 4 times smaller.
    /// With a tolerance, where islands begin.
    Quality quality = 2;
    /// Velocity iterations of a substep, 1 to 64. Quality is nearly always the better buy: README.md.
    std::uint8_t iterations = 1;
    /// Islands in hard positions (mass ratios, high stacks, long chains) get more substeps by themselves: a
    /// guess from what they are made of.
    bool automaticQuality = false;
    /// m: the most that bodies may overlap and joints may be apart. Each island takes the lowest quality that
    /// keeps to it, as far as quality helps; it begins with the guess. 0: none, islands have their fixed
    /// quality. Smaller than a few times the sag of one crate (0.5 mm at quality 0) is not free for anybody.
    float tolerance = 0.0f;
    /// Chains, pendulums, bridges: joints that make up trees are solved all at once. They hold whatever the
    /// mass ratio, and neither gain nor lose energy.
    bool directJoints = true;

    /// Contacts are springs of this part of the substep rate. Above 0.2 pyramids and card houses may fall.
    float contactStiffness = 0.18f;
    float jointStiffness = 0.25f;  ///< the same of joints
    /// Much above 1: overlaps go away without a bounce. Above 5 pyramids sway, below 4 mass ratios of 1000
    /// fall.
    float contactDampingRatio = 4.0f;
    float jointDampingRatio = 2.0f;
    /// m/s: how fast overlapping bodies are pushed apart at most, and by how much faster for each metre of
    /// overlap (1/s). Larger explodes deep overlaps; without the second a crowd in too small a box sinks into
    /// each other, since who is deeper is not pushed harder.
    float pushSpeed = 3.0f;
    float deepPushRate = 6.0f;
    /// m: overlap that is left alone, so that contacts of resting things do not come and go.
    float slop = 0.005f;
    /// m: nearer than this two shapes have a contact, though they do not touch yet.
    float speculativeDistance = 0.02f;
    /// m: two touching bodies keep the points where they touch, and the directions in which they push, until
    /// they have moved by this (or a tenth of the smaller one's half size) along each other. Smaller finds
    /// points anew more often, which costs time and lets card houses fall; larger feeds what rocks.
    float recycleDistance = 0.01f;
    /// m: bounds are this much larger than shapes, so that few movements leave them; at most an eighth
    /// of a shape's size. Larger: fewer searches, more pairs.
    float boundsMargin = 0.05f;
    float bounceSpeed = 1.0f;  ///< m/s: slower than this nothing bounces
    float sleepTime = 0.5f;    ///< s: at rest for so long an island falls asleep
    float maxSpeed = 4000.0f;  ///< m/s: faster is slowed down to it
    /// Fast bodies are swept, so that they do not pass through what does not move.
    bool continuous = true;
    bool sleeping = true;
    bool stayEvents = false;  ///< a contact that goes on is an event in each step
};

/// What is below 0 or absurdly large becomes the nearest that is not, and what is no number the default.
void bringIntoRange(Settings& settings);

}  // namespace plumb::physics
