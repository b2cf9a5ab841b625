#pragma once

#include <cstdint>

#include "math/vec2.hpp"
#include "physics/ids.hpp"

namespace plumb::physics {

/// What moves a body: nothing, its own velocity only, or forces and contacts. `None` marks a free slot.
enum class BodyKind : std::uint8_t { None, Static, Kinematic, Dynamic };

/// A position in the world (m). Double precision, so that a scene 1000 km from the origin is as accurate as
/// one at the origin. Code takes the difference of two positions first and computes in float from there on.
struct WorldPosition {
    double x = 0.0;
    double y = 0.0;

    constexpr WorldPosition() = default;
    constexpr WorldPosition(double px, double py) : x{px}, y{py} {}
    constexpr WorldPosition(Vec2 v) : x{v.x}, y{v.y} {}
    friend constexpr bool operator==(WorldPosition, WorldPosition) = default;
};

constexpr WorldPosition operator+(WorldPosition a, Vec2 b) {
    return {a.x + static_cast<double>(b.x), a.y + static_cast<double>(b.y)};
}
constexpr Vec2 operator-(WorldPosition a, WorldPosition b) {
    return {static_cast<float>(a.x - b.x), static_cast<float>(a.y - b.y)};
}
constexpr Vec2 toVec2(WorldPosition a) { return {static_cast<float>(a.x), static_cast<float>(a.y)}; }

/// Accuracy of a body, a joint or a scene: 2^value substeps, with the stiffness to match. An island uses the
/// maximum that one of its members asks for.
using Quality = std::int8_t;
inline constexpr Quality kQualityOfWorld = -1;  ///< use Settings::quality
inline constexpr Quality kMaxQuality = 6;

/// Everything that a new body needs besides its shapes.
struct BodyDefinition {
    BodyKind kind = BodyKind::Dynamic;
    WorldPosition position{};      ///< m, of the frame that its shapes are defined in
    float angle = 0.0f;            ///< rad
    Vec2 velocity{};               ///< m/s, of the centre of mass
    float angularVelocity = 0.0f;  ///< rad/s
    Vec2 acceleration{};           ///< m/s2, added to gravity in every step
    float gravityScale = 1.0f;     ///< ratio; 0: no gravity
    float linearDrag = 0.0f;   ///< 1/s: decay rate; without forces the velocity falls as exp(-linearDrag t)
    float angularDrag = 0.0f;  ///< 1/s
    /// m/s: it may fall asleep when slower than this for Settings::sleepTime. Faster motion takes off as much
    /// of that time as its energy exceeds that of this speed. What only fields push has to be slower than
    /// Settings::slop per sleepTime (1 cm/s), too.
    float sleepSpeed = 0.05f;
    bool fixedRotation = false;
    bool lockX = false;  ///< its velocity along x stays 0
    bool lockY = false;
    bool bullet = false;  ///< continuous collision detection against moving bodies too
    bool canSleep = true;
    bool awake = true;
    Quality quality = kQualityOfWorld;
    std::uint64_t user = 0;  ///< the owner's own number for it, returned in events
};

}  // namespace plumb::physics
