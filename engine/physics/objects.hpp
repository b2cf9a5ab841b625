#pragma once

#include <concepts>
#include <memory>
#include <utility>
#include <vector>

#include "physics/pair_set.hpp"
#include "physics/simulation.hpp"

namespace plumb::physics {

// The library as objects, for those who come from other engines: bodies that move, colliders that touch, and
// virtual functions that are called when they do. Everything is owned by a Physics; who wants more than is
// here takes its world() and the functions of bodies.hpp, shapes.hpp and joints.hpp.

class Collider;
class Physics;

/// Something that forces and contacts move. Made by Physics::createBody().
class RigidBody {
public:
    RigidBody(const RigidBody&) = delete;
    RigidBody& operator=(const RigidBody&) = delete;

    [[nodiscard]] BodyId id() const { return id_; }
    [[nodiscard]] Place position() const { return positionOf(world_, id_); }  ///< m
    [[nodiscard]] Rot rotation() const { return rotationOf(world_, id_); }
    [[nodiscard]] Vec2 velocity() const { return velocityOf(world_, id_); }                 ///< m/s
    [[nodiscard]] float angularVelocity() const { return angularVelocityOf(world_, id_); }  ///< rad/s
    /// m/s2
    [[nodiscard]] Vec2 acceleration() const { return world_.bodies.driveOf(id_.index).acceleration; }
    [[nodiscard]] float mass() const { return massOf(world_, id_); }  ///< kg
    /// N: what was added since the last update, without gravity and contacts.
    [[nodiscard]] Vec2 netForce() const { return world_.bodies.driveOf(id_.index).force; }
    /// Where it would be after dt (s) if nothing got in its way.
    [[nodiscard]] Frame predictTransform(float dt) const {
        return physics::predictTransform(world_, id_, dt);
    }

    // All refuse what is not finite, and change nothing then.
    Result<Done> setPosition(Place position);               ///< m; a jump that keeps its angle
    Result<Done> setPosition(Place position, float angle);  ///< m, rad
    Result<Done> setVelocity(Vec2 velocity) { return physics::setVelocity(world_, id_, velocity); }
    Result<Done> setAngularVelocity(float velocity) {
        return physics::setAngularVelocity(world_, id_, velocity);
    }
    Result<Done> setAcceleration(Vec2 acceleration) {
        return physics::setAcceleration(world_, id_, acceleration);
    }
    Result<Done> setMass(float mass) { return physics::setMass(world_, id_, mass); }  ///< kg
    Result<Done> addForce(Vec2 force) { return applyForce(world_, id_, force); }      ///< N, for one update
    void useGravity(bool on) { static_cast<void>(setGravityScale(world_, id_, on ? 1.0f : 0.0f)); }
    void constrainRotation(bool on) { setFixedRotation(world_, id_, on); }

private:
    friend class Physics;
    RigidBody(World& world, BodyId id) : world_{world}, id_{id} {}

    World& world_;
    BodyId id_;
    std::vector<Collider*> colliders_;
};

struct ColliderSettings {
    Vec2 centre{};  ///< m, in the frame of its body, or from `position` of a static object
    float bounciness = 0.0f;
    float friction = 0.6f;
    float density = 1.0f;    ///< kg/m2
    bool isTrigger = false;  ///< overlaps instead of repelling
    Place position{};        ///< m: where a collider without a body is
    float angle = 0.0f;      ///< rad: of one without a body
};

/// What touches. One with a body moves with it, one without is a static object. Derive from its kinds to be
/// told of collisions, and make them by Physics::create().
class Collider {
public:
    virtual ~Collider() = default;
    Collider(const Collider&) = delete;
    Collider& operator=(const Collider&) = delete;

    // Called after the step, with triggers too. They may create and destroy whatever they like, themselves
    // too: what is destroyed hears nothing more, and stays in memory to the end of the next update. Nobody is
    // told to stay while both sleep.
    virtual void onCollisionEnter(Collider* other) { static_cast<void>(other); }
    virtual void onCollisionStay(Collider* other) { static_cast<void>(other); }
    virtual void onCollisionExit(Collider* other) { static_cast<void>(other); }

    [[nodiscard]] const ColliderSettings& settings() const { return settings_; }
    [[nodiscard]] RigidBody* body() const { return body_; }  ///< none for a static object
    [[nodiscard]] ShapeId shape() const { return shape_; }
    [[nodiscard]] bool destroyed() const { return destroyed_; }

protected:
    Collider(const Geometry& geometry, const ColliderSettings& settings)
        : geometry_{geometry}, settings_{settings} {}

private:
    friend class Physics;

