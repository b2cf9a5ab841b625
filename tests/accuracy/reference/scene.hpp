#pragma once

#include <cstdint>
#include <vector>

#include "core/result.hpp"
#include "physics/world.hpp"
#include "tests/accuracy/reference/algebra.hpp"

namespace plumb::reference {

inline constexpr std::uint32_t kNoGroup = physics::kNone;

/// A body as the reference solver sees it. Constant during a run.
struct Body {
    physics::BodyId id;
    bool isPushed = false;  ///< dynamic; all others keep their initial velocity
    Triple mass;            ///< kg, kg, kg m2
    Triple inverseMass;     ///< 0 in locked directions
    Point acceleration;     ///< m/s2: of gravity and its own
    double linearDrag = 0.0;
    double angularDrag = 0.0;
    double reach = 0.0;  ///< m: maximum distance of its points from the centre of mass
};

/// A convex outline: one corner (a circle), two (a capsule, a segment) or more, enlarged by a radius.
struct Outline {
    std::uint32_t body = 0;
    std::uint32_t shape = 0;     ///< in World::shapes
    std::vector<Point> corners;  ///< m, from the centre of mass, in the body's frame, counter-clockwise
    std::vector<Point>
        normals;           ///< outward, of the side from each corner to the next; of two corners both sides
    double radius = 0.0;   ///< m
    double width = 0.0;    ///< m: a shape that passes through it overlaps it for at least this distance
    bool isChain = false;  ///< solid on the side of normals[0] only
    Point before, after;   ///< of a chain: directions of the neighbours' normals, or its own
    double friction = 0.0;
    double bounciness = 0.0;
    double surfaceSpeed = 0.0;  ///< m/s
};

/// A scalar function of two bodies that a law holds, drives or limits.
enum class MeasureKind : std::uint8_t { AnchorX, AnchorY, Angle, Across, Along, Length, Pulley };

struct Measure {
    MeasureKind kind = MeasureKind::AnchorX;
    Point anchorA, anchorB;  ///< m, from the centres of mass, in the bodies' frames
    Point axis{1.0, 0.0};    ///< in A's frame, or in the world for anchors
    Point groundA, groundB;  ///< m, of a pulley
    double ratio = 1.0;
    double rest = 0.0;  ///< subtracted from the value
};

/// What is done with a measured value.
enum class LawKind : std::uint8_t { Hold, AtLeast, Drive, Spring };

struct Law {
    LawKind kind = LawKind::Hold;
    std::uint32_t joint = 0;  ///< in World::joints
    std::uint32_t a = 0, b = 0;
    Measure measure;
    double sign = 1.0;                       ///< of AtLeast: -1 for an upper limit
    double speed = 0.0;                      ///< of Drive, m/s or rad/s
    double most = kEndless;                  ///< of Drive and Spring: N or N m
    double hertz = 0.0, dampingRatio = 0.0;  ///< of Spring
    bool isPoint = false;  ///< of Spring: one of a pair that hold a point, along x; the next law is the other
};

/// A world in the solver's terms, with its initial state.
struct Scene {
    std::vector<Body> bodies;  ///< same indices as World::bodies; unused ones have no id
    std::vector<Outline> outlines;
    std::vector<Law> laws;
    std::vector<Triple> poses;             ///< from `origin`
    std::vector<Triple> velocities;        ///< m/s, rad/s
    physics::WorldPosition origin;         ///< m: far from 0 a double is not accurate enough
    double bounceSpeed = 1.0;              ///< m/s
    std::vector<physics::Filter> filters;  ///< by outline
    std::vector<std::uint64_t> apart;      ///< pairs of bodies that joints keep from colliding, sorted
};

/// Converts a world.
/// @error a feature that the reference solver does not support, by name
Result<Scene> makeScene(const physics::World& world);

/// The laws of the joints of a world: joint_laws.cpp.
Result<std::vector<Law>> lawsOf(const physics::World& world);

/// True if two outlines may touch.
bool mayCollide(const Scene& scene, std::uint32_t a, std::uint32_t b);

}  // namespace plumb::reference
