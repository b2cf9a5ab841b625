#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "core/random.hpp"
#include "math/portable.hpp"
#include "physics/model/fields.hpp"
#include "physics/simulation.hpp"

namespace plumb::physics {

// Extreme scenes: sizes over six powers of ten, masses over eight, speeds up to 10 km/s, overlapping bodies,
// random joints and edits. In all of them the numbers must stay finite and every step must end.

/// A random extreme world. Counts its contacts and the calls that the world rejected.
class RandomScene {
public:
    explicit RandomScene(std::uint64_t seed) : random_{Random::seeded(seed)} {
        world_.settings.gravity = oneIn(4) ? Vec2{} : Vec2{0.0f, number(1.0e-3f, 1.0e3f)};
        world_.settings.quality = static_cast<Quality>(random_.below(4));
        world_.settings.automaticQuality = oneIn(4);
        world_.settings.integrator = static_cast<IntegratorKind>(random_.below(4));
        world_.settings.broadPhase = static_cast<BroadPhaseKind>(random_.below(4));
        world_.settings.sleeping = !oneIn(4);
        size_ = number(1.0e-3f, 1.0e3f);
        plain_ = oneIn(6);
        const std::uint32_t count = 2 + random_.below(8);
        for (std::uint32_t i = 0; i < count; ++i) addBody();
        for (std::uint32_t i = plain_ ? 0 : random_.below(5); i > 0; --i) addJoint();
        if (oneIn(4)) addField();
        world_.settings.tolerance = oneIn(4) ? 0.01f * size_ : 0.0f;
    }

    void run() {
        const std::uint32_t ticks = 2 + random_.below(12);
        for (std::uint32_t i = 0; i < ticks; ++i) {
            if (oneIn(3)) applyRandomEdit();
            step(world_, oneIn(20) ? number(1.0e-4f, 1.0f) : kTick);
            contacts_ += static_cast<int>(world_.contacts.size());
        }
    }

    [[nodiscard]] bool isSound() const {
        for (std::size_t i = 0; i < world_.bodies.size(); ++i) {
            const BodyPose& pose = world_.bodies.pose[i];
            const BodyMotion& motion = world_.bodies.motion[i];
            if (!std::isfinite(pose.centre.x) || !std::isfinite(pose.centre.y) ||
                !std::isfinite(pose.rotation.cos) || !std::isfinite(pose.rotation.sin) ||
                !isFinite(motion.velocity) || !std::isfinite(motion.angularVelocity)) {
                return false;
            }
        }
        return true;
    }
    [[nodiscard]] int contacts() const { return contacts_; }
    [[nodiscard]] bool isPlain() const { return plain_; }
    [[nodiscard]] int refused() const { return refused_; }

private:
    static constexpr float kTick = 1.0f / 60.0f;  ///< time step, s
    static constexpr std::uint32_t kBox = 5;      ///< the case of addShape() that creates a box
    static constexpr float kBadNumbers[] = {std::numeric_limits<float>::quiet_NaN(),
                                            std::numeric_limits<float>::infinity(),
                                            -std::numeric_limits<float>::infinity(),
                                            std::numeric_limits<float>::max(),
                                            std::numeric_limits<float>::denorm_min(),
                                            0.0f,
                                            -1.0f,
                                            1.0e30f};

    bool oneIn(std::uint32_t times) { return random_.below(times) == 0; }
    /// Returns a log-uniform random number from low to high; in one of 200 calls an invalid or extreme one.
    float number(float low, float high) {
        if (oneIn(200)) return kBadNumbers[random_.below(static_cast<std::uint32_t>(std::size(kBadNumbers)))];
        return low * exponential(random_.unit() * std::log(high / low));
    }
    float either(float value) { return oneIn(2) ? value : -value; }
    Vec2 vector(float low, float high) { return {either(number(low, high)), either(number(low, high))}; }
    BodyId randomBody() {
        if (bodies_.empty() || oneIn(50)) return {random_.below(20), random_.below(3)};
        return bodies_[random_.below(static_cast<std::uint32_t>(bodies_.size()))];
    }
    template <class T>
    bool accepted(const Result<T>& result) {
        refused_ += result.ok() ? 0 : 1;
        return result.ok();
    }

    void addShape(BodyId body) {
        ShapeDefinition shape;
        shape.density = number(1.0e-4f, 1.0e4f);
        shape.friction = oneIn(4) ? 0.0f : number(0.01f, 10.0f);
        shape.bounciness = plain_ || oneIn(2) ? 0.0f : random_.unit();
        shape.rollingResistance = !plain_ && oneIn(8) ? random_.unit() : 0.0f;
        shape.surfaceSpeed = oneIn(8) ? number(0.01f, 100.0f) : 0.0f;
        shape.isTrigger = oneIn(8);
        shape.oneWay = oneIn(8);
        const float size = size_ * number(1.0e-2f, 1.0f);
        const Vec2 offset = oneIn(2) ? Vec2{} : vector(1.0e-3f * size_, size_);
        switch (plain_ && !oneIn(4) ? kBox : random_.below(kBox + 1)) {
            case 0: accepted(createShape(world_, body, circle(size, offset), shape)); break;
            case 1:
                accepted(createShape(world_, body, capsule(offset, vector(1.0e-3f * size, size), 0.3f * size),
                                     shape));
                break;
            case 2:
                accepted(createShape(world_, body, segment(offset, vector(1.0e-3f * size, size)), shape));
                break;
            case 3:
                accepted(createPolygon(world_, body, corners(size), oneIn(3) ? 0.1f * size : 0.0f, shape));
                break;
            case 4: accepted(createChain(world_, body, corners(size), oneIn(2), shape)); break;
            case kBox:
                accepted(createShape(
                    world_, body,
                    box({size, size * number(1.0e-3f, 1.0f)}, offset, {}, oneIn(3) ? 0.1f * size : 0.0f),
                    shape));
        }
    }
    std::vector<Vec2> corners(float size) {
        std::vector<Vec2> points(random_.below(10));
        for (Vec2& point : points) point = vector(1.0e-2f * size, size);
        if (points.size() > 2 && oneIn(8)) points[1] = points[0];
        return points;
    }

