#pragma once

#include <cstdint>

#include "math/vec2.hpp"
#include "physics/ids.hpp"

namespace plumb::physics {

/// Static bodies do not move, kinematic ones move by their own velocity only, dynamic ones by forces and
/// contacts too. `None` marks a free slot.
enum class BodyKind : std::uint8_t { None, Static, Kinematic, Dynamic };

/// A position in the world (m). Double precision, so that a scene 1000 km from the origin is as accurate as
/// one at the origin. Code subtracts two positions first and then computes in float.
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

/// Accuracy of a body, a joint or a scene: 2^value substeps, with contact and joint springs of matching
/// stiffness. An island uses the maximum of its bodies and joints.
using Quality = std::int8_t;
inline constexpr Quality kQualityOfWorld = -1;  ///< use Settings::quality
inline constexpr Quality kMaxQuality = 6;

/// Properties of a new body, except its shapes.
struct BodyDefinition {
    BodyKind kind = BodyKind::Dynamic;
    WorldPosition position{};      ///< m: origin of the frame in which its shapes are defined
    float angle = 0.0f;            ///< rad
    Vec2 velocity{};               ///< m/s, of the centre of mass
    float angularVelocity = 0.0f;  ///< rad/s
    Vec2 acceleration{};           ///< m/s2, added to gravity in every step
    float gravityScale = 1.0f;     ///< ratio; 0: no gravity
    float linearDrag = 0.0f;   ///< 1/s: decay rate; without forces the velocity falls as exp(-linearDrag t)
    float angularDrag = 0.0f;  ///< 1/s
    /// m/s: it may fall asleep after moving slower than this for Settings::sleepTime. Faster motion reduces
    /// the accumulated time by the ratio of its energy to that at this speed. Bodies that only fields push
    /// must also be slower than Settings::slop per sleepTime (1 cm/s).
    float sleepSpeed = 0.05f;
    bool fixedRotation = false;
    bool lockX = false;  ///< locked: velocity along x is 0
    bool lockY = false;
    bool bullet = false;  ///< continuous collision detection also against moving bodies
    bool canSleep = true;
    bool awake = true;
    Quality quality = kQualityOfWorld;
    std::uint64_t user = 0;  ///< user data: a number of the caller, not used by the library
};

}  // namespace plumb::physics
