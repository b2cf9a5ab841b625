#pragma once

#include <cstdint>
#include <vector>

#include "core/result.hpp"
#include "physics/world.hpp"
#include "tests/accuracy/reference/algebra.hpp"

namespace plumb::reference {

inline constexpr std::uint32_t kNoGroup = physics::kNone;

/// Data of a body that is constant during a run of the reference solver.
struct Body {
    physics::BodyId id;
    bool isPushed = false;     ///< true: dynamic; all other bodies keep their initial velocity
    Triple mass;               ///< mass, mass, moment of inertia (kg, kg, kg m2)
    Triple inverseMass;        ///< inverse of `mass`; 0 in locked directions
    Point acceleration;        ///< acceleration by gravity plus the body's own constant acceleration, m/s2
    double linearDrag = 0.0;   ///< 1/s
    double angularDrag = 0.0;  ///< 1/s
    double reach = 0.0;        ///< maximum distance of a point of the body from the centre of mass, m
};

/// A convex outline with 1 corner (circle), 2 corners (capsule, segment) or more, enlarged by a radius.
struct Outline {
    std::uint32_t body = 0;      ///< index in Scene::bodies
    std::uint32_t shape = 0;     ///< index in World::shapes
    std::vector<Point> corners;  ///< m, in the body's frame from the centre of mass, counter-clockwise
    std::vector<Point> normals;  ///< outward normal of the side from each corner to the next
    double radius = 0.0;         ///< rounding radius, m
    double width = 0.0;          ///< minimum distance of two parallel lines that enclose it, m
    bool isChain = false;        ///< true: solid on the side of normals[0] only
    Point before, after;  ///< chains: normals of the neighbour segments; at an end its direction outward
    double friction = 0.0;
    double bounciness = 0.0;
    double surfaceSpeed = 0.0;  ///< conveyor speed, m/s
};

/// Quantity that a law constrains; all but Angle and Pulley: a part of the vector from A's anchor to B's.
enum class MeasureKind : std::uint8_t { AnchorX, AnchorY, Angle, Across, Along, Length, Pulley };

struct Measure {
    MeasureKind kind = MeasureKind::AnchorX;
    Point anchorA, anchorB;  ///< anchors in the bodies' frames, from the centres of mass, m
    Point axis{1.0, 0.0};    ///< axis in A's frame; for AnchorX and AnchorY in world coordinates
    Point groundA, groundB;  ///< for Pulley: positions of the wheels, m
    double ratio = 1.0;      ///< for Pulley: factor of B's rope length
    double rest = 0.0;       ///< reference value, subtracted from the measured value
};

/// Constraint on a Measure: equal to its `rest`, at least (or most) `rest`, motor, or spring.
enum class ConstraintKind : std::uint8_t { Hold, AtLeast, Drive, Spring };

struct Law {  ///< one scalar constraint of a joint
    ConstraintKind kind = ConstraintKind::Hold;
    std::uint32_t joint = 0;     ///< index in World::joints
    std::uint32_t a = 0, b = 0;  ///< bodies: indices in Scene::bodies
    Measure measure;
    double sign = 1.0;                       ///< for AtLeast: 1 for a lower limit, -1 for an upper limit
    double speed = 0.0;                      ///< for Drive: target speed, m/s or rad/s
    double most = kEndless;                  ///< for Drive and Spring: maximum force, N or N m
    double hertz = 0.0, dampingRatio = 0.0;  ///< for Spring: natural frequency (Hz), damping ratio
    bool isPoint = false;  ///< for Spring: x part of a pair that holds a point; the next law is the y part
};

/// A scene in the form used by the reference solver, with its initial state.
struct Scene {
    std::vector<Body> bodies;  ///< same indices as World::bodies; free slots have no id
    std::vector<Outline> outlines;
    std::vector<Law> laws;
    std::vector<Triple> poses;       ///< poses relative to `origin`, m, rad
    std::vector<Triple> velocities;  ///< m/s, rad/s
    physics::WorldPosition origin;   ///< world position of the coordinate origin, m; keeps coordinates small
    double bounceSpeed = 1.0;        ///< Settings::bounceSpeed, m/s
    std::vector<physics::Filter> filters;  ///< collision filter of each outline
    std::vector<std::uint64_t> apart;      ///< pairs of bodies whose joints disable collisions, sorted
};

/// Converts a physics world.
/// @error names a feature that the reference solver does not support
Result<Scene> makeScene(const physics::World& world);

/// Converts the joints of a world into laws (joint_laws.cpp). @error as makeScene()
Result<std::vector<Law>> lawsOf(const physics::World& world);

/// True if filters and joints allow two outlines to collide.
bool mayCollide(const Scene& scene, std::uint32_t a, std::uint32_t b);

}  // namespace plumb::reference
