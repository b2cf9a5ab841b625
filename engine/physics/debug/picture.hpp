#pragma once

#include "physics/contacts/contacts.hpp"
#include "physics/debug_draw.hpp"
#include "physics/shapes/convex.hpp"

namespace plumb::physics {

/// Length (m) of a force's arrow per acceleration (m/s2) of the lighter body: 0.2 m for its weight.
inline constexpr float kArrowPerAcceleration = 0.02f;
inline constexpr float kLongestArrow = 1.0f;  ///< m: otherwise arrows of hard impacts would cross the screen
inline constexpr float kPointRadius = 0.02f;  ///< m
inline constexpr float kOneWayArrow = 0.25f;  ///< m: its length; nothing is drawn farther from its shape

struct Picture {  // what the functions below draw, and where
    const World& world;
    DebugCanvas& canvas;
    const DebugOptions& choice;

    [[nodiscard]] BodyPose pose(std::uint32_t body) const {
        BodyPose pose = world.bodies.pose[body];
        if (choice.behind == 0.0f || !moves(body)) return pose;
        const BodyMotion& motion = world.bodies.motion[body];
        pose.centre = pose.centre + -choice.behind * motion.velocity;
        pose.rotation = normalized(rotFromAngle(-choice.behind * motion.angularVelocity) * pose.rotation);
        return pose;
    }
    [[nodiscard]] bool moves(std::uint32_t body) const {
        return world.bodies.info[body].kind == BodyKind::Kinematic || isUp(world, body);
    }
    [[nodiscard]] Vec2 seen(WorldPosition place) const { return place - choice.origin; }
    [[nodiscard]] Vec2 centre(std::uint32_t body) const { return seen(pose(body).centre); }
    /// Position on the canvas of a point given relative to a body's center of mass, in its frame.
    [[nodiscard]] Vec2 place(std::uint32_t body, Vec2 arm) const {
        return centre(body) + rotate(pose(body).rotation, arm);
    }
    /// Frame of a body's shapes on the canvas, if the body is at `pose`.
    [[nodiscard]] Frame frame(const BodyPose& pose) const {
        return {seen(pose.centre) - rotate(pose.rotation, pose.localCentre), pose.rotation};
    }
    [[nodiscard]] Frame frame(std::uint32_t body) const { return frame(pose(body)); }
    [[nodiscard]] Convex outline(std::uint32_t shape) const {
        return convexOf(world.shapes.geometry[shape], world.shapes.corners);
    }
    /// Bounds of a shape in the broad phase (enlarged by its margin), relative to the origin of the canvas.
    [[nodiscard]] AABB box(std::uint32_t shape) const {
        const auto& box = world.shapes.bounds[shape];
        return {seen(box.min), seen(box.max)};
    }
    /// True if a shape of the body may reach into the visible area.
    /// @param box  bounds of the shape
    [[nodiscard]] bool isInSight(const AABB& box, std::uint32_t body) const {
        if (choice.sight == nullptr) return true;
        const float speed = moves(body) ? length(world.bodies.motion[body].velocity) : 0.0f;
        return intersects(grown(box, std::abs(choice.behind) * speed + kOneWayArrow), *choice.sight);
    }
    /// True if a shape is so small on the canvas that its bounds look like its outline.
    [[nodiscard]] bool isDot(const AABB& box) const {
        const Vec2 size = box.size();
        return size.x < choice.minimum && size.y < choice.minimum;
    }
    [[nodiscard]] bool shows(std::uint32_t body) const { return isAmong(choice.bodies, body); }
    /// True if the object with this index is selected, or if all objects are shown.
    [[nodiscard]] bool isAmong(std::span<const std::uint8_t> chosen, std::size_t index) const {
        return !choice.selectedOnly || (index < chosen.size() && chosen[index] != 0);
    }

    /// Calls draw(body) for all bodies that are shown.
    template <class Draw>
    void forBodies(Draw&& draw) const {
        for (std::uint32_t body = 0; body < world.bodies.size(); ++body) {
            if (world.bodies.info[body].kind != BodyKind::None && shows(body)) draw(body);
        }
    }
    /// Calls draw(shape, body) for all shapes that are shown.
    template <class Draw>
    void forShapes(Draw&& draw) const {
        for (std::uint32_t s = 0; s < world.shapes.size(); ++s) {
            const std::uint32_t body = world.shapes.info[s].body;
            if (world.shapes.motion[s] != ProxyMotion::Gone && shows(body) && isInSight(box(s), body))
                draw(s, body);
        }
    }
    /// Calls draw(contact) for the touching contacts that are shown, with a trigger or (false) without.
    template <class Draw>
    void forContacts(bool triggered, Draw&& draw) const {
        forTouching(world, triggered, [&](const Contact& contact) {
            if (shows(contact.bodyA) || shows(contact.bodyB)) draw(contact);
        });
    }
};

/// Returns the arrow, shortened to at most kLongestArrow.
inline Vec2 limited(Vec2 arrow) {
    const float size = length(arrow);
    return size > kLongestArrow ? (kLongestArrow / size) * arrow : arrow;
}

/// Draws an outline as a polygon, a circle with a spoke, or a line.
void drawOutline(DebugCanvas& canvas, const Convex& convex, const Frame& frame, DebugInk ink);
/// Draws a circular arc of `angle` (rad) that begins in direction `from`, as lines.
void drawArc(DebugCanvas& canvas, Vec2 centre, float radius, Rot from, float angle, DebugInk ink);

// One function for each DebugPart.
void drawShapes(const Picture& picture);
void drawTriggers(const Picture& picture);
void drawContacts(const Picture& picture);
void drawNormals(const Picture& picture);
void drawImpulses(const Picture& picture);
void drawFriction(const Picture& picture);
void drawJoints(const Picture& picture);
void drawJointForces(const Picture& picture);
void drawVelocities(const Picture& picture);
void drawPaths(const Picture& picture);
void drawCentres(const Picture& picture);
void drawIslands(const Picture& picture);
void drawRest(const Picture& picture);
void drawSweeps(const Picture& picture);
void drawFields(const Picture& picture);
void drawBounds(const Picture& picture);
void drawBroadPhase(const Picture& picture);

}  // namespace plumb::physics
