#include "scene/physics/collider_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "physics/shapes/hull.hpp"
#include "reflect/type_name.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/colliders/capsule_collider.hpp"
#include "scene/components/colliders/chain_collider.hpp"
#include "scene/components/colliders/circle_collider.hpp"
#include "scene/components/colliders/polygon_collider.hpp"
#include "scene/components/transform.hpp"
#include "scene/physics/game_errors.hpp"

namespace plumb {

namespace {

using physics::BodyId;
using physics::Geometry;
using physics::ShapeDefinition;

/// Creates the shapes of one collider.
struct ShapeMaker {
    physics::World& bodies;
    BodyId body;
    Vec2 scale;  // scale of the entity
    PixelScale units;
    ShapeDefinition definition;

    [[nodiscard]] Vec2 point(Vec2 pixels) const { return toMetres(pixels, units); }
    Result<Done> add(const Geometry& geometry) const {
        const auto made = physics::createShape(bodies, body, geometry, definition);
        return made ? Result<Done>{Done{}} : Result<Done>{made.error()};
    }
};

Result<Done> make(const ShapeMaker& maker, const BoxCollider& box) {
    const Vec2 size = scaledSize(box.width, box.height, maker.scale);
    const float rounding = std::min(box.rounding, std::max(0.0f, 0.49f * std::min(size.x, size.y)));
    const Vec2 half = size * 0.5f - Vec2{rounding, rounding};
    return maker.add(physics::box(maker.point(half), maker.point(box.offset + size * 0.5f), {},
                                  rounding * maker.units.metres));
}

Result<Done> make(const ShapeMaker& maker, const CircleCollider& circle) {
    const float size = std::max(std::abs(maker.scale.x), std::abs(maker.scale.y));
    return maker.add(physics::circle(circle.radius * size * maker.units.metres, maker.point(circle.offset)));
}

Result<Done> make(const ShapeMaker& maker, const CapsuleCollider& capsule) {
    const Vec2 size = scaledSize(capsule.width, capsule.height, maker.scale);
    const float radius = 0.5f * std::min(size.x, size.y);
    const Vec2 middle = capsule.offset + size * 0.5f;
    const Vec2 arm = size * 0.5f - Vec2{radius, radius};
    const float metres = radius * maker.units.metres;
    if (arm == Vec2{}) return maker.add(physics::circle(metres, maker.point(middle)));
    return maker.add(physics::capsule(maker.point(middle - arm), maker.point(middle + arm), metres));
}

template <class Collider>
std::vector<Vec2> pointsOf(const ShapeMaker& maker, const Collider& collider, Vec2 offset) {
    std::vector<Vec2> points;
    for (const Vec2 point : collider.points)
        points.push_back(maker.point(scaled(point + offset, maker.scale)));
    return points;
}

Result<Done> make(const ShapeMaker& maker, const PolygonCollider& polygon) {
    const auto pieces = physics::decompose(pointsOf(maker, polygon, polygon.offset));
    if (!pieces) return pieces.error();
    for (const physics::Hull& piece : *pieces) {
        std::array<Vec2, physics::kMaxCorners> corners{};
        for (std::size_t i = 0; i < piece.corners.size(); ++i) corners[i] = piece.corners[i].point;
        const auto made =
            physics::createPolygon(maker.bodies, maker.body, std::span{corners}.first(piece.corners.size()),
                                   polygon.rounding * maker.units.metres, maker.definition);
        if (!made) return made.error();
    }
    return Done{};
}

Result<Done> make(const ShapeMaker& maker, const ChainCollider& chain) {
    std::vector<Vec2> points = pointsOf(maker, chain, {});
    if (maker.scale.x * maker.scale.y < 0.0f) std::reverse(points.begin(), points.end());
    const std::size_t count = points.size();
    if (!chain.loop && count >= 2) {  // neighbours beyond the ends, for smooth collision there
        const Vec2 before = 2.0f * points[0] - points[1];
        points.push_back(2.0f * points[count - 1] - points[count - 2]);
        points.insert(points.begin(), before);
    }
    const auto made = physics::createChain(maker.bodies, maker.body, points, chain.loop, maker.definition);
    return made ? Result<Done>{Done{}} : made.error();
}

// Adds the values that a shape is created from to a hash.

void addTo(Hasher& hasher, Vec2 value) { hasher.add(value.x), hasher.add(value.y); }
void addTo(Hasher& hasher, const BoxCollider& box) {
    hasher.add(box.width), hasher.add(box.height), addTo(hasher, box.offset), hasher.add(box.rounding);
}
void addTo(Hasher& hasher, const CircleCollider& circle) {
    hasher.add(circle.radius), addTo(hasher, circle.offset);
}
void addTo(Hasher& hasher, const CapsuleCollider& capsule) {
    hasher.add(capsule.width), hasher.add(capsule.height), addTo(hasher, capsule.offset);
}
void addTo(Hasher& hasher, const PolygonCollider& polygon) {
    for (const Vec2 point : polygon.points) addTo(hasher, point);
    addTo(hasher, polygon.offset), hasher.add(polygon.rounding);
}
void addTo(Hasher& hasher, const ChainCollider& chain) {
    for (const Vec2 point : chain.points) addTo(hasher, point);
    hasher.add(std::uint64_t{chain.loop});
}

/// Functions of a collider type. Its index in kColliders is the `user` data of its shapes.
struct ColliderRow {
    std::string_view name;
    const ColliderSurface* (*find)(const World& world, EntityId entity);
    void (*addTo)(Hasher& hasher, const ColliderSurface& collider);
    Result<Done> (*make)(const ShapeMaker& maker, const ColliderSurface& collider);
    std::uint64_t (*members)(const World& world);
    std::size_t (*count)(const World& world);
    std::uint32_t (*position)(const World& world, EntityId entity);
    void (*forEachChanged)(const World& world, std::uint64_t mark, void (*visit)(void*, EntityId),
                           void* context);
};

template <class Collider>
constexpr ColliderRow colliderRow() {
    ColliderRow row{};
    row.name = shortTypeName<Collider>();
    row.find = [](const World& world, EntityId entity) -> const ColliderSurface* {
        return world.find<Collider>(entity);
    };
    row.addTo = [](Hasher& hasher, const ColliderSurface& collider) {
        addTo(hasher, static_cast<const Collider&>(collider));
    };
    row.make = [](const ShapeMaker& maker, const ColliderSurface& collider) {
        return make(maker, static_cast<const Collider&>(collider));
    };
    row.members = [](const World& world) { return world.memberships<Collider>(); };
    row.count = [](const World& world) { return world.count<Collider>(); };
    row.position = [](const World& world, EntityId entity) { return world.positionOf<Collider>(entity); };
    row.forEachChanged = [](const World& world, std::uint64_t mark, void (*visit)(void*, EntityId),
                            void* context) {
        world.eachChangedSince<Collider>(mark, [&](EntityId entity) { visit(context, entity); });
    };
    return row;
}

constexpr ColliderRow kColliders[] = {
    colliderRow<BoxCollider>(),     colliderRow<CircleCollider>(), colliderRow<CapsuleCollider>(),
    colliderRow<PolygonCollider>(), colliderRow<ChainCollider>(),
};

float frictionOf(const ColliderSurface& surface, const RigidBody* rigid) {
    if (!(surface.friction < 0.0f)) return surface.friction;
    return rigid != nullptr ? rigid->friction : kDefaultFriction;
}

float bouncinessOf(const ColliderSurface& surface, const RigidBody* rigid) {
    if (!(surface.bounciness < 0.0f)) return surface.bounciness;
    return rigid != nullptr ? rigid->bounciness : 0.0f;
}

ShapeDefinition definitionOf(const ColliderSurface& surface, std::uint64_t kind, const RigidBody* rigid,
                             PixelScale units) {
    ShapeDefinition definition;
    definition.density = surface.density;
    definition.friction = frictionOf(surface, rigid);
    definition.bounciness = bouncinessOf(surface, rigid);
    definition.surfaceSpeed = surface.surfaceSpeed * units.metres;
    definition.layers = surface.layers;
    definition.mask = surface.mask;
    definition.isTrigger = surface.isTrigger;
    definition.oneWay = surface.oneWay;
    definition.user = kind;
    return definition;
}

}  // namespace

std::uint64_t outlinesOf(const World& world, EntityId entity, Vec2 scale) {
    Hasher hasher;
    bool any = false;
    for (const ColliderRow& row : kColliders) {
        const ColliderSurface* collider = row.find(world, entity);
        hasher.add(std::uint64_t{collider != nullptr});
        if (collider == nullptr) continue;
        any = true;
        row.addTo(hasher, *collider);
        hasher.add(std::uint64_t{collider->isTrigger} | std::uint64_t{collider->oneWay} << 1);
        hasher.add(collider->density);
    }
    if (!any) return 0;
    addTo(hasher, scale);
    return hasher.value() | 1;
}

Result<Done> makeShapes(physics::World& bodies, BodyId body, const World& world, EntityId entity, Vec2 scale,
                        PixelScale units) {
    physics::destroyShapes(bodies, body);
    const RigidBody* rigid = world.find<RigidBody>(entity);
    Result<Done> result = Done{};
    for (std::size_t kind = 0; kind < std::size(kColliders); ++kind) {
        const ColliderSurface* collider = kColliders[kind].find(world, entity);
        if (collider == nullptr) continue;
        const ShapeMaker maker{bodies, body, scale, units, definitionOf(*collider, kind, rigid, units)};
        if (const Result<Done> made = kColliders[kind].make(maker, *collider); !made)
            result = gameError(made.error(), kColliders[kind].name, units);
    }
    return result;
}

Result<Done> updateSurfaces(physics::World& bodies, BodyId body, const World& world, EntityId entity,
                            const RigidBody* rigid, PixelScale units) {
    Result<Done> result = Done{};
    std::string_view component;
    const auto accept = [&](const Result<Done>& set) {
        if (!set) result = gameError(set.error(), component, units);
    };
    for (std::uint32_t s = bodies.bodies.info[body.index].firstShape; s != physics::kNone;
         s = bodies.shapes.info[s].next) {
        const physics::ShapeInfo& info = bodies.shapes.info[s];
        const ColliderSurface* collider = kColliders[info.user].find(world, entity);
        if (collider == nullptr) continue;
        component = kColliders[info.user].name;
        const ShapeDefinition wanted = definitionOf(*collider, info.user, rigid, units);
        const physics::ShapeId shape{s, info.generation};
        const physics::Filter& filter = bodies.shapes.filter[s];
        if (info.friction != wanted.friction) accept(setFriction(bodies, shape, wanted.friction));
        if (info.bounciness != wanted.bounciness) accept(setBounciness(bodies, shape, wanted.bounciness));
        if (bodies.shapes.extrasOf(s).surfaceSpeed != wanted.surfaceSpeed)
            accept(setSurfaceSpeed(bodies, shape, wanted.surfaceSpeed));
        if (filter.layers != wanted.layers || filter.mask != wanted.mask)
            setFilter(bodies, shape, wanted.layers, wanted.mask, filter.group);
    }
    return result;
}

std::uint64_t colliderMembers(const World& world) {
    std::uint64_t members = 0;
    for (const ColliderRow& row : kColliders) members += row.members(world);
    return members;
}

bool hasColliders(const World& world) {
    return std::any_of(std::begin(kColliders), std::end(kColliders),
                       [&](const ColliderRow& row) { return row.count(world) > 0; });
}

std::uint32_t shapeLayersOf(const World& world, EntityId entity) {
    std::uint32_t layers = 0;
    for (const ColliderRow& row : kColliders) {
        if (const ColliderSurface* collider = row.find(world, entity)) layers |= collider->layers;
    }
    return layers;
}

std::optional<std::uint64_t> colliderOrder(const World& world, EntityId entity) {
    for (std::size_t kind = 0; kind < std::size(kColliders); ++kind) {
        if (kColliders[kind].find(world, entity) == nullptr) continue;
        return std::uint64_t{kind} << 32 | kColliders[kind].position(world, entity);
    }
    return std::nullopt;
}

void forEachChangedCollider(const World& world, std::uint64_t mark, void (*visit)(void*, EntityId),
                            void* context) {
    for (const ColliderRow& row : kColliders) row.forEachChanged(world, mark, visit, context);
}

}  // namespace plumb
