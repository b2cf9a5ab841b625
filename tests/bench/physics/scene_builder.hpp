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

/// Scenes for any physics engine: each is written once, using
/// SceneBuilder, and each engine has an adapter. y points up here.
namespace plumb::scenes {

/// A body of a scene, in the order of creation. Places are not used twice.
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
    float sleepSpeed = 0.05f;  ///< m/s
    bool canSleep = true;
    bool awake = true;
    bool bullet = false;  ///< swept against moving bodies too
    bool fixedRotation = false;
    float gravityScale = 1.0f;
};

struct Material {
    float density = 1.0f;  ///< kg/m2
    float friction = 0.6f;
    float bounciness = 0.0f;
    std::uint32_t layers = 1;
    std::uint32_t mask = 0xffffffffu;
    int group = 0;         ///< two of the same group below 0 never meet
    bool reports = false;  ///< its contacts are events
    /// m/s of a belt: what lies on its upper side is carried along +x.
    float surfaceSpeed = 0.0f;
    bool oneWay = false;               ///< lets through what comes along `oneWayDirection`
    Vec2 oneWayDirection{0.0f, 1.0f};  ///< in the body's frame
};

enum class OutlineKind : std::uint8_t { Circle, Capsule, Box, Polygon, Segment, ChainSegment };

/// The outline of a shape in its body's frame (m): the convex hull of the points, grown by the radius.
/// ChainSegment is solid on the left of the way from its first to its second point.
struct Outline {
    OutlineKind kind = OutlineKind::Circle;
    std::uint8_t count = 0;
    float radius = 0.0f;
    std::array<Vec2, 8> points;
    Vec2 centre;  ///< of a box
    Vec2 half;    ///< of a box, without the radius

    [[nodiscard]] std::span<const Vec2> corners() const { return {points.data(), count}; }
};

Outline circle(float radius, Vec2 centre = {});
Outline capsule(Vec2 start, Vec2 end, float radius);
Outline box(Vec2 half, Vec2 centre = {}, float radius = 0.0f);
Outline polygon(std::span<const Vec2> points, float radius = 0.0f);  ///< the points in any order, convex
Outline segment(Vec2 start, Vec2 end);

enum class JointKind : std::uint8_t {
    Hinge,   ///< two points stay one
    Slider,  ///< B moves along an axis of A and does not turn
    Rod,     ///< two points keep their distance
    Wheel,   ///< B moves along an axis of A by a spring and turns freely
    Weld     ///< two points stay one, and the angle stays as it is
};

struct JointSetup {
    JointKind kind = JointKind::Hinge;
    BodyHandle a;
    BodyHandle b;
    Vec2 anchorA;  ///< m, in the body's frame
    Vec2 anchorB;
    Vec2 axis{1.0f, 0.0f};   ///< in A's frame: of Slider and Wheel
    float length = 1.0f;     ///< m: of Rod
    float reference = 0.0f;  ///< rad: angle of b minus angle of a that counts as 0
    bool limited = false;
    float lower = 0.0f;  ///< rad, of sliders m
    float upper = 0.0f;
    bool driven = false;
    float speed = 0.0f;                                  ///< rad/s, of sliders m/s
    float maxForce = std::numeric_limits<float>::max();  ///< N m, of sliders N
    bool sprung = false;
    float hertz = 0.0f;
    float dampingRatio = 0.0f;
};

/// What a world is made for.
struct WorldSetup {
    Vec2 gravity{0.0f, -10.0f};  ///< m/s2
    bool sleeping = true;
    int quality = 2;  ///< 2^quality substeps, where the engine has such a knob
    int threads = 1;
    bool profiled = false;  ///< stages() will be asked for
    double originX = 0.0;   ///< m: where (0, 0) of the scene is in the world
    double originY = 0.0;
};

/// Where a body's frame is.
struct Pose {
    double x = 0.0;  ///< m
    double y = 0.0;
    double cos = 1.0;
    double sin = 0.0;
};

/// A world of some engine that a scene is built in. Remembers what was built, so that all engines can be
/// judged by the same measure.
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
    /// One-sided segments through all points and back to the first; free on the right of the way.
    void addLoop(BodyHandle body, std::span<const Vec2> points, const Material& material);
    void addJoint(const JointSetup& joint);
    void destroy(BodyHandle body);  ///< and its shapes and joints

    /// A kinematic body will be there at the end of the next step.
    virtual void moveTo(BodyHandle body, Vec2 position, float angle, float dt) = 0;
    /// Kilograms whatever its shapes weigh; their distribution stays.
    virtual void setMass(BodyHandle body, float kilograms) = 0;
    virtual void setVelocity(BodyHandle body, Vec2 velocity) = 0;  ///< m/s
    virtual void setSpin(BodyHandle body, float spin) = 0;         ///< rad/s
    /// Puts a body elsewhere at once (m, rad); its velocity stays.
    virtual void setPosition(BodyHandle body, Vec2 position, float angle) = 0;
    virtual void finish() {}  ///< everything is built
    virtual void step(float dt) = 0;

    [[nodiscard]] virtual Pose poseOf(BodyHandle body) const = 0;
    [[nodiscard]] virtual Vec2 velocityOf(BodyHandle body) const = 0;  ///< m/s, of its centre of mass
    [[nodiscard]] virtual float spinOf(BodyHandle body) const = 0;     ///< rad/s
    /// Pairs of shapes that the engine holds for near, touching or not.
    [[nodiscard]] virtual std::size_t contactCount() const = 0;
    /// Time by stage over all steps; empty where the engine does not tell.
    [[nodiscard]] virtual std::vector<Profile::Zone> stages() const { return {}; }

    [[nodiscard]] std::span<const Body> bodies() const { return bodies_; }
    [[nodiscard]] std::span<const Shape> shapes() const { return shapes_; }
    [[nodiscard]] std::span<const JointSetup> joints() const { return joints_; }
    [[nodiscard]] bool alive(BodyHandle body) const { return bodies_[body.index].alive; }
    [[nodiscard]] bool isDynamic(BodyHandle body) const {
        return bodies_[body.index].motion == Motion::Dynamic;
    }
    /// What the scene asked for and the engine does not have; empty when it has all.
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
