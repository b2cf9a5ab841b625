#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "physics/world.hpp"

namespace plumb::physics {

/// What something drawn stands for; a canvas gives each a colour.
enum class DebugRole : std::uint8_t {
    Fixed,       ///< a shape of a static body
    Driven,      ///< of a kinematic one
    Awake,       ///< of a dynamic one that is awake
    Asleep,      ///< that rests
    Trigger,     ///< a shape that stops nobody
    Bounds,      ///< the box around a shape
    BroadPhase,  ///< the larger box that the broad phase keeps
    Contact,     ///< a point where two shapes touch
    Normal,      ///< the direction of a contact
    Impulse,     ///< how hard it pushes
    Joint,
    Velocity,
    Centre,  ///< a centre of mass
    Island,  ///< who rests or moves together
    Count
};

/// Something to draw on. Lengths are metres, places are seen from the origin given to debugDraw().
class DebugCanvas {
public:
    virtual ~DebugCanvas() = default;
    virtual void line(Vec2 from, Vec2 to, DebugRole role) = 0;
    virtual void circle(Vec2 centre, float radius, DebugRole role) = 0;
    virtual void polygon(std::span<const Vec2> corners, DebugRole role) = 0;
    virtual void arrow(Vec2 from, Vec2 to, DebugRole role) = 0;
    virtual void text(Vec2 at, std::string_view words, DebugRole role) = 0;
};

/// What to draw; bits.
enum DebugPart : unsigned {
    kDrawShapes = 1,
    kDrawBounds = 2,
    kDrawBroadPhase = 4,
    kDrawContacts = 8,   ///< a circle at each point, of sleeping bodies too
    kDrawNormals = 16,   ///< an arrow at each point, towards the second body
    kDrawImpulses = 32,  ///< an arrow at each point that pushed in the last substep
    kDrawJoints = 64,    ///< arms, and a circle at each joint's point on B
    kDrawVelocities = 128,
    kDrawCentres = 256,
    kDrawIslands =
        512,  ///< a line from each dynamic body to one of its island, and the island's number there
    kDrawAll = 1023
};

/// Draws a world as it is now, in the order of its numbers.
/// @param parts   bits of DebugPart
/// @param origin  m: drawn places are seen from here, so that they stay exact far from the world's origin
void debugDraw(const World& world, DebugCanvas& canvas, unsigned parts, Place origin = {});

}  // namespace plumb::physics
