#include "physics/model/shapes.hpp"

#include <algorithm>
#include <vector>

#include "core/text.hpp"
#include "physics/islands/sleeping.hpp"
#include "physics/model/bodies.hpp"
#include "physics/model/bounds.hpp"
#include "physics/model/checks.hpp"
#include "physics/model/mass.hpp"
#include "physics/model/polygon_store.hpp"
#include "physics/shapes/shape_types.hpp"

namespace plumb::physics {

namespace {

Result<Done> checkDirection(const ShapeDefinition& definition) {
    if (!definition.oneWay || definition.oneWayDirection != Vec2{}) return Done{};
    return wrong("ShapeDefinition.oneWayDirection", "expected a direction, found (0, 0)",
                 "point it out of the solid side, as (0, -1) does where y points down");
}

Result<Done> check(const ShapeDefinition& definition) {
    return firstOf(checkNumber("ShapeDefinition.density", definition.density, 0.0, 1.0e9),
                   checkNumber("ShapeDefinition.friction", definition.friction, 0.0, kRoughest),
                   checkNumber("ShapeDefinition.bounciness", definition.bounciness, 0.0, 1.0),
                   checkNumber("ShapeDefinition.rollingResistance", definition.rollingResistance, 0.0, 100.0),
                   checkNumber("ShapeDefinition.surfaceSpeed", definition.surfaceSpeed, -kFastest, kFastest),
                   checkVector("ShapeDefinition.oneWayDirection", definition.oneWayDirection, kLargest),
                   checkDirection(definition));
}

/// Corners of polygons are not in Shapes::corners before createPolygon() stores them.
Result<Done> check(const Geometry& geometry) {
    if (geometry.kind != ShapeKind::Polygon) return checkGeometry(geometry, {});
    return wrong("createShape", "expected a circle, capsule, box or segment, found a polygon",
                 "use createPolygon for polygons");
}

/// Counts a shape as a user of the effects that it needs.
void callFor(World& world, std::uint32_t shape, int times) {
    const ShapeInfo& info = world.shapes.info[shape];
    const ShapeExtras& extras = world.shapes.extras[info.extras];
    const bool trigger = (info.flags & kTrigger) != 0;
    Manifest& manifest = world.manifest;
    manifest.call(Effect::Triggers, trigger, times);
    manifest.call(Effect::Contacts, !trigger && world.bodies.info[info.body].kind == BodyKind::Dynamic,
                  times);
    manifest.call(Effect::Friction, !trigger && info.friction > 0.0f, times);
    manifest.call(Effect::Restitution, !trigger && info.bounciness > 0.0f, times);
    manifest.call(Effect::Rolling, !trigger && extras.rollingResistance > 0.0f, times);
    manifest.call(Effect::Conveyor, !trigger && extras.surfaceSpeed != 0.0f, times);
    manifest.call(Effect::OneWay, !trigger && (info.flags & kOneWay) != 0, times);
    manifest.call(Effect::ContactEvents, (info.flags & kReportsContacts) != 0, times);
}

std::uint32_t allocateIndex(World& world) {
    Shapes& shapes = world.shapes;
    if (!shapes.free.empty()) {
        const std::uint32_t index = shapes.free.back();
        shapes.free.pop_back();
        return index;
    }
    const std::size_t count = shapes.size() + 1;
    shapes.geometry.resize(count);
    shapes.bounds.resize(count);
    shapes.filter.resize(count);
    shapes.motion.resize(count, ProxyMotion::Gone);
    shapes.info.resize(count);
    return static_cast<std::uint32_t>(count - 1);
}

ShapeInfo infoOf(const ShapeDefinition& definition) {
    ShapeInfo info;
    info.flags =
        static_cast<std::uint8_t>((definition.isTrigger ? kTrigger : 0) | (definition.oneWay ? kOneWay : 0) |
                                  (definition.reportsContacts ? kReportsContacts : 0));
    info.density = definition.density;
    info.friction = definition.friction;
    info.bounciness = definition.bounciness;
    info.user = definition.user;
    info.surface = definition.surface;
    return info;
}

ShapeExtras extrasOf(const ShapeDefinition& definition) {
    ShapeExtras extras;
    extras.rollingResistance = definition.rollingResistance;
    extras.surfaceSpeed = definition.surfaceSpeed;
    if (definition.oneWay) extras.oneWayDirection = normalized(definition.oneWayDirection);
    extras.frontLayers = definition.frontLayers;
    extras.frontMask = definition.frontMask;
    return extras;
}

/// Adds a shape that was checked already. Does not update the body's mass.
ShapeId add(World& world, BodyId body, const Geometry& geometry, const ShapeDefinition& definition) {
    const std::uint32_t index = allocateIndex(world);
    Shapes& shapes = world.shapes;
    BodyInfo& owner = world.bodies.info[body.index];
    ShapeInfo info = infoOf(definition);
    info.generation = shapes.info[index].generation + 1;
    info.body = body.index;
    info.next = std::exchange(owner.firstShape, index);
    const ShapeExtras extras = extrasOf(definition);
    if (!(extras == ShapeExtras{})) shapes.extras.own(info.extras) = extras;
    shapes.info[index] = info;
    shapes.geometry[index] = geometry;
    shapes.filter[index] = {definition.layers, definition.mask, definition.group, body.index};
    shapes.motion[index] = motionOf(world, index);
    callFor(world, index, 1);
    setBounds(world, index);
    return {index, info.generation};
}

/// The index becomes free once the next step has ended the shape's contacts.
void remove(World& world, std::uint32_t shape) {
    Shapes& shapes = world.shapes;
    callFor(world, shape, -1);
    if (shapes.geometry[shape].kind == ShapeKind::Polygon) freePolygon(shapes, shapes.geometry[shape]);
    shapes.extras.release(shapes.info[shape].extras);
    shapes.motion[shape] = ProxyMotion::Gone;
    shapes.dying.push_back(shape);
    noteChanged(world, shape);
}

/// Changes a material property that the shape's effects depend on.
void change(World& world, ShapeId shape, float ShapeInfo::*member, float value) {
    callFor(world, shape.index, -1);
    world.shapes.info[shape.index].*member = value;
    callFor(world, shape.index, 1);
    refreshContacts(world, shape.index);
}

Error stale() {
    return wrong("createShape", "expected a living body, found one that was destroyed or never made",
                 "create the body first and keep its id");
}

}  // namespace

bool alive(const World& world, ShapeId shape) {
    return shape.generation != 0 && shape.index < world.shapes.size() &&
           world.shapes.info[shape.index].generation == shape.generation &&
           world.shapes.motion[shape.index] != ProxyMotion::Gone;
}

BodyId bodyOf(const World& world, ShapeId shape) {
    const std::uint32_t body = world.shapes.info[shape.index].body;
    return {body, world.bodies.info[body].generation};
}

Result<ShapeId> createShape(World& world, BodyId body, const Geometry& geometry,
                            const ShapeDefinition& definition) {
    if (!alive(world, body)) return stale();
    if (const auto checked = firstOf(check(geometry), check(definition)); !checked) return checked.error();
    const ShapeId shape = add(world, body, geometry, definition);
    updateMass(world, body.index);
    return shape;
}

Result<ShapeId> createPolygon(World& world, BodyId body, std::span<const Vec2> points, float radius,
                              const ShapeDefinition& definition) {
    if (!alive(world, body)) return stale();
    if (const auto checked =
            firstOf(check(definition), checkNumber("createPolygon radius", radius, 0.0, kLargest));
        !checked) {
        return checked.error();
    }
    const Result<Hull> hull = makeHull(points);
    if (!hull) return hull.error();
    const ShapeId shape = add(world, body, storePolygon(world.shapes, *hull, radius), definition);
    updateMass(world, body.index);
    return shape;
}

Result<Done> createChain(World& world, BodyId body, std::span<const Vec2> points, bool closed,
                         const ShapeDefinition& definition) {
    if (!alive(world, body)) return stale();
    const std::size_t count = points.size(), fewest = closed ? 3 : 4;
    if (count < fewest) {
        return wrong(
            "createChain",
            "expected at least " + std::to_string(fewest) + " points, found " + std::to_string(count),
            "add points; the first and last point of an open chain are ghost vertices");
    }
    if (const auto checked = check(definition); !checked) return checked;
    const std::size_t segments = closed ? count : count - 3, first = closed ? 0 : 1;
    const auto segmentAt = [&](std::size_t i) {
        const std::size_t at = first + i;
        return chainSegment(points[(at + count - 1) % count], points[at % count], points[(at + 1) % count],
                            points[(at + 2) % count]);
    };
    for (std::size_t i = 0; i < segments; ++i) {
        const Geometry piece = segmentAt(i);
        if (const auto checked = check(piece); !checked) return checked;
    }
    ShapeDefinition part = definition;
    for (std::size_t i = 0; i < segments; ++i) {
        const ShapeId shape = add(world, body, segmentAt(i), part);
        if (part.surface != 0) continue;
        part.surface = kOwnSurfaces | shape.index;
        world.shapes.info[shape.index].surface = part.surface;
    }
    updateMass(world, body.index);
    return Done{};
}

Result<Done> createShapes(World& world, BodyId body, std::span<const Geometry> geometries,
                          std::span<const ShapeDefinition> definitions) {
    if (!alive(world, body)) return stale();
    if (geometries.size() != definitions.size()) {
        return wrong("createShapes",
                     "expected a definition for each of " + std::to_string(geometries.size()) +
                         " outlines, found " + std::to_string(definitions.size()),
                     "pass two lists of the same length");
    }
    for (std::size_t i = 0; i < geometries.size(); ++i) {
        const auto checked = firstOf(check(geometries[i]), check(definitions[i]));
        if (!checked) return checked;
    }
    for (std::size_t i = 0; i < geometries.size(); ++i) add(world, body, geometries[i], definitions[i]);
    updateMass(world, body.index);
    return Done{};
}

void destroyShape(World& world, ShapeId shape) {
    if (!alive(world, shape)) return;
    const std::uint32_t body = world.shapes.info[shape.index].body;
    wakeTouching(world, body);
    std::uint32_t* link = &world.bodies.info[body].firstShape;
    while (*link != shape.index) link = &world.shapes.info[*link].next;
    *link = world.shapes.info[shape.index].next;
    remove(world, shape.index);
    updateMass(world, body);
}

void destroyShapes(World& world, BodyId body) {
    if (!alive(world, body)) return;
    std::uint32_t& first = world.bodies.info[body.index].firstShape;
    if (first == kNone) return;
    wakeTouching(world, body.index);
    for (std::uint32_t shape = std::exchange(first, kNone); shape != kNone;) {
        const std::uint32_t next = world.shapes.info[shape].next;
        remove(world, shape);
        shape = next;
    }
    updateMass(world, body.index);
}

Result<Done> setFriction(World& world, ShapeId shape, float friction) {
    const auto checked = firstOf(checkAlive("setFriction", world, shape),
                                 checkNumber("setFriction", friction, 0.0, kRoughest));
    if (!checked) return checked;
    change(world, shape, &ShapeInfo::friction, friction);
    wakeTouching(world, world.shapes.info[shape.index].body);
    return Done{};
}

Result<Done> setBounciness(World& world, ShapeId shape, float bounciness) {
    const auto checked = firstOf(checkAlive("setBounciness", world, shape),
                                 checkNumber("setBounciness", bounciness, 0.0, 1.0));
    if (!checked) return checked;
    change(world, shape, &ShapeInfo::bounciness, bounciness);
    return Done{};
}

Result<Done> setSurfaceSpeed(World& world, ShapeId shape, float speed) {
    const auto checked = firstOf(checkAlive("setSurfaceSpeed", world, shape),
                                 checkNumber("setSurfaceSpeed", speed, -kFastest, kFastest));
    if (!checked) return checked;
    Shapes& shapes = world.shapes;
    callFor(world, shape.index, -1);
    if (speed != shapes.extrasOf(shape.index).surfaceSpeed)
        shapes.extras.own(shapes.info[shape.index].extras).surfaceSpeed = speed;
    callFor(world, shape.index, 1);
    refreshContacts(world, shape.index);
    wakeTouching(world, world.shapes.info[shape.index].body);
    return Done{};
}

void setFilter(World& world, ShapeId shape, std::uint32_t layers, std::uint32_t mask, std::int32_t group) {
    if (!alive(world, shape)) return;
    Filter& filter = world.shapes.filter[shape.index];
    filter = {layers, mask, group, filter.body};
    world.filtersStale = true;
    wakeTouching(world, world.shapes.info[shape.index].body);
    noteChanged(world, shape.index);
    noteMoved(world, shape.index);
}

}  // namespace plumb::physics
