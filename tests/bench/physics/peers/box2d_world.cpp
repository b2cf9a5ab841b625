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

/// Its totals, as the profile of each step gives them in ms.
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
    Box2dWorld(const WorldSetup& setup, bool swept) : world_{toPeer(setup.gravity)} {
        world_.SetAllowSleeping(setup.sleeping);
        world_.SetContinuousPhysics(swept);
    }

    void moveTo(BodyHandle body, Vec2 position, float dt) override {
        at(body)->SetLinearVelocity((1.0f / dt) * (toPeer(position) - at(body)->GetPosition()));
    }
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
    void step(float dt) override {
        world_.Step(dt, kVelocityIterations, kPositionIterations);
        totals_.add(world_.GetProfile());
    }

    [[nodiscard]] Pose poseOf(BodyHandle body) const override {
        const b2Transform& frame = at(body)->GetTransform();
        return {static_cast<double>(frame.p.x), static_cast<double>(frame.p.y),
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
        definition.position = toPeer(setup.position);
        definition.angle = setup.angle;
        definition.linearVelocity = toPeer(setup.velocity);
        definition.angularVelocity = setup.spin;
        definition.linearDamping = setup.drag;
        definition.allowSleep = setup.canSleep;
        definition.awake = setup.awake;
        bodies_.push_back(world_.CreateBody(&definition));
    }
    void makeShape(BodyHandle body, const Outline& outline, const Material& material) override {
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
        std::vector<b2Vec2> places;
        for (const Vec2 point : points) places.push_back(toPeer(point));
        b2ChainShape shape;
        shape.CreateLoop(places.data(), static_cast<int32>(places.size()));
        add(body, shape, material);
    }
    void makeHinge(const Hinge& hinge) override {
        if (hinge.sprung) return lacks("springs in hinges");
        b2RevoluteJointDef definition;
        definition.bodyA = at(hinge.a);
        definition.bodyB = at(hinge.b);
        definition.localAnchorA = toPeer(hinge.anchorA);
        definition.localAnchorB = toPeer(hinge.anchorB);
        definition.referenceAngle = hinge.reference;
        definition.enableLimit = hinge.limited;
        definition.lowerAngle = hinge.lower;
        definition.upperAngle = hinge.upper;
        definition.enableMotor = hinge.driven;
        definition.motorSpeed = hinge.speed;
        definition.maxMotorTorque = hinge.maxTorque;
        world_.CreateJoint(&definition);
    }
    void dropBody(BodyHandle body) override { world_.DestroyBody(at(body)); }

private:
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
