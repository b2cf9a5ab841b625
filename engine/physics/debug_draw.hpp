#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

/// Meaning of a drawn element; a canvas assigns a color to each role.
enum class DebugRole : std::uint8_t {
    Fixed,       ///< a shape of a static body
    Driven,      ///< a shape of a kinematic body
    Awake,       ///< a shape of an awake dynamic body
    Asleep,      ///< a shape of a sleeping body
    Soft,        ///< a rope, cloth or jelly
    Trigger,     ///< a shape that detects overlaps and does not collide
    Visitor,     ///< a line from a trigger to a shape inside it
    Bounds,      ///< bounding box of a shape
    BroadPhase,  ///< bounding box in the broad phase, enlarged by the margin
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
    Impact,  ///< position at which a fast body hit a shape
    Field,
    Count
};

/// How a line or outline is drawn: its role and its island. A DebugRole converts to a DebugInk.
struct DebugInk {
    DebugRole role;
    std::uint32_t island = 0;  ///< for the role Island: the same number for all shapes of an island

    // NOLINTNEXTLINE(google-explicit-constructor): a role converts to an ink
    constexpr DebugInk(DebugRole which, std::uint32_t number = 0) : role{which}, island{number} {}
};

/// The target of debugDraw(). Lengths are in meters, positions relative to DebugOptions::origin.
class DebugCanvas {
public:
    virtual ~DebugCanvas() = default;
    virtual void line(Vec2 from, Vec2 to, DebugInk ink) = 0;
    virtual void circle(Vec2 centre, float radius, DebugInk ink) = 0;
    virtual void polygon(std::span<const Vec2> corners, DebugInk ink) = 0;
    virtual void arrow(Vec2 from, Vec2 to, DebugInk ink) = 0;
    /// Draws an axis-aligned box; by default as a polygon. Override it if the canvas has a faster method.
    virtual void box(const AABB& box, DebugInk ink);
};

/// The parts of debug drawing, bits of DebugOptions::parts.
enum DebugPart : std::uint32_t {
    kDrawShapes = 1 << 0,       ///< outlines, soft bodies, open directions of one-way shapes
    kDrawTriggers = 1 << 1,     ///< outlines of triggers, and lines to the shapes inside them
    kDrawContacts = 1 << 2,     ///< a circle at each contact point, also of sleeping bodies
    kDrawNormals = 1 << 3,      ///< an arrow at each contact point, towards the second body
    kDrawImpulses = 1 << 4,     ///< an arrow at each contact point for its impulse in the last substep
    kDrawFriction = 1 << 5,     ///< an arrow at each contact for its friction impulse
    kDrawJoints = 1 << 6,       ///< arms, limits, and a circle at each joint's anchor on B
    kDrawJointForces = 1 << 7,  ///< an arrow at each joint's anchor on B for its force
    kDrawVelocities = 1 << 8,
    kDrawCentres = 1 << 9,
    kDrawIslands = 1 << 10,  ///< the shapes of dynamic bodies again, with the number of their island
    kDrawRest = 1 << 11,     ///< shapes of dynamic bodies, scaled by rest time / sleep time
    kDrawSweeps = 1 << 12,   ///< paths of fast bodies in the last step, and their hits
    kDrawFields = 1 << 13,   ///< regions and directions of fields
    kDrawBounds = 1 << 14,
    kDrawBroadPhase = 1 << 15,  ///< enlarged bounds, and the tree or grid of the broad phase
    kDrawPaths = 1 << 16,       ///< predicted trajectories over the next second, without obstacles
    kDrawAll = (1 << 17) - 1
};

struct DebugOptions {
    std::uint32_t parts = kDrawAll;  ///< bits of DebugPart
    WorldPosition origin;            ///< m: drawn at (0, 0), for accuracy far from the world's origin
    const AABB* sight = nullptr;     ///< m, relative to `origin`: area that is visible; null: draw all shapes
    float minimum = 0.0f;            ///< m: for shapes smaller than this only the bounds are drawn
    float behind = 0.0f;  ///< s: moving bodies are drawn where they were this long ago, between two steps
    const Workspace* lastStep = nullptr;  ///< see lastStepOf(); null: no sweeps and no broad phase regions
    bool selectedOnly = false;            ///< draws only the objects selected below and their connections
    std::span<const std::uint8_t> bodies = {};      ///< [BodyId::index]: nonzero if selected; absent: 0
    std::span<const std::uint8_t> fields = {};      ///< [FieldId::index]: nonzero if selected
    std::span<const std::uint8_t> softBodies = {};  ///< [SoftBodyId::index]: nonzero if selected
};

/// Workspace of the last step of a world; null if the world was copied or loaded since.
[[nodiscard]] inline const Workspace* lastStepOf(const World& world) { return world.work.lastStep(); }

/// Draws the current state of a world, objects in the order of their indices. Allocates nothing.
void debugDraw(const World& world, DebugCanvas& canvas, const DebugOptions& choice);

}  // namespace plumb::physics
