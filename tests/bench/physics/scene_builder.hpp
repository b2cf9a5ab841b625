#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/profile.hpp"
#include "math/vec2.hpp"

/// Scenes for any physics engine: each scene is written once, using
/// SceneBuilder, and each engine has an adapter. y points up.
namespace plumb::scenes {

/// Handle of a body: its index in the order of creation. Indices of destroyed bodies are not reused.
struct BodyHandle {
    std::uint32_t index = std::numeric_limits<std::uint32_t>::max();
};

enum class Motion : std::uint8_t { Static, Kinematic, Dynamic };

struct BodySetup {
    Motion motion = Motion::Dynamic;
    Vec2 position;             ///< m
    float angle = 0.0f;        ///< rad
    Vec2 velocity;             ///< m/s
    float spin = 0.0f;         ///< rad/s
    float drag = 0.0f;         ///< 1/s
    float sleepSpeed = 0.05f;  ///< m/s: slower bodies may sleep
    bool canSleep = true;
    bool awake = true;
    bool bullet = false;  ///< continuous collision also with moving bodies
    bool fixedRotation = false;
    float gravityScale = 1.0f;
};

struct Material {
    float density = 1.0f;  ///< kg/m2
    float friction = 0.6f;
    float bounciness = 0.0f;
    std::uint32_t layers = 1;          ///< bits of the collision layers of the shape
    std::uint32_t mask = 0xffffffffu;  ///< bits of the layers with which the shape collides
    int group = 0;                     ///< shapes of the same negative group never collide
    bool reports = false;              ///< its contacts create events
    /// Speed of a conveyor belt, m/s: bodies on its upper side are moved along +x.
    float surfaceSpeed = 0.0f;
    bool oneWay = false;               ///< bodies that move along `oneWayDirection` pass through
    Vec2 oneWayDirection{0.0f, 1.0f};  ///< direction in the body's frame
};

enum class OutlineKind : std::uint8_t { Circle, Capsule, Box, Polygon, Segment, ChainSegment };

/// The outline of a shape in its body's frame, m: the convex hull of the points, enlarged by the radius.
/// A ChainSegment is solid on its left side, seen from its first to its second point.
struct Outline {
    OutlineKind kind = OutlineKind::Circle;
    std::uint8_t count = 0;
    float radius = 0.0f;
    std::array<Vec2, 8> points;
    Vec2 centre;  ///< only for boxes
    Vec2 half;    ///< only for boxes: half of the size, without the radius

    [[nodiscard]] std::span<const Vec2> corners() const { return {points.data(), count}; }
};

Outline circle(float radius, Vec2 centre = {});
Outline capsule(Vec2 start, Vec2 end, float radius);
Outline box(Vec2 half, Vec2 centre = {}, float radius = 0.0f);
Outline polygon(std::span<const Vec2> points, float radius = 0.0f);  ///< convex hull of points in any order
Outline segment(Vec2 start, Vec2 end);

enum class JointKind : std::uint8_t {
    Hinge,   ///< two anchor points coincide
    Slider,  ///< B moves along an axis of A and does not rotate
    Rod,     ///< two anchor points keep their distance
    Wheel,   ///< B moves along an axis of A with a spring and rotates freely
    Weld     ///< two anchor points coincide, and the relative angle is constant
};

struct JointSetup {
    JointKind kind = JointKind::Hinge;
    BodyHandle a;
    BodyHandle b;
    Vec2 anchorA;            ///< m, in A's frame
    Vec2 anchorB;            ///< m, in B's frame
    Vec2 axis{1.0f, 0.0f};   ///< direction in A's frame, for Slider and Wheel
    float length = 1.0f;     ///< distance of a Rod's anchors, m
    float reference = 0.0f;  ///< rad: angle of b minus angle of a at which the joint's angle is 0
    bool limited = false;    ///< `lower` and `upper` apply
    float lower = 0.0f;      ///< lower limit, rad; for sliders m
    float upper = 0.0f;      ///< upper limit, rad; for sliders m
    bool driven = false;     ///< has a motor with `speed` and `maxForce`
    float speed = 0.0f;      ///< motor speed, rad/s; for sliders m/s
    float maxForce = std::numeric_limits<float>::max();  ///< of the motor: torque, N m; for sliders force, N
    bool sprung = false;                                 ///< has a spring with `hertz`
    float hertz = 0.0f;
    float dampingRatio = 0.0f;
};

/// Settings of a physics world.
struct WorldSetup {
    Vec2 gravity{0.0f, -10.0f};  ///< m/s2
    bool sleeping = true;
    int quality = 2;  ///< engines with substeps use 2^quality per step
    int threads = 1;
    bool profiled = false;  ///< measures the times of stages, for stages()
    double originX = 0.0;   ///< position of the scene's origin in the world, m
    double originY = 0.0;
};

/// Position and rotation of a body's frame.
struct Pose {
    double x = 0.0;  ///< m
    double y = 0.0;
    double cos = 1.0;
    double sin = 0.0;
};

/// Interface of an engine's world in which a scene is built. Stores bodies, shapes and joints, so that the
/// errors of all engines are computed by the same code.
class SceneBuilder {
public:
    struct Body {
        Motion motion = Motion::Dynamic;
        bool alive = true;
    };
    struct Shape {
        BodyHandle body;
        Outline outline;
        Material material;
    };

