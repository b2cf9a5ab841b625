#include "tests/bench/physics/plumb_world.hpp"

#include "core/task_pool.hpp"
#include "physics/simulation.hpp"

namespace plumb::scenes {

namespace {

physics::BodyKind kindOf(Motion motion) {
    switch (motion) {
        case Motion::Static: return physics::BodyKind::Static;
        case Motion::Kinematic: return physics::BodyKind::Kinematic;
        case Motion::Dynamic: break;
    }
    return physics::BodyKind::Dynamic;
}

physics::ShapeDefinition definitionOf(const Material& material) {
    return {.density = material.density,
            .friction = material.friction,
            .bounciness = material.bounciness,
            .layers = material.layers,
            .mask = material.mask,
            .group = material.group,
            .reportsContacts = material.reports};
}

class PlumbWorld final : public SceneBuilder {
public:
    explicit PlumbWorld(const WorldSetup& setup) : pool_{setup.threads} {
        world_.settings.gravity = setup.gravity;
        world_.settings.sleeping = setup.sleeping;
        world_.settings.stayEvents = false;
        if (setup.threads > 1) options_.pool = &pool_;
        if (setup.profiled) options_.profile = &profile_;
    }

    void moveTo(BodyHandle body, Vec2 position, float dt) override {
        static_cast<void>(physics::moveTo(world_, at(body), position, 0.0f, dt));
    }
    void step(float dt) override { physics::step(world_, dt, options_); }

    [[nodiscard]] Pose poseOf(BodyHandle body) const override {
        const physics::Place place = physics::positionOf(world_, at(body));
        const Rot rotation = physics::rotationOf(world_, at(body));
        return {place.x, place.y, static_cast<double>(rotation.cos), static_cast<double>(rotation.sin)};
    }
    [[nodiscard]] std::size_t contactCount() const override {
        return world_.contacts.size() + world_.sleepers.contacts.size() - world_.sleepers.freeContacts.size();
    }
    [[nodiscard]] std::vector<Profile::Zone> stages() const override { return profile_.zones(); }

protected:
    void makeBody(BodyHandle /*body*/, const BodySetup& setup) override {
        const auto made = physics::createBody(world_, {.kind = kindOf(setup.motion),
                                                       .position = setup.position,
                                                       .velocity = setup.velocity,
                                                       .angularVelocity = setup.spin,
                                                       .linearDrag = setup.drag,
                                                       .sleepSpeed = setup.sleepSpeed,
                                                       .canSleep = setup.canSleep,
                                                       .awake = setup.awake});
        ids_.push_back(made.ok() ? *made : physics::BodyId{});
        if (!made) lacks(made.error().text());
    }
    void makeShape(BodyHandle body, const Outline& outline, const Material& material) override {
        const physics::ShapeDefinition definition = definitionOf(material);
        const auto& points = outline.points;
        switch (outline.kind) {
            case OutlineKind::Circle:
                return add(body, physics::circle(outline.radius, points[0]), definition);
            case OutlineKind::Capsule:
                return add(body, physics::capsule(points[0], points[1], outline.radius), definition);
            case OutlineKind::Box:
                return add(body, physics::box(outline.half, outline.centre, {}, outline.radius), definition);
            case OutlineKind::Segment: return add(body, physics::segment(points[0], points[1]), definition);
            case OutlineKind::Polygon:
            case OutlineKind::ChainSegment:
                return check(
                    physics::createPolygon(world_, at(body), outline.corners(), outline.radius, definition));
        }
    }
    void makeLoop(BodyHandle body, std::span<const Vec2> points, const Material& material) override {
        check(physics::createChain(world_, at(body), points, true, definitionOf(material)));
    }
    void makeHinge(const Hinge& hinge) override {
        if (!isDynamic(hinge.a) && !isDynamic(hinge.b)) return;  // nothing to hold: refused
        check(physics::createJoint(
            world_,
            {.kind = physics::JointKind::Revolute,
             .a = at(hinge.a),
             .b = at(hinge.b),
             .anchorA = hinge.anchorA,
             .anchorB = hinge.anchorB,
             .referenceAngle = hinge.reference,
             .limit = {.on = hinge.limited, .lower = hinge.lower, .upper = hinge.upper},
             .motor = {.on = hinge.driven, .speed = hinge.speed, .maxForce = hinge.maxTorque},
             .spring = {.on = hinge.sprung, .hertz = hinge.hertz, .dampingRatio = hinge.dampingRatio}}));
    }
    void dropBody(BodyHandle body) override { physics::destroyBody(world_, at(body)); }

private:
    [[nodiscard]] physics::BodyId at(BodyHandle body) const { return ids_[body.index]; }
    template <class T>
    void check(const Result<T>& made) {
        if (!made) lacks(made.error().text());
    }
    void add(BodyHandle body, const physics::Geometry& geometry, const physics::ShapeDefinition& definition) {
        check(physics::createShape(world_, at(body), geometry, definition));
    }

    physics::World world_;
    TaskPool pool_;
    Profile profile_;
    physics::StepOptions options_;
    std::vector<physics::BodyId> ids_;
};

}  // namespace

Engine plumbEngine() {
    return {.name = "plumb",
            .maxThreads = 2,
            .profiles = true,
            .open = [](const WorldSetup& setup) -> std::unique_ptr<SceneBuilder> {
                return std::make_unique<PlumbWorld>(setup);
            }};
}

}  // namespace plumb::scenes
