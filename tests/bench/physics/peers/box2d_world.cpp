#include <box2d/box2d.h>

#include "tests/bench/physics/peers/peers.hpp"

namespace plumb::scenes {

namespace {

constexpr int kVelocityIterations = 8;
constexpr int kPositionIterations = 3;

b2Vec2 toPeer(Vec2 v) { return {v.x, v.y}; }

b2BodyType typeOf(Motion motion) {
    switch (motion) {
        case Motion::Static: return b2_staticBody;
        case Motion::Kinematic: return b2_kinematicBody;
        case Motion::Dynamic: break;
    }
    return b2_dynamicBody;
}

/// Sums of Box2D's profile over all steps, ms.
struct Totals {
    double collide = 0.0;
    double solve = 0.0;
    double swept = 0.0;
    double pairs = 0.0;
    int steps = 0;

    void add(const b2Profile& profile) {
        collide += static_cast<double>(profile.collide);
        solve += static_cast<double>(profile.solve - profile.broadphase);
        swept += static_cast<double>(profile.solveTOI);
        pairs += static_cast<double>(profile.broadphase);
        ++steps;
    }
};

class Box2dWorld final : public SceneBuilder {
public:
    Box2dWorld(const WorldSetup& setup, bool swept)
        : world_{toPeer(setup.gravity)},
          origin_{static_cast<float>(setup.originX), static_cast<float>(setup.originY)} {
        world_.SetAllowSleeping(setup.sleeping);
        world_.SetContinuousPhysics(swept);
    }

    void moveTo(BodyHandle body, Vec2 position, float angle, float dt) override {
        at(body)->SetLinearVelocity((1.0f / dt) * (origin_ + toPeer(position) - at(body)->GetPosition()));
        at(body)->SetAngularVelocity((angle - at(body)->GetAngle()) / dt);
    }
    void setSpin(BodyHandle body, float spin) override { at(body)->SetAngularVelocity(spin); }
    void setMass(BodyHandle body, float kilograms) override {
        b2MassData mass;
        at(body)->GetMassData(&mass);
        mass.I *= kilograms / mass.mass;
        mass.mass = kilograms;
        at(body)->SetMassData(&mass);
    }
    void setVelocity(BodyHandle body, Vec2 velocity) override {
        at(body)->SetLinearVelocity(toPeer(velocity));
    }
    void setPosition(BodyHandle body, Vec2 position, float angle) override {
        at(body)->SetTransform(origin_ + toPeer(position), angle);
        at(body)->SetAwake(true);
    }
    void step(float dt) override {
        world_.Step(dt, kVelocityIterations, kPositionIterations);
        totals_.add(world_.GetProfile());
    }

