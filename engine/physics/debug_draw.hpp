#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

/// Meaning of something drawn; a canvas gives each a color.
enum class DebugRole : std::uint8_t {
    Fixed,       ///< a shape of a static body
    Driven,      ///< of a kinematic body
    Awake,       ///< of an awake dynamic body
    Asleep,      ///< of a sleeping body
    Soft,        ///< a rope, cloth or jelly
    Trigger,     ///< a shape that detects overlaps and does not collide
    Visitor,     ///< from a trigger to what is inside it
    Bounds,      ///< bounds of a shape
    BroadPhase,  ///< enlarged bounds kept by the broad phase
    Region,      ///< a node or cell of the broad phase
    Contact,     ///< a point where two shapes touch
    Normal,      ///< the direction of a contact
    Impulse,     ///< normal impulse
    Friction,    ///< friction impulse
    Joint,
    JointLimit,
    JointForce,
    Velocity,
    Path,    ///< predicted trajectory of a body, without obstacles
    Centre,  ///< a center of mass
    Island,  ///< bodies that move or sleep together
    Rest,    ///< how close a body is to falling asleep
    Sweep,   ///< path of a fast body in the step
    Impact,  ///< where it hit something
    Field,
    Count
};

/// Role of a stroke, and its island. Roles convert to it.
struct DebugInk {
    DebugRole role;
    std::uint32_t island = 0;  ///< for the role Island: equal numbers belong together

    // NOLINTNEXTLINE(google-explicit-constructor): a role is an ink
    constexpr DebugInk(DebugRole which, std::uint32_t number = 0) : role{which}, island{number} {}
};

/// Something to draw on. Lengths are in meters, positions relative to the origin given to debugDraw().
class DebugCanvas {
public:
    virtual ~DebugCanvas() = default;
    virtual void line(Vec2 from, Vec2 to, DebugInk ink) = 0;
    virtual void circle(Vec2 centre, float radius, DebugInk ink) = 0;
    virtual void polygon(std::span<const Vec2> corners, DebugInk ink) = 0;
    virtual void arrow(Vec2 from, Vec2 to, DebugInk ink) = 0;
    /// An axis-aligned box: a polygon, unless a canvas has something faster.
    virtual void box(const AABB& box, DebugInk ink);
};

/// What to draw, bits.
enum DebugPart : std::uint32_t {
    kDrawShapes = 1 << 0,       ///< outlines, soft bodies, open directions of one-way shapes
    kDrawTriggers = 1 << 1,     ///< outlines, and lines to what is inside
    kDrawContacts = 1 << 2,     ///< a circle at each point, of sleeping bodies too
    kDrawNormals = 1 << 3,      ///< an arrow at each point, towards the second body
    kDrawImpulses = 1 << 4,     ///< an arrow at each point, by its impulse in the last substep
    kDrawFriction = 1 << 5,     ///< an arrow at each contact, by its friction
    kDrawJoints = 1 << 6,       ///< arms, limits, and a circle at each joint's anchor on B
    kDrawJointForces = 1 << 7,  ///< an arrow there, by the force
    kDrawVelocities = 1 << 8,
    kDrawCentres = 1 << 9,
    kDrawIslands = 1 << 10,  ///< the shapes of dynamic bodies again, with the number of their island
    kDrawRest = 1 << 11,  ///< the same, scaled by how close they are to sleep; in full size while they sleep
    kDrawSweeps = 1 << 12,  ///< paths of fast bodies in the last step, and where they hit something
    kDrawFields = 1 << 13,  ///< their regions and directions
    kDrawBounds = 1 << 14,
    kDrawBroadPhase = 1 << 15,  ///< enlarged bounds, and the tree or grid they are in
    kDrawPaths = 1 << 16,       ///< predicted trajectories over the next second, without obstacles
    kDrawAll = (1 << 17) - 1
};

struct DebugChoice {
    std::uint32_t parts = kDrawAll;  ///< bits of DebugPart
    WorldPosition origin;            ///< m: what positions are relative to: exact far from the world's origin
    const AABB* sight = nullptr;  ///< m, relative to the origin: shapes outside are left out; null: none is
    float minimum = 0.0f;         ///< m: of smaller shapes only the bounds are drawn
    float behind = 0.0f;          ///< s: moving bodies are drawn as they were so long ago, between two steps
    const Workspace* lastStep = nullptr;  ///< see lastStepOf(); null: no sweeps and no broad phase regions
    bool chosenOnly = false;              ///< only what is selected below, and what connects it to others
    std::span<const std::uint8_t> bodies = {};      ///< by BodyId::index: nonzero if selected; may be shorter
    std::span<const std::uint8_t> fields = {};      ///< by FieldId::index
    std::span<const std::uint8_t> softBodies = {};  ///< by SoftBodyId::index
};

/// Workspace of the last step of a world; null if the world was copied or loaded since.
[[nodiscard]] const Workspace* lastStepOf(const World& world);

/// Draws the current state of a world, in the order of indices. Changes nothing, allocates nothing.
void debugDraw(const World& world, DebugCanvas& canvas, const DebugChoice& choice);

}  // namespace plumb::physics