    SceneBuilder() = default;
    SceneBuilder(const SceneBuilder&) = delete;
    SceneBuilder& operator=(const SceneBuilder&) = delete;
    virtual ~SceneBuilder() = default;

    BodyHandle createBody(const BodySetup& setup);
    void addShape(BodyHandle body, const Outline& outline, const Material& material = {});
    /// Adds a closed loop of one-sided segments through all points, solid on the left side of the path.
    void addLoop(BodyHandle body, std::span<const Vec2> points, const Material& material);
    void addJoint(const JointSetup& joint);
    void destroy(BodyHandle body);  ///< destroys a body with its shapes and joints

    /// Moves a kinematic body so that it reaches a position (m) and angle (rad) at the end of the next step.
    virtual void moveTo(BodyHandle body, Vec2 position, float angle, float dt) = 0;
    /// Sets a body's mass, kg, instead of that of its shapes; the moment of inertia is scaled accordingly.
    virtual void setMass(BodyHandle body, float kilograms) = 0;
    virtual void setVelocity(BodyHandle body, Vec2 velocity) = 0;  ///< m/s
    virtual void setSpin(BodyHandle body, float spin) = 0;         ///< rad/s
    /// Teleports a body to a position (m) and angle (rad); keeps its velocity.
    virtual void setPosition(BodyHandle body, Vec2 position, float angle) = 0;
    virtual void finish() {}  ///< called when the scene is complete
    virtual void step(float dt) = 0;

    [[nodiscard]] virtual Pose poseOf(BodyHandle body) const = 0;
    [[nodiscard]] virtual Vec2 velocityOf(
        BodyHandle body) const = 0;                                 ///< velocity of the centre of mass, m/s
    [[nodiscard]] virtual float spinOf(BodyHandle body) const = 0;  ///< rad/s
    /// Returns the number of pairs of shapes that the engine tracks, touching or only near.
    [[nodiscard]] virtual std::size_t contactCount() const = 0;
    /// Returns the total time of each stage over all steps; empty if the engine does not measure it.
    [[nodiscard]] virtual std::vector<Profile::Zone> stages() const { return {}; }

    [[nodiscard]] std::span<const Body> bodies() const { return bodies_; }
    [[nodiscard]] std::span<const Shape> shapes() const { return shapes_; }
    [[nodiscard]] std::span<const JointSetup> joints() const { return joints_; }
    [[nodiscard]] bool alive(BodyHandle body) const { return bodies_[body.index].alive; }
    [[nodiscard]] bool isDynamic(BodyHandle body) const {
        return bodies_[body.index].motion == Motion::Dynamic;
    }
    /// Returns a feature of the scene that the engine lacks; empty if it has all.
    [[nodiscard]] const std::string& missing() const { return missing_; }

protected:
    virtual void makeBody(BodyHandle body, const BodySetup& setup) = 0;
    virtual void makeShape(BodyHandle body, const Outline& outline, const Material& material) = 0;
    virtual void makeLoop(BodyHandle body, std::span<const Vec2> points, const Material& material) = 0;
    virtual void makeJoint(const JointSetup& joint) = 0;
    virtual void dropBody(BodyHandle body) = 0;
    void lacks(std::string_view feature) { missing_ = feature; }

private:
    std::vector<Body> bodies_;
    std::vector<Shape> shapes_;
    std::vector<JointSetup> joints_;
    std::string missing_;
};

}  // namespace plumb::scenes
