#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/world.hpp"

namespace plumb::physics {

struct StepContext;

// Bodies as soft bodies meet them. Soft bodies move before the solver does and in substeps of their own, so
// the bodies near them are foreseen: each goes on from where it is, under gravity, stopped by what it stands
// on. It gives way to every push at once, and the solver is told the sum. Source for the pushes: M. Mueller
// et al., "Detailed Rigid Body Simulation with Extended Position Based Dynamics", SCA 2020, 3.2 to 3.5.

/// A body near a soft body, as foreseen in the substeps of one group.
struct SoftObstacle {
    std::uint32_t body = 0;
    float inverseInertia = 0.0f;  ///< 1/(kg m2); 0 for what cannot be turned
    Vec2 inverseMass;             ///< 1/kg along x and y; 0 where it is locked or cannot be pushed
    Place centre;                 ///< m
    Rot rotation;
    Vec2 localCentre;        ///< m, as BodyPose
    Vec2 velocity;           ///< m/s
    float spin = 0.0f;       ///< rad/s
    Vec2 acceleration;       ///< m/s2, of gravity and its owner
    Vec2 moved;              ///< m, in this substep
    float turned = 0.0f;     ///< rad, in this substep
    Vec2 gained;             ///< m/s, from soft bodies in this step
    float spun = 0.0f;       ///< rad/s
    Vec2 early;              ///< m/s: the sum of each gain times the part of the step that was left
    float earlySpun = 0.0f;  ///< rad/s
    bool rests = false;      ///< it is asleep

    /// m: how far the point at an arm from its centre came in this substep.
    [[nodiscard]] Vec2 way(Vec2 arm) const { return moved + cross(turned, arm); }
    /// 1/kg against a push along a direction.
    [[nodiscard]] float weight(Vec2 arm, Vec2 direction) const {
        const float lever = cross(arm, direction);
        return inverseMass.x * direction.x * direction.x + inverseMass.y * direction.y * direction.y +
               inverseInertia * lever * lever;
    }
};

/// Where an obstacle touches another one, or what cannot be pushed.
struct SoftSupport {
    std::uint32_t a = 0;  ///< in the list of obstacles
    std::uint32_t b = 0;
    Vec2 normal;   ///< from a to b
    Vec2 armA[2];  ///< m
    Vec2 armB[2];
    float gap[2] = {};  ///< m
    std::uint32_t points = 0;
    float friction = 0.0f;
    float surfaceSpeed = 0.0f;  ///< m/s, as Contact
};

/// What soft bodies push a body with all step long.
struct SoftPush {
    std::uint32_t body = 0;
    Vec2 acceleration;    ///< m/s2
    float spinUp = 0.0f;  ///< rad/s2
};

/// A soft body that comes near a body that can be pushed.
struct SoftNeighbour {
    std::uint32_t body = 0;
    std::uint32_t soft = 0;  ///< in SoftBodies::all
};

/// Of a step, in Workspace.
struct SoftSurroundings {
    std::vector<std::uint32_t> shapes;      ///< near soft bodies, one soft body after the other
    std::vector<std::uint32_t> ends;        ///< by soft body: where its shapes end
    std::vector<SoftNeighbour> neighbours;  ///< by body, rising
    std::vector<std::uint32_t> contacts;    ///< of bodies among them
    std::vector<std::uint8_t> isNear;       ///< by body: 1 for neighbours while contacts are looked for
    std::vector<SoftObstacle> obstacles;    ///< of one group, by body, rising
    std::vector<SoftSupport> supports;      ///< of one group
    std::vector<SoftPush> pushes;

    [[nodiscard]] std::span<const std::uint32_t> shapesOf(std::uint32_t soft) const {
        const std::uint32_t begin = soft > 0 ? ends[soft - 1] : 0;
        return std::span{shapes}.subspan(begin, ends[soft] - begin);
    }
    SoftObstacle& obstacleOf(std::uint32_t body);
};

/// Finds the shapes near all soft bodies, and who shares a body with whom.
void findSurroundings(StepContext& step);
/// The obstacles of a group and what holds them.
void foresee(StepContext& step, std::span<const std::uint32_t> group);
/// Takes the obstacles on by a substep of h seconds.
void moveObstacles(SoftSurroundings& around, float h);
/// @param push  kg m: an impulse times the substep of h seconds
/// @param left  ratio of the step that is left in the middle of this substep
void pushObstacle(SoftObstacle& obstacle, Vec2 arm, Vec2 push, float h, float left);
/// Stops obstacles that move into what they touch.
void holdObstacles(SoftSurroundings& around, float h);
/// Wakes one that rests.
void rouse(const StepContext& step, SoftObstacle& obstacle);
/// Gives the bodies of a group what pushed them.
void pushBodies(StepContext& step);

}  // namespace plumb::physics
