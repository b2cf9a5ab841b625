#include "box_physics/world.hpp"

#include <cmath>

#include "core/assert.hpp"
#include "core/hash.hpp"
#include "core/text.hpp"

namespace plumb::box_physics {

namespace {

constexpr float kLargest = 1e7f;  // m, m/s, m/s2, kg: past it single precision has no use left

Error refused(std::string_view what, std::string_view remedy) {
    return {"physics body", std::string{what}, std::string{remedy}};
}

bool isUsable(Vec2 v) { return std::abs(v.x) <= kLargest && std::abs(v.y) <= kLargest; }  // false for NaN

Result<Done> checkVector(Vec2 v, std::string_view name) {
    if (isUsable(v)) return Done{};
    return refused(format("{} ({}, {}) is not a usable number", name, v.x, v.y),
                   "give finite numbers of at most 1e7");
}

Result<Done> checkMass(float mass) {
    if (mass >= 1e-6f && mass <= kLargest) return Done{};
    return refused(format("mass {} is not usable", mass), "give a mass from 1e-6 to 1e7 kg");
}

Result<Done> checkShape(const Shape& shape) {
    const Vec2 h = shape.half;
    if (h.x > 0.0f && h.y > 0.0f && isUsable(h) && isUsable(shape.centre)) return Done{};
    return refused(format("half size ({}, {}) is not usable", h.x, h.y),
                   "give a size above 0, at most 1e7 m");
}

Result<Done> checkSurface(float friction, float bounciness, float gravityScale) {
    const bool good = std::abs(friction) <= kLargest && bounciness >= 0.0f && bounciness <= 1.0f &&
                      std::abs(gravityScale) <= kLargest;
    if (good) return Done{};
    return refused(format("friction {}, bounciness {}, gravity scale {}", friction, bounciness, gravityScale),
                   "give finite numbers, bounciness 0..1");
}

Result<Done> check(const BodyDefinition& d) {
    if (auto r = checkVector(d.position, "position"); !r) return r;
    if (auto r = checkVector(d.velocity, "velocity"); !r) return r;
    if (auto r = checkVector(d.acceleration, "acceleration"); !r) return r;
    if (auto r = checkShape(d.shape); !r) return r;
    if (auto r = checkSurface(d.friction, d.bounciness, d.gravityScale); !r) return r;
    return checkMass(d.mass);
}

std::uint32_t freshPlace(World& world) {
    Bodies& b = world.bodies;
    if (!world.freePlaces.empty()) {
        const std::uint32_t place = world.freePlaces.back();
        world.freePlaces.pop_back();
        return place;
    }
    const auto place = static_cast<std::uint32_t>(b.size());
    const std::size_t count = b.size() + 1;
    b.generation.resize(count), b.kind.resize(count), b.flags.resize(count), b.shape.resize(count);
    b.position.resize(count), b.velocity.resize(count), b.acceleration.resize(count), b.target.resize(count);
    b.inverseMass.resize(count), b.gravityScale.resize(count), b.friction.resize(count);
    b.bounciness.resize(count), b.layers.resize(count), b.mask.resize(count), b.user.resize(count);
    return place;
}

std::uint8_t flagBits(bool isTrigger, bool oneWay) {
    return static_cast<std::uint8_t>((isTrigger ? kTrigger : 0) | (oneWay ? kOneWay : 0));
}

void noteChange(World& world, BodyId body) {
    PLUMB_ASSERT(alive(world, body), "this physics body is gone; ask alive() first");
    if (world.bodies.kind[body.index] == BodyKind::Static) world.work.fixedGridStale = true;
}

}  // namespace

bool alive(const World& world, BodyId body) {
    return body && body.index < world.bodies.size() &&
           world.bodies.generation[body.index] == body.generation &&
           world.bodies.kind[body.index] != BodyKind::None;
}

std::size_t bodyCount(const World& world) { return world.bodies.size() - world.freePlaces.size(); }

Result<BodyId> createBody(World& world, const BodyDefinition& d) {
    if (auto good = check(d); !good) return good.error();
    const std::uint32_t i = freshPlace(world);
    Bodies& b = world.bodies;
    ++b.generation[i];
    b.kind[i] = d.kind;
    b.flags[i] = flagBits(d.isTrigger, d.oneWay);
    b.shape[i] = d.shape;
    b.position[i] = b.target[i] = d.position;
    b.velocity[i] = d.velocity;
    b.acceleration[i] = d.acceleration;
    b.inverseMass[i] = d.kind == BodyKind::Dynamic ? 1.0f / d.mass : 0.0f;
    b.gravityScale[i] = d.gravityScale;
    b.friction[i] = d.friction;
    b.bounciness[i] = d.bounciness;
    b.layers[i] = d.layers;
    b.mask[i] = d.mask;
    b.user[i] = d.user;
    if (d.kind == BodyKind::Static) world.work.fixedGridStale = true;
    return BodyId{i, b.generation[i]};
}

void destroyBody(World& world, BodyId body) {
    if (!alive(world, body)) return;
    noteChange(world, body);
    world.bodies.kind[body.index] = BodyKind::None;
    world.bodies.flags[body.index] = 0;
    world.freePlaces.push_back(body.index);
}

std::uint32_t addField(World& world, std::shared_ptr<const TileField> field) {
    for (std::uint32_t i = 0; i < world.fields.size(); ++i) {
        if (world.fields[i] == nullptr) return world.fields[i] = std::move(field), i;
    }
    world.fields.push_back(std::move(field));
    return static_cast<std::uint32_t>(world.fields.size() - 1);
}

void replaceField(World& world, std::uint32_t number, std::shared_ptr<const TileField> field) {
    world.fields[number] = std::move(field);
    world.work.fixedGridStale = true;
}

Shape shapeOfField(const World& world, std::uint32_t number) {
    const TileField& field = *world.fields[number];
    const Vec2 size{static_cast<float>(field.width()) * field.cellSize().x,
                    static_cast<float>(field.height()) * field.cellSize().y};
    return {ShapeKind::Tiles, size * 0.5f, size * 0.5f, number};
}

Result<Done> setPosition(World& world, BodyId body, Vec2 position) {
    noteChange(world, body);
    if (auto good = checkVector(position, "position"); !good) return good;
    world.bodies.position[body.index] = position;
    return Done{};
}

Result<Done> setVelocity(World& world, BodyId body, Vec2 velocity) {
    PLUMB_ASSERT(alive(world, body), "this physics body is gone; ask alive() first");
    if (auto good = checkVector(velocity, "velocity"); !good) return good;
    world.bodies.velocity[body.index] = velocity;
    return Done{};
}

Result<Done> setAcceleration(World& world, BodyId body, Vec2 acceleration) {
    PLUMB_ASSERT(alive(world, body), "this physics body is gone; ask alive() first");
    if (auto good = checkVector(acceleration, "acceleration"); !good) return good;
    world.bodies.acceleration[body.index] = acceleration;
    return Done{};
}

Result<Done> moveTo(World& world, BodyId body, Vec2 target) {
    PLUMB_ASSERT(alive(world, body), "this physics body is gone; ask alive() first");
    if (auto good = checkVector(target, "target"); !good) return good;
    world.bodies.target[body.index] = target;
    world.bodies.flags[body.index] |= kHasTarget;
    return Done{};
}

Result<Done> setShape(World& world, BodyId body, const Shape& shape) {
    noteChange(world, body);
    if (auto good = checkShape(shape); !good) return good;
    world.bodies.shape[body.index] = shape;
    return Done{};
}

Result<Done> setMass(World& world, BodyId body, float mass) {
    noteChange(world, body);
    if (auto good = checkMass(mass); !good) return good;
    const bool dynamic = world.bodies.kind[body.index] == BodyKind::Dynamic;
    world.bodies.inverseMass[body.index] = dynamic ? 1.0f / mass : 0.0f;
    return Done{};
}

Result<Done> setSurface(World& world, BodyId body, float friction, float bounciness, float gravityScale) {
    PLUMB_ASSERT(alive(world, body), "this physics body is gone; ask alive() first");
    if (auto good = checkSurface(friction, bounciness, gravityScale); !good) return good;
    world.bodies.friction[body.index] = friction;
    world.bodies.bounciness[body.index] = bounciness;
    world.bodies.gravityScale[body.index] = gravityScale;
    return Done{};
}

void setFilter(World& world, BodyId body, std::uint32_t layers, std::uint32_t mask) {
    PLUMB_ASSERT(alive(world, body), "this physics body is gone; ask alive() first");
    world.bodies.layers[body.index] = layers;
    world.bodies.mask[body.index] = mask;
}

void setFlags(World& world, BodyId body, bool isTrigger, bool oneWay) {
    PLUMB_ASSERT(alive(world, body), "this physics body is gone; ask alive() first");
    std::uint8_t& flags = world.bodies.flags[body.index];
    flags = static_cast<std::uint8_t>((flags & ~(kTrigger | kOneWay)) | flagBits(isTrigger, oneWay));
}

void addTo(Hasher& hasher, const World& world) {
    const Bodies& b = world.bodies;
    const auto addVector = [&hasher](Vec2 v) { hasher.add(v.x), hasher.add(v.y); };
    hasher.add(world.steps);
    for (std::size_t i = 0; i < b.size(); ++i) {
        hasher.add(std::uint64_t{b.generation[i]} << 16 | static_cast<std::uint64_t>(b.kind[i]) << 8 |
                   b.flags[i]);
        if (b.kind[i] == BodyKind::None) continue;
        addVector(b.position[i]), addVector(b.velocity[i]), addVector(b.acceleration[i]);
        addVector(b.shape[i].centre), addVector(b.shape[i].half);
        hasher.add(static_cast<std::uint64_t>(b.shape[i].kind) << 32 | b.shape[i].field);
        hasher.add(b.inverseMass[i]), hasher.add(b.gravityScale[i]);
        hasher.add(b.friction[i]), hasher.add(b.bounciness[i]);
        hasher.add(std::uint64_t{b.layers[i]} << 32 | b.mask[i]);
        if ((b.flags[i] & kHasTarget) != 0) addVector(b.target[i]);
    }
    for (const std::uint32_t place : world.freePlaces) hasher.add(std::uint64_t{place});
    for (const auto& field : world.fields) hasher.add(field != nullptr ? field->contentHash() : 0);
    for (const ContactEvent& pair : world.touching) {
        hasher.add(std::uint64_t{pair.a.index} << 32 | pair.b.index);
        hasher.add(std::uint64_t{pair.a.generation} << 32 | pair.b.generation);
    }
}

std::uint64_t hashOf(const World& world) {
    Hasher hasher;
    addTo(hasher, world);
    return hasher.value();
}

}  // namespace plumb::box_physics
