#pragma once


#include "physics/contacts/pair_set.hpp"
#include "physics/simulation.hpp"

namespace plumb::physics {

// Object-oriented interface: rigid bodies, colliders, and virtual functions that are called on collisions. A
// Physics owns all objects; use its world() for features without a class here.

class Collider;
class Physics;

/// A body of a Physics. Created by Physics::createBody().
class RigidBody {
public:
    RigidBody(const RigidBody&) = delete;
    RigidBody& operator=(const RigidBody&) = delete;

    [[nodiscard]] BodyId id() const { return id_; }
    [[nodiscard]] WorldPosition position() const { return positionOf(world_, id_); }  ///< m
    [[nodiscard]] Rot rotation() const { return rotationOf(world_, id_); }
    [[nodiscard]] Vec2 velocity() const { return velocityOf(world_, id_); }                 ///< m/s
    [[nodiscard]] float angularVelocity() const { return angularVelocityOf(world_, id_); }  ///< rad/s
    [[nodiscard]] Vec2 acceleration() const { return driveOf(world_, id_).acceleration; }   ///< m/s2
    [[nodiscard]] float mass() const { return massOf(world_, id_); }                        ///< kg
    /// N: sum of the forces added since the last update, without gravity and contacts.
    [[nodiscard]] Vec2 netForce() const { return driveOf(world_, id_).force; }
    /// Predicts the transform after dt (s) if the body hits no obstacle.
    [[nodiscard]] Frame predictTransform(float dt) const {
        return physics::predictTransform(world_, id_, dt);
    }

    // Setters return an error for values that are not finite, and then change nothing.
    /// m; teleports the body and keeps its angle
    Result<Done> setPosition(WorldPosition position) { return setPosition(position, angleOf(rotation())); }
    Result<Done> setPosition(WorldPosition position, float angle) {  ///< m, rad
        return physics::setPosition(world_, id_, position, angle);
    }
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
    Vec2 centre{};  ///< m, in the body's frame; without a body relative to `position`
    float bounciness = 0.0f;
    float friction = 0.6f;
    float density = 1.0f;      ///< kg/m2
    bool isTrigger = false;    ///< reports overlaps and does not collide
    WorldPosition position{};  ///< m; only for a collider without a body
    float angle = 0.0f;        ///< rad; only for a collider without a body
};

/// A collision shape. It moves with its body; without a body it is static. Derive from its subclasses to
/// receive collision callbacks, and create it with Physics::create().
class Collider {
public:
    virtual ~Collider() = default;
    Collider(const Collider&) = delete;
    Collider& operator=(const Collider&) = delete;

    // Called after the step, for triggers too. Callbacks may create and destroy any objects, including their
    // own collider: a destroyed collider gets no more calls, and stays in memory until the end of the next
    // update. onCollisionStay() is not called while both bodies are asleep.
    virtual void onCollisionEnter(Collider* other) { static_cast<void>(other); }
    virtual void onCollisionStay(Collider* other) { static_cast<void>(other); }
    virtual void onCollisionExit(Collider* other) { static_cast<void>(other); }

    [[nodiscard]] const ColliderSettings& settings() const { return settings_; }
    [[nodiscard]] RigidBody* body() const { return body_; }  ///< null for a static collider
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
    BodyId own_;  // the static body of a collider without a RigidBody
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
    /// @param extents  m: half sizes
    explicit BoxCollider(Vec2 extents, const ColliderSettings& settings = {})
        : Collider{box(extents, settings.centre), settings} {}
};

/// A world of bodies and colliders.
class Physics {
public:
    Physics() { world_.settings.stayEvents = true; }
    Physics(const Physics&) = delete;
    Physics& operator=(const Physics&) = delete;

    /// @error a number that is not finite
    Result<RigidBody*> createBody(WorldPosition position, float angle = 0.0f) {
        return createBody(BodyDefinition{.position = position, .angle = angle});
    }
    /// Creates a body of any kind, e.g. a kinematic body, which moves only by its velocity.
    Result<RigidBody*> createBody(const BodyDefinition& definition);

    /// Creates a collider: CircleCollider, BoxCollider or a class derived from them.
    /// @param body  body with which it moves; null for a static collider
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

    /// Overload that allows a braced list for the settings.
    template <std::derived_from<Collider> Kind, class Size>
    Result<Kind*> create(RigidBody* body, Size&& size, const ColliderSettings& settings) requires
        std::constructible_from<Kind, Size, const ColliderSettings&> {
        return create<Kind, Size, const ColliderSettings&>(body, std::forward<Size>(size), settings);
    }

    /// Destroys a body with its colliders. Colliders that touched them get onCollisionExit() in the next
    /// update. Ignores objects that do not belong to this Physics.
    void destroy(RigidBody& body);
    void destroy(Collider& collider);

    /// Advances the world by dt (s), then calls the colliders' callbacks. Does nothing if dt is not positive
    /// and finite, or when called from a callback.
    /// @param options  threads, profile, filters of contacts
    void update(float dt, const StepOptions& options = {});

    /// True if the two colliders touched in the last update. Takes constant time.
    [[nodiscard]] bool isTouching(const Collider& a, const Collider& b) const {
        return has(a) && has(b) && touching_.has(pairKey(a.shape_.index, b.shape_.index));
    }

    /// Returns the collider of a shape, e.g. of a query's hit; null if it no longer exists.
    [[nodiscard]] Collider* colliderOf(ShapeId shape) const {
        return alive(world_, shape) ? find(shape) : nullptr;
    }
    /// The world, for features without a class here: joints, queries, fields, …
    [[nodiscard]] World& world() { return world_; }

private:
    struct Call {
        Collider* a;
        Collider* b;
        ContactPhase phase;
    };

    Result<Done> add(std::unique_ptr<Collider> collider, RigidBody* body);
    [[nodiscard]] Collider* find(ShapeId shape) const;
    /// False for colliders that are destroyed, were never added, or belong to another Physics.
    [[nodiscard]] bool has(const Collider& collider) const {
        return !collider.destroyed_ && find(collider.shape_) == &collider;
    }
    void call(const Call& now);
    static void tell(Collider& to, Collider& other, ContactPhase phase);

    World world_;
    std::vector<std::unique_ptr<RigidBody>> bodies_;      // indexed by BodyId::index
    std::vector<std::unique_ptr<Collider>> colliders_;    // indexed by ShapeId::index
    std::vector<std::unique_ptr<Collider>> leaving_;      // destroyed since the last update
    std::vector<std::unique_ptr<Collider>> gone_;         // destroyed before the current update
    std::vector<std::unique_ptr<RigidBody>> goneBodies_;  // destroyed since the last update
    std::vector<Call> calls_;
    PairSet touching_;
    bool isUpdating_ = false;
};

}  // namespace plumb::physics
