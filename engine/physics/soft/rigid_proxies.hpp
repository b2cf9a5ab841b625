#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/world.hpp"

namespace plumb::physics {

struct StepContext;

// Rigid bodies as obstacles of soft bodies. Soft bodies move before the rigid solver runs, in substeps of
// their own, so the rigid bodies near them are predicted: under gravity, stopped by what they stand on. A
// predicted body responds to each impulse at once, and the rigid solver receives the sum. Source for the
// impulses: M. Mueller et al., "Detailed Rigid Body Simulation with Extended Position Based Dynamics", SCA
// 2020, 3.2 to 3.5.

/// A rigid body near a soft body, as predicted in the substeps of one group.
struct SoftObstacle {
    std::uint32_t body = 0;
    float inverseInertia = 0.0f;  ///< 1/(kg m2); 0 if it cannot rotate
    Vec2 inverseMass;             ///< 1/kg along x and y; 0 if it is locked or not dynamic
    WorldPosition centre;         ///< m
    Rot rotation;
    Vec2 localCentre;        ///< m, as BodyPose
    Vec2 velocity;           ///< m/s
    float spin = 0.0f;       ///< rad/s
    Vec2 acceleration;       ///< m/s2, by gravity and applied forces
    Vec2 moved;              ///< m, in this substep
    float turned = 0.0f;     ///< rad, in this substep
    Vec2 gained;             ///< m/s: change by soft bodies in this step
    float spun = 0.0f;       ///< rad/s: the same of the rotation
    Vec2 early;              ///< m/s: sum of the changes, each times the fraction of the step that was left
    float earlySpun = 0.0f;  ///< rad/s
    bool rests = false;      ///< asleep

    /// m: displacement, in this substep, of the point at an arm from its center.
    [[nodiscard]] Vec2 displacement(Vec2 arm) const { return moved + cross(turned, arm); }
    /// 1/kg: inverse effective mass of that point along a direction.
    [[nodiscard]] float weight(Vec2 arm, Vec2 direction) const {
        const float lever = cross(arm, direction);
        return inverseMass.x * direction.x * direction.x + inverseMass.y * direction.y * direction.y +
               inverseInertia * lever * lever;
    }
};

/// A contact of an obstacle with another one, or with a static or kinematic body.
struct SoftSupport {
    std::uint32_t a = 0;  ///< index in the list of obstacles
    std::uint32_t b = 0;
    Vec2 normal;   ///< from a to b
    Vec2 armA[2];  ///< m
    Vec2 armB[2];
    float gap[2] = {};  ///< m
    std::uint32_t points = 0;
    float friction = 0.0f;
    float surfaceSpeed = 0.0f;  ///< m/s, as Contact
};

/// Acceleration of a body by soft bodies, constant over the step.
struct SoftPush {
    std::uint32_t body = 0;
    Vec2 acceleration;    ///< m/s2
    float spinUp = 0.0f;  ///< rad/s2
};

/// A soft body near a dynamic body.
struct SoftNeighbour {
    std::uint32_t body = 0;
    std::uint32_t soft = 0;  ///< in SoftBodies::all
};

/// Data of a step, in Workspace.
struct SoftSurroundings {
    std::vector<std::uint32_t> shapes;      ///< near soft bodies, in the order of these
    std::vector<std::uint32_t> ends;        ///< by soft body: end of its shapes
    std::vector<SoftNeighbour> neighbours;  ///< sorted by body
    std::vector<std::uint32_t> contacts;    ///< of the bodies in `neighbours`
    std::vector<std::uint8_t> isNear;       ///< by body: 1 for neighbors, while contacts are collected
    std::vector<SoftObstacle> obstacles;    ///< of one group, sorted by body
    std::vector<SoftSupport> supports;      ///< of one group
    std::vector<SoftPush> pushes;

    [[nodiscard]] std::span<const std::uint32_t> shapesOf(std::uint32_t soft) const {
        const std::uint32_t begin = soft > 0 ? ends[soft - 1] : 0;
        return std::span{shapes}.subspan(begin, ends[soft] - begin);
    }
    SoftObstacle& obstacleOf(std::uint32_t body);
};

/// Finds the shapes near all soft bodies, and the soft bodies that share a rigid body.
void findSurroundings(StepContext& step);
/// Sets up the obstacles of a group and their supports.
void foresee(StepContext& step, std::span<const std::uint32_t> group);
/// Advances the obstacles by a substep of h seconds.
void moveObstacles(SoftSurroundings& around, float h);
/// @param push  kg m: an impulse times the substep of h seconds
/// @param left  fraction of the step that is left in the middle of this substep
void pushObstacle(SoftObstacle& obstacle, Vec2 arm, Vec2 push, float h, float left);
/// Stops obstacles that move into what they touch.
void holdObstacles(SoftSurroundings& around, float h);
/// Wakes an obstacle that is asleep.
void rouse(const StepContext& step, SoftObstacle& obstacle);
/// Passes the effect of soft bodies on the obstacles of a group to the rigid solver.
void pushBodies(StepContext& step);

}  // namespace plumb::physics
