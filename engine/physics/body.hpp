#pragma once

#include <cstdint>

#include "math/rot.hpp"
#include "physics/ids.hpp"

namespace plumb::physics {

/// Who moves a body: nobody, its owner, or forces and contacts. `None` marks a free place.
enum class BodyKind : std::uint8_t { None, Static, Kinematic, Dynamic };

/// A place in the world (m). Double, so that a scene 1000 km from the origin is as exact as one at it;
/// all differences of two places are taken first and are float from then on.
struct Place {
    double x = 0.0;
    double y = 0.0;

    constexpr Place() = default;
    constexpr Place(double px, double py) : x{px}, y{py} {}
    constexpr Place(Vec2 v) : x{v.x}, y{v.y} {}
    friend constexpr bool operator==(Place, Place) = default;
};

constexpr Place operator+(Place a, Vec2 b) {
    return {a.x + static_cast<double>(b.x), a.y + static_cast<double>(b.y)};
}
constexpr Vec2 operator-(Place a, Place b) {
    return {static_cast<float>(a.x - b.x), static_cast<float>(a.y - b.y)};
}
constexpr Vec2 toVec2(Place a) { return {static_cast<float>(a.x), static_cast<float>(a.y)}; }

/// How exactly a body, a joint or a scene is simulated: 2^value substeps, and the stiffness that goes with
/// them. An island takes the highest that one of its members asks for.
using Quality = std::int8_t;
inline constexpr Quality kQualityOfWorld = -1;  ///< whatever Settings::quality says
inline constexpr Quality kMaxQuality = 6;

/// Everything a new body needs besides its shapes.
struct BodyDefinition {
    BodyKind kind = BodyKind::Dynamic;
    Place position{};              ///< m, of the frame its shapes are written in
    float angle = 0.0f;            ///< rad
    Vec2 velocity{};               ///< m/s, of the centre of mass
    float angularVelocity = 0.0f;  ///< rad/s
    Vec2 acceleration{};           ///< m/s2, added to gravity in every step
    float gravityScale = 1.0f;     ///< ratio; 0 floats
    float linearDrag = 0.0f;       ///< 1/s: part of the speed lost in a second, at the start of it
    float angularDrag = 0.0f;      ///< 1/s
    float sleepSpeed = 0.05f;      ///< m/s: slower than this for a while it falls asleep
    bool fixedRotation = false;
    bool lockX = false;  ///< its velocity along x stays 0
    bool lockY = false;
    bool bullet = false;  ///< swept against moving bodies too
    bool canSleep = true;
    bool awake = true;
    Quality quality = kQualityOfWorld;
    std::uint64_t user = 0;  ///< the owner's own number for it, repeated in events
};

}  // namespace plumb::physics
