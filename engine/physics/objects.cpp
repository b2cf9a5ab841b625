#include "physics/objects.hpp"

#include <algorithm>

#include "physics/model/checks.hpp"

namespace plumb::physics {

namespace {

template <class T>
void put(std::vector<std::unique_ptr<T>>& list, std::uint32_t index, std::unique_ptr<T> thing) {
    if (list.size() <= index) list.resize(index + std::size_t{1});
    list[index] = std::move(thing);
}

}  // namespace

Result<RigidBody*> Physics::createBody(const BodyDefinition& definition) {
    const Result<BodyId> made = physics::createBody(world_, definition);
    if (!made) return made.error();
    put(bodies_, made->index, std::unique_ptr<RigidBody>{new RigidBody{world_, *made}});
    return bodies_[made->index].get();
}

Result<Done> Physics::add(std::unique_ptr<Collider> collider, RigidBody* body) {
    const ColliderSettings& settings = collider->settings_;
    if (body != nullptr && &body->world_ != &world_)
        return Error{"Physics::create", "the body belongs to another Physics",
                     "create both with the same Physics"};
    if (body == nullptr) {
        const Result<BodyId> ground = physics::createBody(
            world_, {.kind = BodyKind::Static, .position = settings.position, .angle = settings.angle});
        if (!ground) return ground.error();
        collider->own_ = *ground;
    }
    const BodyId owner = body != nullptr ? body->id_ : collider->own_;
    const Result<ShapeId> shape = createShape(world_, owner, collider->geometry_,
                                              {.density = settings.density,
                                               .friction = settings.friction,
                                               .bounciness = settings.bounciness,
                                               .isTrigger = settings.isTrigger});
    if (!shape) {
        destroyBody(world_, collider->own_);
        return shape.error();
    }
    collider->shape_ = *shape;
    collider->body_ = body;
    if (body != nullptr) body->colliders_.push_back(collider.get());
    put(colliders_, shape->index, std::move(collider));
    return Done{};
}

void Physics::destroy(Collider& collider) {
    if (!has(collider)) return;
    collider.destroyed_ = true;
    destroyShape(world_, collider.shape_);
    destroyBody(world_, collider.own_);
    if (collider.body_ != nullptr) std::erase(collider.body_->colliders_, &collider);
    collider.body_ = nullptr;
    leaving_.push_back(std::move(colliders_[collider.shape_.index]));
}

void Physics::destroy(RigidBody& body) {
    if (&body.world_ != &world_ || !alive(world_, body.id_)) return;
    while (!body.colliders_.empty()) destroy(*body.colliders_.back());
    destroyBody(world_, body.id_);
    goneBodies_.push_back(std::move(bodies_[body.id_.index]));
}

Collider* Physics::find(ShapeId shape) const {
    if (shape.index < colliders_.size()) {
        Collider* const here = colliders_[shape.index].get();
        if (here != nullptr && here->shape_ == shape) return here;
    }
    const auto gone = std::find_if(gone_.begin(), gone_.end(),
                                   [&](const auto& collider) { return collider->shape_ == shape; });
    return gone != gone_.end() ? gone->get() : nullptr;
}

void Physics::tell(Collider& to, Collider& other, ContactPhase phase) {
    if (to.destroyed_) return;
    switch (phase) {
        case ContactPhase::Began: return to.onCollisionEnter(&other);
        case ContactPhase::Stayed: return to.onCollisionStay(&other);
        case ContactPhase::Ended: return to.onCollisionExit(&other);
    }
}

/// Calls both colliders of an event, except those destroyed by an earlier callback. The other
/// colliders get the onCollisionExit() of a destroyed collider in the next update.
void Physics::call(const Call& now) {
    const PairKey pair = pairKey(now.a->shape_.index, now.b->shape_.index);
    if (now.phase == ContactPhase::Ended) {
        if (!touching_.has(pair)) return;
        touching_.remove(pair);
    } else {
        if (now.a->destroyed_ || now.b->destroyed_) return;
        if (now.phase == ContactPhase::Began) touching_.add(pair);
    }
    tell(*now.a, *now.b, now.phase);
    tell(*now.b, *now.a, now.phase);
}

void Physics::update(float dt, const StepOptions& options) {
    if (isUpdating_ || !(std::isfinite(dt) && dt > 0.0f)) return;
    isUpdating_ = true;
    gone_.swap(leaving_);
    goneBodies_.clear();
    step(world_, dt, options);
    calls_.clear();
    for (const ContactEvent& event : world_.events) {
        Collider* const a = find(event.shapeA);
        Collider* const b = find(event.shapeB);
        if (a != nullptr && b != nullptr) calls_.push_back({a, b, event.phase});
    }
    for (const Call& now : calls_) call(now);
    gone_.clear();
    isUpdating_ = false;
}

}  // namespace plumb::physics