    [[nodiscard]] Pose poseOf(BodyHandle body) const override {
        const b2Transform& frame = at(body)->GetTransform();
        const b2Vec2 position = frame.p - origin_;
        return {static_cast<double>(position.x), static_cast<double>(position.y),
                static_cast<double>(frame.q.c), static_cast<double>(frame.q.s)};
    }
    [[nodiscard]] Vec2 velocityOf(BodyHandle body) const override {
        const b2Vec2 velocity = at(body)->GetLinearVelocity();
        return {velocity.x, velocity.y};
    }
    [[nodiscard]] float spinOf(BodyHandle body) const override { return at(body)->GetAngularVelocity(); }
    [[nodiscard]] std::size_t contactCount() const override {
        return static_cast<std::size_t>(world_.GetContactCount());
    }
    [[nodiscard]] std::vector<Profile::Zone> stages() const override {
        constexpr double kMs = 1e-3;
        return {{"pairs", kMs * totals_.pairs, totals_.steps},
                {"narrow", kMs * totals_.collide, totals_.steps},
                {"solve", kMs * totals_.solve, totals_.steps},
                {"swept", kMs * totals_.swept, totals_.steps}};
    }

protected:
    void makeBody(BodyHandle /*body*/, const BodySetup& setup) override {
        b2BodyDef definition;
        definition.type = typeOf(setup.motion);
        definition.position = origin_ + toPeer(setup.position);
        definition.angle = setup.angle;
        definition.linearVelocity = toPeer(setup.velocity);
        definition.angularVelocity = setup.spin;
        definition.linearDamping = setup.drag;
        definition.allowSleep = setup.canSleep;
        definition.awake = setup.awake;
        definition.bullet = setup.bullet;
        definition.fixedRotation = setup.fixedRotation;
        definition.gravityScale = setup.gravityScale;
        bodies_.push_back(world_.CreateBody(&definition));
    }
    void makeShape(BodyHandle body, const Outline& outline, const Material& material) override {
        if (material.surfaceSpeed != 0.0f || material.oneWay) lacks("belts and one-way shapes");
        switch (outline.kind) {
            case OutlineKind::Circle: {
                b2CircleShape shape;
                shape.m_radius = outline.radius;
                shape.m_p = toPeer(outline.points[0]);
                return add(body, shape, material);
            }
            case OutlineKind::Segment: {
                b2EdgeShape shape;
                shape.SetTwoSided(toPeer(outline.points[0]), toPeer(outline.points[1]));
                return add(body, shape, material);
            }
            case OutlineKind::Box:
            case OutlineKind::Polygon: {
                if (outline.radius > 0.0f) return lacks("round corners");
                b2Vec2 points[b2_maxPolygonVertices];
                for (std::size_t i = 0; i < outline.count; ++i) points[i] = toPeer(outline.points[i]);
                b2PolygonShape shape;
                shape.Set(points, outline.count);
                return add(body, shape, material);
            }
            case OutlineKind::Capsule:
            case OutlineKind::ChainSegment: return lacks("capsules");
        }
    }
    void makeLoop(BodyHandle body, std::span<const Vec2> points, const Material& material) override {
        std::vector<b2Vec2> vertices;
        for (const Vec2 point : points) vertices.push_back(toPeer(point));
        b2ChainShape shape;
        shape.CreateLoop(vertices.data(), static_cast<int32>(vertices.size()));
        add(body, shape, material);
    }
    void makeJoint(const JointSetup& joint) override {
        switch (joint.kind) {
            case JointKind::Hinge: return makeHinge(joint);
            case JointKind::Slider: return makeSlider(joint);
            case JointKind::Rod: return makeRod(joint);
            case JointKind::Wheel: return makeWheel(joint);
            case JointKind::Weld: return makeWeld(joint);
        }
    }
    void dropBody(BodyHandle body) override { world_.DestroyBody(at(body)); }

private:
    template <class Definition>
    void join(Definition& definition, const JointSetup& joint) {
        definition.bodyA = at(joint.a);
        definition.bodyB = at(joint.b);
        definition.localAnchorA = toPeer(joint.anchorA);
        definition.localAnchorB = toPeer(joint.anchorB);
        world_.CreateJoint(&definition);
    }
    void makeHinge(const JointSetup& joint) {
        if (joint.sprung) return lacks("springs in hinges");
        b2RevoluteJointDef definition;
        definition.referenceAngle = joint.reference;
        definition.enableLimit = joint.limited;
        definition.lowerAngle = joint.lower;
        definition.upperAngle = joint.upper;
        definition.enableMotor = joint.driven;
        definition.motorSpeed = joint.speed;
        definition.maxMotorTorque = joint.maxForce;
        join(definition, joint);
    }
    void makeSlider(const JointSetup& joint) {
        if (joint.sprung) return lacks("springs in sliders");
        b2PrismaticJointDef definition;
        definition.localAxisA = toPeer(joint.axis);
        definition.referenceAngle = joint.reference;
        definition.enableLimit = joint.limited;
        definition.lowerTranslation = joint.lower;
        definition.upperTranslation = joint.upper;
        definition.enableMotor = joint.driven;
        definition.motorSpeed = joint.speed;
        definition.maxMotorForce = joint.maxForce;
        join(definition, joint);
    }
    void makeRod(const JointSetup& joint) {
        b2DistanceJointDef definition;
        definition.length = joint.length;
        definition.minLength = joint.sprung ? 0.0f : joint.length;
        definition.maxLength = joint.sprung ? b2_maxFloat : joint.length;
        if (joint.sprung)
            b2LinearStiffness(definition.stiffness, definition.damping, joint.hertz, joint.dampingRatio,
                              at(joint.a), at(joint.b));
        join(definition, joint);
    }
    void makeWheel(const JointSetup& joint) {
        b2WheelJointDef definition;
        definition.localAxisA = toPeer(joint.axis);
        definition.enableMotor = joint.driven;
        definition.motorSpeed = joint.speed;
        definition.maxMotorTorque = joint.maxForce;
        b2LinearStiffness(definition.stiffness, definition.damping, joint.hertz, joint.dampingRatio,
                          at(joint.a), at(joint.b));
        join(definition, joint);
    }
    void makeWeld(const JointSetup& joint) {
        b2WeldJointDef definition;
        definition.referenceAngle = joint.reference;
        join(definition, joint);
    }

    [[nodiscard]] b2Body* at(BodyHandle body) const { return bodies_[body.index]; }
    void add(BodyHandle body, const b2Shape& shape, const Material& material) {
        b2FixtureDef definition;
        definition.shape = &shape;
        definition.density = material.density;
        definition.friction = material.friction;
        definition.restitution = material.bounciness;
        definition.filter.categoryBits = static_cast<uint16>(material.layers);
        definition.filter.maskBits = static_cast<uint16>(material.mask);
        definition.filter.groupIndex = static_cast<int16>(material.group);
        at(body)->CreateFixture(&definition);
    }

    b2World world_;
    b2Vec2 origin_;
    std::vector<b2Body*> bodies_;
    Totals totals_;
};

template <bool kSwept>
std::unique_ptr<SceneBuilder> open(const WorldSetup& setup) {
    return std::make_unique<Box2dWorld>(setup, kSwept);
}

}  // namespace

Engine box2dEngine() { return {.name = "box2d-2.4", .open = &open<true>}; }
Engine box2dUnsweptEngine() { return {.name = "box2d-2.4-unswept", .open = &open<false>}; }

}  // namespace plumb::scenes
