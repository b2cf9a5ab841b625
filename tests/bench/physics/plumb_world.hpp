#pragma once

#include <vector>

#include "core/task_pool.hpp"
#include "physics/simulation.hpp"
#include "tests/bench/physics/measure.hpp"

namespace plumb::scenes {

/// Returns the physics library of this repository.
Engine plumbEngine();

/// Adapter of the physics library of this repository. world() gives access to its settings.
class PlumbWorld final : public SceneBuilder {
public:
    explicit PlumbWorld(const WorldSetup& setup)
        : origin_{setup.originX, setup.originY}, pool_{setup.threads} {
        world_.settings.gravity = setup.gravity;
        world_.settings.sleeping = setup.sleeping;
        world_.settings.quality = static_cast<physics::Quality>(setup.quality);
        world_.settings.stayEvents = false;
        if (setup.threads > 1) options_.pool = &pool_;
        if (setup.profiled) options_.profile = &profile_;
    }

    void moveTo(BodyHandle body, Vec2 position, float angle, float dt) override {
        static_cast<void>(physics::moveTo(world_, at(body), origin_ + position, angle, dt));
    }
    void setMass(BodyHandle body, float kilograms) override {
        static_cast<void>(physics::setMass(world_, at(body), kilograms));
    }
    void setVelocity(BodyHandle body, Vec2 velocity) override {
        static_cast<void>(physics::setVelocity(world_, at(body), velocity));
    }
    void setSpin(BodyHandle body, float spin) override {
        static_cast<void>(physics::setAngularVelocity(world_, at(body), spin));
    }
    void setPosition(BodyHandle body, Vec2 position, float angle) override {
        static_cast<void>(physics::setPosition(world_, at(body), origin_ + position, angle));
    }
    [[nodiscard]] physics::World& world() { return world_; }
    [[nodiscard]] const physics::World& world() const { return world_; }
    [[nodiscard]] physics::BodyId idOf(BodyHandle body) const { return ids_[body.index]; }
    void step(float dt) override { physics::step(world_, dt, options_); }

    [[nodiscard]] Pose poseOf(BodyHandle body) const override {
        const physics::WorldPosition position = physics::positionOf(world_, at(body));
        const Rot rotation = physics::rotationOf(world_, at(body));
        return {position.x - origin_.x, position.y - origin_.y, static_cast<double>(rotation.cos),
                static_cast<double>(rotation.sin)};
    }
    [[nodiscard]] Vec2 velocityOf(BodyHandle body) const override {
        return physics::velocityOf(world_, at(body));
    }
    [[nodiscard]] float spinOf(BodyHandle body) const override {
        return physics::angularVelocityOf(world_, at(body));
    }
    [[nodiscard]] std::size_t contactCount() const override {
        return world_.contacts.size() + world_.sleepers.contacts.size() - world_.sleepers.freeContacts.size();
    }
    [[nodiscard]] std::vector<Profile::Zone> stages() const override { return profile_.zones(); }

protected:
    void makeBody(BodyHandle /*body*/, const BodySetup& setup) override;
    void makeShape(BodyHandle body, const Outline& outline, const Material& material) override;
    void makeLoop(BodyHandle body, std::span<const Vec2> points, const Material& material) override;
    void makeJoint(const JointSetup& hinge) override;
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
    physics::WorldPosition origin_;
    TaskPool pool_;
    Profile profile_;
    physics::StepOptions options_;
    std::vector<physics::BodyId> ids_;
};

}  // namespace plumb::scenes
