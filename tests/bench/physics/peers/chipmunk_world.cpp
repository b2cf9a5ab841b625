#include <chipmunk/chipmunk.h>
#include <cmath>
#include <deque>

#include "math/portable.hpp"
#include "tests/bench/physics/peers/peers.hpp"

namespace plumb::scenes {

namespace {

constexpr int kIterations = 10;
constexpr double kSlop = 0.005;     // m; Chipmunk's default is for lengths in pixels
constexpr double kSleepTime = 0.5;  // s

cpVect toPeer(Vec2 v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

/// Velocity update of a body with drag, which is stored as its user data.
void dragAlong(cpBody* body, cpVect gravity, cpFloat damping, cpFloat dt) {
    const double drag = *static_cast<const double*>(cpBodyGetUserData(body));
    cpBodyUpdateVelocity(body, gravity, damping * (1.0 - drag * dt), dt);
}

/// Counts each touching pair twice: once for each dynamic body, or twice if the other body is not dynamic,
/// because only dynamic bodies are visited.
void countArbiter(cpBody* body, cpArbiter* arbiter, void* count) {
    cpBody* a = nullptr;
    cpBody* b = nullptr;
    cpArbiterGetBodies(arbiter, &a, &b);
    const bool alone = cpBodyGetType(a == body ? b : a) != CP_BODY_TYPE_DYNAMIC;
    *static_cast<std::size_t*>(count) += alone ? 2 : 1;
}

class ChipmunkWorld final : public SceneBuilder {
public:
    explicit ChipmunkWorld(const WorldSetup& setup) : space_{cpSpaceNew()} {
        cpSpaceSetIterations(space_, kIterations);
        cpSpaceSetGravity(space_, toPeer(setup.gravity));
        cpSpaceSetCollisionSlop(space_, kSlop);
        if (setup.sleeping) cpSpaceSetSleepTimeThreshold(space_, kSleepTime);
    }
    ~ChipmunkWorld() override {
        for (std::uint32_t i = 0; i < parts_.size(); ++i) dropBody({i});
        for (cpConstraint* constraint : retired_) cpConstraintFree(constraint);
        cpSpaceFree(space_);
    }

    void moveTo(BodyHandle body, Vec2 position, float /*angle*/, float dt) override {
        const cpVect displacement = cpvsub(toPeer(position), cpBodyGetPosition(at(body)));
        cpBodySetVelocity(at(body), cpvmult(displacement, 1.0 / static_cast<double>(dt)));
    }
    void setMass(BodyHandle body, float kilograms) override {
        // Set the shapes' masses to 0; otherwise every change of a shape would recompute the body's mass.
        const double mass = cpBodyGetMass(at(body)), moment = cpBodyGetMoment(at(body));
        for (cpShape* shape : parts_[body.index].shapes) cpShapeSetMass(shape, 0.0);
        cpBodySetMass(at(body), static_cast<double>(kilograms));
        cpBodySetMoment(at(body), moment * static_cast<double>(kilograms) / mass);
    }
    void setVelocity(BodyHandle body, Vec2 velocity) override {
        cpBodySetVelocity(at(body), toPeer(velocity));
    }
    void setSpin(BodyHandle body, float spin) override {
        cpBodySetAngularVelocity(at(body), static_cast<double>(spin));
    }
    void setPosition(BodyHandle body, Vec2 position, float angle) override {
        cpBodySetPosition(at(body), toPeer(position));
        cpBodySetAngle(at(body), static_cast<double>(angle));
        cpSpaceReindexShapesForBody(space_, at(body));
    }
    void finish() override {
        for (const BodyHandle body : sleepers_) cpBodySleep(at(body));
    }
    void step(float dt) override { cpSpaceStep(space_, static_cast<double>(dt)); }

    [[nodiscard]] Pose poseOf(BodyHandle body) const override {
        const cpVect position = cpBodyGetPosition(at(body));
        const cpVect rotation = cpBodyGetRotation(at(body));
        return {position.x, position.y, rotation.x, rotation.y};
    }
    [[nodiscard]] Vec2 velocityOf(BodyHandle body) const override {
        const cpVect velocity = cpBodyGetVelocity(at(body));
        return {static_cast<float>(velocity.x), static_cast<float>(velocity.y)};
    }
    [[nodiscard]] float spinOf(BodyHandle body) const override {
        return static_cast<float>(cpBodyGetAngularVelocity(at(body)));
    }
    /// Chipmunk does not track pairs that only are near, so the count is smaller than that of other engines.
    [[nodiscard]] std::size_t contactCount() const override {
        std::size_t count = 0;
        for (std::uint32_t i = 0; i < parts_.size(); ++i) {
            if (alive({i}) && isDynamic({i})) cpBodyEachArbiter(at({i}), &countArbiter, &count);
        }
        return count / 2;
    }

protected:
    void makeBody(BodyHandle body, const BodySetup& setup) override {
        cpBody* made = setup.motion == Motion::Static      ? cpBodyNewStatic()
                       : setup.motion == Motion::Kinematic ? cpBodyNewKinematic()
                                                           : cpBodyNew(0.0, 0.0);
        cpSpaceAddBody(space_, made);
        cpBodySetPosition(made, toPeer(setup.position));
        cpBodySetAngle(made, static_cast<double>(setup.angle));
        if (setup.motion != Motion::Static) {
            cpBodySetVelocity(made, toPeer(setup.velocity));
            cpBodySetAngularVelocity(made, static_cast<double>(setup.spin));
        }
        if (setup.drag > 0.0f) {
            drags_.push_back(static_cast<double>(setup.drag));
            cpBodySetUserData(made, &drags_.back());
            cpBodySetVelocityUpdateFunc(made, &dragAlong);
        }
        parts_.push_back({made, {}, {}});
        if (!setup.awake) sleepers_.push_back(body);
    }
    void makeShape(BodyHandle body, const Outline& outline, const Material& material) override {
        if (material.surfaceSpeed != 0.0f || material.oneWay) lacks("belts and one-way shapes");
        const auto radius = static_cast<double>(outline.radius);
        const cpVect first = toPeer(outline.points[0]);
        const cpVect second = toPeer(outline.points[1]);
        switch (outline.kind) {
            case OutlineKind::Circle: return add(body, cpCircleShapeNew(at(body), radius, first), material);
            case OutlineKind::Capsule:
            case OutlineKind::Segment:
            case OutlineKind::ChainSegment:
                return add(body, cpSegmentShapeNew(at(body), first, second, radius), material);
            case OutlineKind::Box:
            case OutlineKind::Polygon: {
                cpVect points[8];
                for (std::size_t i = 0; i < outline.count; ++i) points[i] = toPeer(outline.points[i]);
                return add(body, cpPolyShapeNewRaw(at(body), outline.count, points, radius), material);
            }
        }
    }
    void makeLoop(BodyHandle body, std::span<const Vec2> points, const Material& material) override {
        const auto point = [points](std::size_t i) { return toPeer(points[i % points.size()]); };
        for (std::size_t i = 0; i < points.size(); ++i) {
            cpShape* shape = cpSegmentShapeNew(at(body), point(i), point(i + 1), 0.0);
            cpSegmentShapeSetNeighbors(shape, point(i + points.size() - 1), point(i + 2));
            add(body, shape, material);
        }
    }
    void makeJoint(const JointSetup& hinge) override {
        if (hinge.kind != JointKind::Hinge) return lacks("joints other than hinges");
        cpBody* a = at(hinge.a);
        cpBody* b = at(hinge.b);
        // Chipmunk would abort the program if neither body is dynamic.
        if (!isDynamic(hinge.a) && !isDynamic(hinge.b)) return;
        const auto reference = static_cast<double>(hinge.reference);
        join(hinge, cpPivotJointNew2(a, b, toPeer(hinge.anchorA), toPeer(hinge.anchorB)));
        if (hinge.limited)
            join(hinge, cpRotaryLimitJointNew(a, b, reference + static_cast<double>(hinge.lower),
                                              reference + static_cast<double>(hinge.upper)));
        if (hinge.driven) {
            cpConstraint* motor = cpSimpleMotorNew(a, b, -static_cast<double>(hinge.speed));
            cpConstraintSetMaxForce(motor, static_cast<double>(hinge.maxForce));
            join(hinge, motor);
        }
        if (hinge.sprung) {
            const double rate = static_cast<double>(kTau * hinge.hertz);
            const double inertia = 1.0 / (1.0 / cpBodyGetMoment(a) + 1.0 / cpBodyGetMoment(b));
            join(hinge,
                 cpDampedRotarySpringNew(a, b, -reference, inertia * rate * rate,
                                         2.0 * static_cast<double>(hinge.dampingRatio) * inertia * rate));
        }
    }
    void dropBody(BodyHandle body) override {
        Parts& parts = parts_[body.index];
        if (parts.body == nullptr) return;
        for (cpConstraint* constraint : parts.constraints) {
            if (!cpSpaceContainsConstraint(space_, constraint)) continue;
            cpSpaceRemoveConstraint(space_, constraint);
            retired_.push_back(constraint);
        }
        for (cpShape* shape : parts.shapes) {
            cpSpaceRemoveShape(space_, shape);
            cpShapeFree(shape);
        }
        cpSpaceRemoveBody(space_, parts.body);
        cpBodyFree(parts.body);
        parts = {};
    }

private:
    struct Parts {
        cpBody* body = nullptr;
        std::vector<cpShape*> shapes;
        std::vector<cpConstraint*> constraints;  ///< also stored for the other body
    };

    [[nodiscard]] cpBody* at(BodyHandle body) const { return parts_[body.index].body; }
    void add(BodyHandle body, cpShape* shape, const Material& material) {
        if (isDynamic(body)) cpShapeSetDensity(shape, static_cast<double>(material.density));
        // Chipmunk multiplies the friction of two shapes; the scenes expect the square root of the product.
        cpShapeSetFriction(shape, std::sqrt(static_cast<double>(material.friction)));
        cpShapeSetElasticity(shape, std::sqrt(static_cast<double>(material.bounciness)));
        // Chipmunk's groups only prevent collisions, like negative groups in the scenes.
        cpShapeSetFilter(shape, {static_cast<cpGroup>(-material.group), material.layers, material.mask});
        cpSpaceAddShape(space_, shape);
        parts_[body.index].shapes.push_back(shape);
    }
    void join(const JointSetup& hinge, cpConstraint* constraint) {
        cpConstraintSetCollideBodies(constraint, cpFalse);
        cpSpaceAddConstraint(space_, constraint);
        parts_[hinge.a.index].constraints.push_back(constraint);
        parts_[hinge.b.index].constraints.push_back(constraint);
    }

    cpSpace* space_;
    std::vector<Parts> parts_;
    std::deque<double> drags_;
    std::vector<BodyHandle> sleepers_;
    std::vector<cpConstraint*> retired_;  ///< removed from the space, but still referenced by a body
};

}  // namespace

Engine chipmunkEngine() {
    return {.name = "chipmunk-7", .open = [](const WorldSetup& setup) -> std::unique_ptr<SceneBuilder> {
                return std::make_unique<ChipmunkWorld>(setup);
            }};
}

}  // namespace plumb::scenes