    void addBody() {
        BodyDefinition body;
        body.kind = static_cast<BodyKind>(oneIn(3) ? 1 + random_.below(2) : 3);
        const Vec2 place = oneIn(3) ? Vec2{} : vector(1.0e-3f * size_, size_);
        body.position =
            oneIn(8) ? WorldPosition{1.0e7 + static_cast<double>(place.x), static_cast<double>(place.y)}
                     : WorldPosition{place};
        body.angle = plain_ && !oneIn(8) ? 0.0f : either(number(1.0e-3f, 100.0f));
        if (oneIn(2)) body.velocity = vector(1.0e-2f, 1.0e4f);
        if (!plain_ && oneIn(2)) body.angularVelocity = either(number(1.0e-2f, 1.0e3f));
        if (oneIn(4)) body.linearDrag = number(1.0e-3f, 1.0e3f);
        body.fixedRotation = plain_ || oneIn(8);
        body.lockX = oneIn(16);
        body.bullet = oneIn(8);
        body.awake = !oneIn(8);
        const auto made = createBody(world_, body);
        if (!accepted(made)) return;
        bodies_.push_back(*made);
        for (std::uint32_t i = random_.below(3) + 1; i > 0; --i) addShape(*made);
        if (oneIn(3)) accepted(setMass(world_, *made, number(1.0e-4f, 1.0e4f)));
    }
    void addJoint() {
        JointDefinition joint;
        joint.kind = static_cast<JointKind>(random_.below(static_cast<std::uint32_t>(JointKind::Count)));
        joint.a = randomBody();
        joint.b = randomBody();
        joint.anchorA = vector(1.0e-3f * size_, size_);
        joint.anchorB = vector(1.0e-3f * size_, size_);
        joint.length = number(1.0e-3f, 1.0e3f);
        joint.limit = {oneIn(2), -number(1.0e-3f, 10.0f), number(1.0e-3f, 10.0f)};
        joint.motor = {oneIn(2), either(number(1.0e-2f, 1.0e3f)), number(1.0e-2f, 1.0e6f)};
        joint.spring = {oneIn(3), number(1.0e-2f, 100.0f), number(1.0e-2f, 10.0f), 0.0f};
        joint.maxForce = number(1.0e-2f, 1.0e8f);
        if (oneIn(4)) joint.breakForce = number(1.0e-2f, 1.0e6f);
        joint.ratio = either(number(1.0e-2f, 100.0f));
        joint.collideConnected = oneIn(2);
        if (!joints_.empty()) joint.jointA = joints_.front(), joint.jointB = joints_.back();
        const auto made = createJoint(world_, joint);
        if (accepted(made)) joints_.push_back(*made);
    }
    void addField() {
        FieldDefinition field;
        field.kind = static_cast<FieldKind>(random_.below(static_cast<std::uint32_t>(FieldKind::Count)));
        field.a = randomBody();
        field.b = randomBody();
        accepted(createField(world_, field));
    }

    void applyRandomEdit() {
        const BodyId body = randomBody();
        switch (random_.below(9)) {
            case 0: accepted(setVelocity(world_, body, vector(1.0e-2f, 1.0e4f))); break;
            case 1:
                accepted(setPosition(world_, body, WorldPosition{vector(1.0e-3f, 1.0e4f)},
                                     number(1.0e-2f, 10.0f)));
                break;
            case 2: accepted(applyImpulse(world_, body, vector(1.0e-3f, 1.0e6f))); break;
            case 3: accepted(setMass(world_, body, number(1.0e-4f, 1.0e4f))); break;
            case 4: destroyBody(world_, body); break;
            case 5: addBody(); break;
            case 6:
                if (!joints_.empty()) destroyJoint(world_, joints_.back());
                break;
            case 7:
                accepted(moveTo(world_, body, WorldPosition{vector(1.0e-3f, 1.0e3f)}, number(1.0e-2f, 10.0f),
                                kTick));
                break;
            default: setAwake(world_, body, oneIn(2));
        }
    }

    World world_;
    Random random_;
    std::vector<BodyId> bodies_;
    std::vector<JointId> joints_;
    float size_ = 1.0f;
    bool plain_ = false;  ///< fixed rotation, no bounce or joints, mostly boxes: runs the reduced kernels
    int contacts_ = 0;    ///< number of contacts, summed over all steps
    int refused_ = 0;     ///< number of rejected calls
};

}  // namespace plumb::physics
