#pragma once

#include <cstdint>
#include <span>

#include "physics/world.hpp"

namespace plumb::physics {

/// What something drawn stands for; a canvas gives each a colour.
enum class DebugRole : std::uint8_t {
    Fixed,       ///< a shape of a static body
    Driven,      ///< of a kinematic one
    Awake,       ///< of a dynamic one that is awake
    Asleep,      ///< that rests
    Soft,        ///< a rope, cloth or jelly
    Trigger,     ///< a shape that stops nobody
    Visitor,     ///< from a trigger to who is in it
    Bounds,      ///< the box around a shape
    BroadPhase,  ///< the larger box that the broad phase keeps
    Region,      ///< a node or cell that it sorts boxes into
    Contact,     ///< a point where two shapes touch
    Normal,      ///< the direction of a contact
    Impulse,     ///< how hard it pushes
    Friction,    ///< how hard it holds along the surface
    Joint,
    JointLimit,
    JointForce,
    Velocity,
    Path,    ///< where a body would go if nothing got in its way
    Centre,  ///< a centre of mass
    Island,  ///< who rests or moves together
    Rest,    ///< how near to sleep
    Sweep,   ///< the way of a fast body through the step
    Impact,  ///< where something stopped it
    Field,
    Count
};

/// What a stroke is drawn for. A role alone will do where one is wanted.
struct DebugInk {
    DebugRole role;
    std::uint32_t island = 0;  ///< of the role Island: equal numbers belong together

    // NOLINTNEXTLINE(google-explicit-constructor): a role is an ink
    constexpr DebugInk(DebugRole which, std::uint32_t number = 0) : role{which}, island{number} {}
};

/// Something to draw on. Lengths are metres, places are seen from the origin given to debugDraw().
class DebugCanvas {
public:
    virtual ~DebugCanvas() = default;
    virtual void line(Vec2 from, Vec2 to, DebugInk ink) = 0;
    virtual void circle(Vec2 centre, float radius, DebugInk ink) = 0;
    virtual void polygon(std::span<const Vec2> corners, DebugInk ink) = 0;
    virtual void arrow(Vec2 from, Vec2 to, DebugInk ink) = 0;
    /// An upright box: a polygon, unless a canvas has something faster.
    virtual void box(const AABB& box, DebugInk ink);
};

/// What to draw; bits.
enum DebugPart : std::uint32_t {
    kDrawShapes = 1 << 0,       ///< outlines, soft bodies, which way one-way shapes let through
    kDrawTriggers = 1 << 1,     ///< outlines, and lines to who is inside
    kDrawContacts = 1 << 2,     ///< a circle at each point, of sleeping bodies too
    kDrawNormals = 1 << 3,      ///< an arrow at each point, towards the second body
    kDrawImpulses = 1 << 4,     ///< an arrow at each point that pushed in the last substep, by how hard
    kDrawFriction = 1 << 5,     ///< an arrow at each contact that held along the surface
    kDrawJoints = 1 << 6,       ///< arms, limits, and a circle at each joint's point on B
    kDrawJointForces = 1 << 7,  ///< an arrow there, by how hard it pulls
    kDrawVelocities = 1 << 8,
    kDrawCentres = 1 << 9,
    kDrawIslands = 1 << 10,  ///< the shapes of dynamic bodies again, with the number of their island
    kDrawRest = 1 << 11,     ///< the same, as small as they are wide awake; full while they sleep
    kDrawSweeps = 1 << 12,   ///< ways of fast bodies in the last step, and where they were stopped
    kDrawFields = 1 << 13,   ///< their regions and directions
    kDrawBounds = 1 << 14,
    kDrawBroadPhase = 1 << 15,  ///< enlarged bounds, and the tree or grid they are in
    kDrawPaths = 1 << 16,       ///< the next second of what moves, if nothing got in its way
    kDrawAll = (1 << 17) - 1
};

/// What is drawn of a world.
struct DebugChoice {
    std::uint32_t parts = kDrawAll;  ///< bits of DebugPart
    Place origin;  ///< m: drawn places are seen from here, so that they stay exact far from the world's
    const AABB* sight = nullptr;  ///< m, from the origin: shapes outside are left out; null: none is
    float least = 0.0f;           ///< m: of what is smaller than this the box around it will do
    float behind = 0.0f;  ///< s: bodies that move are drawn as they were so long ago, between two steps
    const Workspace* lastStep = nullptr;  ///< see lastStepOf(); without it no ways and regions are drawn
    bool chosenOnly = false;  ///< what follows says who is drawn; what ties two bodies is drawn with either
    std::span<const std::uint8_t> bodies = {};      ///< by BodyId::index: nonzero for those; may be short
    std::span<const std::uint8_t> fields = {};      ///< by FieldId::index
    std::span<const std::uint8_t> softBodies = {};  ///< by SoftBodyId::index
};

/// What the last step of a world left behind, or null when that was not of this world: it was copied or
/// loaded.
[[nodiscard]] const Workspace* lastStepOf(World& world);

/// Draws a world as it is now, in the order of its numbers. Changes nothing, allocates nothing.
void debugDraw(const World& world, DebugCanvas& canvas, const DebugChoice& choice);

}  // namespace plumb::physics