    Geometry geometry_;
    ColliderSettings settings_;
    RigidBody* body_ = nullptr;
    BodyId own_;  // of a static object
    ShapeId shape_;
    bool destroyed_ = false;
};

class CircleCollider : public Collider {
public:
    /// @param radius  m
    explicit CircleCollider(float radius, const ColliderSettings& settings = {})
        : Collider{circle(radius, settings.centre), settings} {}
};
using SphereCollider = CircleCollider;

class BoxCollider : public Collider {
public:
    /// @param extents  m: half its size
    explicit BoxCollider(Vec2 extents, const ColliderSettings& settings = {})
        : Collider{box(extents, settings.centre), settings} {}
};

/// A world of bodies and colliders.
class Physics {
public:
    Physics();
    ~Physics();
    Physics(const Physics&) = delete;
    Physics& operator=(const Physics&) = delete;

    /// @error a number that is not finite
    Result<RigidBody*> createBody(Place position, float angle = 0.0f);
    /// One of any kind, e.g. a kinematic one that moves by its velocity and is pushed by nobody.
    Result<RigidBody*> createBody(const BodyDefinition& definition);

    /// Makes a collider of a class of one's own or of the library's, from its constructor's arguments.
    /// @param body  that it moves with; none for a static object
    /// @error a size that is not positive, a number that is not finite, a body of another Physics
    template <std::derived_from<Collider> Kind, class... Arguments>
    Result<Kind*> create(RigidBody* body,
                         Arguments&&... arguments) requires std::constructible_from<Kind, Arguments...> {
        auto made = std::make_unique<Kind>(std::forward<Arguments>(arguments)...);
        Kind* const kind = made.get();
        const Result<Done> added = add(std::move(made), body);
        if (!added) return added.error();
        return kind;
    }

    /// The same of a class that is made from its size and its settings, which may then be written in braces.
    template <std::derived_from<Collider> Kind, class Size>
    Result<Kind*> create(RigidBody* body, Size&& size, const ColliderSettings& settings) requires
        std::constructible_from<Kind, Size, const ColliderSettings&> {
        return create<Kind, Size, const ColliderSettings&>(body, std::forward<Size>(size), settings);
    }

    /// Removes a body with its colliders. Those who touched it hear of it in the next update. What is in
    /// another Physics, or in none, is left alone.
    void destroy(RigidBody& body);
    void destroy(Collider& collider);

    /// Moves everything on by dt (s), then calls the colliders. Time that is not finite or not above 0 does
    /// not pass: nobody moves and nobody is called. Nor does any when a collider that is called asks for it.
    /// @param options  threads to share the work with, where to measure, who may touch whom
    void update(float dt, const StepOptions& options = {});

    /// True while both touch, as of the last update. Takes the same time however many touch.
    [[nodiscard]] bool isTouching(const Collider& a, const Collider& b) const;

    /// Whose a shape is, e.g. of what a query hit; null for one that is gone.
    [[nodiscard]] Collider* colliderOf(ShapeId shape) const { return find(shape); }
    /// For everything that has no object here: joints, queries, fields, …
    [[nodiscard]] World& world() { return world_; }

private:
    /// What one event tells.
    struct Call {
        Collider* a;
        Collider* b;
        ContactPhase phase;
    };

    Result<Done> add(std::unique_ptr<Collider> collider, RigidBody* body);
    [[nodiscard]] Collider* find(ShapeId shape) const;
    [[nodiscard]] bool has(const Collider& collider) const;
    void collectCalls();
    void call(const Call& now);
    static void tell(Collider& to, Collider& other, ContactPhase phase);

    World world_;
    std::vector<std::unique_ptr<RigidBody>> bodies_;      // by BodyId::index
    std::vector<std::unique_ptr<Collider>> colliders_;    // by ShapeId::index
    std::vector<std::unique_ptr<Collider>> leaving_;      // destroyed since the last update
    std::vector<std::unique_ptr<Collider>> gone_;         // before it
    std::vector<std::unique_ptr<RigidBody>> goneBodies_;  // destroyed since the last update
    std::vector<Call> calls_;
    PairSet touching_;
    bool isUpdating_ = false;
};

}  // namespace plumb::physics
