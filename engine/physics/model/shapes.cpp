#include "physics/model/shapes.hpp"

#include <algorithm>
#include <bit>
#include <tuple>

#include "physics/bounds.hpp"
#include "physics/edits.hpp"
#include "physics/islands/sleeping.hpp"
#include "physics/model/bodies.hpp"
#include "physics/model/checks.hpp"
#include "physics/shapes/hull.hpp"
#include "physics/shapes/shape_types.hpp"

namespace plumb::physics {

namespace {

Result<Done> checkDirection(const ShapeDefinition& definition) {
    if (!definition.oneWay || definition.oneWayDirection != Vec2{}) return Done{};
    return usageError(
        "ShapeDefinition.oneWayDirection", "expected a direction, found (0, 0)",
        "use the outward normal of the solid side, e.g. (0, -1) if y points down and the top is solid");
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

/// Checks an outline other than a polygon, whose corners only createPolygon() stores in Shapes::corners.
Result<Done> check(const Geometry& geometry) {
    if (geometry.kind != ShapeKind::Polygon) return checkGeometry(geometry, {});
    return usageError("createShape", "expected a circle, capsule, box or segment, found a polygon",
                      "use createPolygon()");
}

/// Copies the members of a definition that ShapeInfo stores; other members of `info` do not change.
void take(const ShapeDefinition& definition, ShapeInfo& info) {
    info.flags = static_cast<std::uint8_t>(
        (info.flags & (kLeftBounds | kAltered | kShapeOff)) | (definition.isTrigger ? kTrigger : 0) |
        (definition.oneWay ? kOneWay : 0) | (definition.reportsContacts ? kReportsContacts : 0));
    info.density = definition.density;
    info.friction = definition.friction;
    info.bounciness = definition.bounciness;
    info.user = definition.user;
    info.surface = definition.surface;
}

ShapeExtras extrasOf(const ShapeDefinition& definition) {
    return {.rollingResistance = definition.rollingResistance,
            .surfaceSpeed = definition.surfaceSpeed,
            .oneWayDirection = definition.oneWay ? normalized(definition.oneWayDirection) : Vec2{},
            .frontLayers = definition.frontLayers,
            .frontMask = definition.frontMask};
}

/// Adds a shape after all checks. Does not update the body's mass.
ShapeId add(World& world, BodyId body, const Geometry& geometry, const ShapeDefinition& definition) {
    Shapes& shapes = world.shapes;
    const std::uint32_t index =
        takeIndex(shapes.free, shapes.info, shapes.geometry, shapes.bounds, shapes.filter, shapes.motion);
    ShapeInfo info{.generation = shapes.info[index].generation + 1,
                   .body = body.index,
                   .next = std::exchange(world.bodies.info[body.index].firstShape, index)};
    take(definition, info);
    if (!isEnabled(world, body)) info.flags |= kShapeOff;
    const ShapeExtras extras = extrasOf(definition);
    if (!(extras == ShapeExtras{})) shapes.extras.own(info.extras) = extras;
    shapes.info[index] = info;
    shapes.geometry[index] = geometry;
    shapes.filter[index] = {definition.layers, definition.mask, definition.group, body.index};
    shapes.motion[index] = motionOf(world, index);
    countEffectsOfShape(world, index, 1);
    setBounds(world, index);
    return {index, info.generation};
}

/// Returns the size class n of a block of 2^n corners. Free blocks can thus be reused by other polygons.
std::size_t sizeClass(std::size_t corners) {
    return static_cast<std::size_t>(std::bit_width(std::max<std::size_t>(corners, 4) - 1));
}

/// Stores the corners of a hull, if possible in a free block.
Geometry storePolygon(Shapes& shapes, const Hull& hull, float radius) {
    const std::size_t block = sizeClass(hull.corners.size());
    std::vector<std::uint32_t>& free = shapes.freeCorners[block];
    auto first = static_cast<std::uint32_t>(shapes.corners.size());
    if (free.empty()) {
        shapes.corners.resize(first + (std::size_t{1} << block));
    } else {
        first = free.back();
        free.pop_back();
    }
    std::copy(hull.corners.begin(), hull.corners.end(), shapes.corners.begin() + first);
    return polygon(hull, first, radius);
}

void freeCornersOf(Shapes& shapes, std::uint32_t shape) {
    const Geometry& geometry = shapes.geometry[shape];
    if (geometry.kind == ShapeKind::Polygon)
        shapes.freeCorners[sizeClass(geometry.count)].push_back(geometry.first);
}

/// Removes a shape. Its index becomes free after the next step has ended its contacts.
void remove(World& world, std::uint32_t shape) {
    Shapes& shapes = world.shapes;
    countEffectsOfShape(world, shape, -1);
    freeCornersOf(shapes, shape);
    shapes.extras.release(shapes.info[shape].extras);
    shapes.motion[shape] = ProxyMotion::Gone;
    shapes.info[shape].flags &= static_cast<std::uint8_t>(~kShapeOff);
    shapes.dying.push_back(shape);
    noteChanged(world, shape);
}

void replace(World& world, std::uint32_t shape, const Geometry& geometry) {
    const std::uint32_t body = world.shapes.info[shape].body;
    wakeTouching(world, body);
    world.shapes.geometry[shape] = geometry;
    updateMass(world, body);
    alter(world, shape);
}

}  // namespace

void countEffectsOfShape(World& world, std::uint32_t shape, int times) {
    const ShapeInfo& info = world.shapes.info[shape];
    const ShapeExtras& extras = world.shapes.extras[info.extras];
    const bool trigger = (info.flags & kTrigger) != 0;
    Manifest& manifest = world.manifest;
    manifest.call(Effect::Triggers, trigger, times);
    manifest.call(Effect::Contacts, !trigger && isDynamic(world, info.body), times);
    manifest.call(Effect::Friction, !trigger && info.friction > 0.0f, times);
    manifest.call(Effect::Restitution, !trigger && info.bounciness > 0.0f, times);
    manifest.call(Effect::Rolling, !trigger && extras.rollingResistance > 0.0f, times);
    manifest.call(Effect::Conveyor, !trigger && extras.surfaceSpeed != 0.0f, times);
    manifest.call(Effect::OneWay, !trigger && (info.flags & kOneWay) != 0, times);
    manifest.call(Effect::ContactEvents, (info.flags & kReportsContacts) != 0, times);
}

void segmentsOf(const World& world, ShapeId chain, std::vector<ShapeId>& found) {
    found.clear();
    if (!alive(world, chain)) return;
    const ShapeInfo& info = world.shapes.info[chain.index];
    forShapesOf(world, info.body, [&](std::uint32_t s) {
        const ShapeInfo& other = world.shapes.info[s];
        if (s == chain.index || (info.surface != 0 && other.surface == info.surface))
            found.push_back({s, other.generation});
    });
    std::reverse(found.begin(), found.end());  // a body lists its shapes in reverse order
}

Result<ShapeId> createShape(World& world, BodyId body, const Geometry& geometry,
                            const ShapeDefinition& definition) {
    const auto checked = firstOf(checkAlive("createShape", world, body), check(geometry), check(definition));
    if (!checked) return checked.error();
    const ShapeId shape = add(world, body, geometry, definition);
    updateMass(world, body.index);
    return shape;
}

Result<ShapeId> createPolygon(World& world, BodyId body, std::span<const Vec2> points, float radius,
                              const ShapeDefinition& definition) {
    const auto checked = firstOf(checkAlive("createPolygon", world, body), check(definition),
                                 checkNumber("createPolygon radius", radius, 0.0, kLargest));
    if (!checked) return checked.error();
    const Result<Hull> hull = makeHull(points);
    if (!hull) return hull.error();
    const ShapeId shape = add(world, body, storePolygon(world.shapes, *hull, radius), definition);
    updateMass(world, body.index);
    return shape;
}

Result<ShapeId> createChain(World& world, BodyId body, std::span<const Vec2> points, bool closed,
                            std::span<const ShapeDefinition> definitions) {
    if (const auto checked = checkAlive("createChain", world, body); !checked) return checked.error();
    const std::size_t count = points.size(), fewest = closed ? 3 : 4;
    if (count < fewest) {
        return usageError(
            "createChain",
            "expected at least " + std::to_string(fewest) + " points, found " + std::to_string(count),
            "add points; the first and last point of an open chain are ghost vertices");
    }
    const std::size_t segments = closed ? count : count - 3, first = closed ? 0 : 1;
    if (definitions.size() != 1 && definitions.size() != segments) {
        return usageError("createChain",
                          "expected 1 definition, or one for each of " + std::to_string(segments) +
                              " segments, found " + std::to_string(definitions.size()),
                          "pass one definition for all segments, or a list of this length");
    }
    for (const ShapeDefinition& definition : definitions) {
        if (const auto checked = check(definition); !checked) return checked.error();
    }
    const auto segmentAt = [&](std::size_t i) {
        const std::size_t at = first + i;
        return chainSegment(points[(at + count - 1) % count], points[at % count], points[(at + 1) % count],
                            points[(at + 2) % count]);
    };
    for (std::size_t i = 0; i < segments; ++i) {
        const auto checked = check(segmentAt(i));
        if (checked) continue;
        const std::size_t from = (first + i) % count, to = (first + i + 1) % count;
        return Error{"createChain, points " + std::to_string(from) + " and " + std::to_string(to),
                     checked.error().where + ": " + checked.error().what, checked.error().remedy};
    }
    std::uint32_t surface = definitions[0].surface;
    ShapeId chain;
    for (std::size_t i = 0; i < segments; ++i) {
        const ShapeId shape =
            add(world, body, segmentAt(i), definitions[std::min(i, definitions.size() - 1)]);
        if (i == 0) chain = shape;
        if (surface == 0) surface = kOwnSurfaces | shape.index;
        world.shapes.info[shape.index].surface = surface;
    }
    updateMass(world, body.index);
    return chain;
}

Result<Done> createShapes(World& world, BodyId body, std::span<const Geometry> geometries,
                          std::span<const ShapeDefinition> definitions) {
    if (const auto checked = checkAlive("createShapes", world, body); !checked) return checked.error();
    if (geometries.size() != definitions.size()) {
        return usageError("createShapes",
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
    if (!mayChange(world, shape)) return;
    const std::uint32_t body = world.shapes.info[shape.index].body;
    wakeTouching(world, body);
    std::uint32_t* link = &world.bodies.info[body].firstShape;
    while (*link != shape.index) link = &world.shapes.info[*link].next;
    *link = world.shapes.info[shape.index].next;
    remove(world, shape.index);
    updateMass(world, body);
}

void destroyChain(World& world, ShapeId chain) {
    std::vector<ShapeId> segments;
    segmentsOf(world, chain, segments);
    for (const ShapeId segment : segments) destroyShape(world, segment);
}

void destroyShapes(World& world, BodyId body) {
    if (!mayChange(world, body)) return;
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

Result<Done> setGeometry(World& world, ShapeId shape, const Geometry& geometry) {
    const auto checked = firstOf(checkAlive("setGeometry", world, shape), check(geometry));
    if (!checked) return checked;
    freeCornersOf(world.shapes, shape.index);
    replace(world, shape.index, geometry);
    return checked;
}

Result<Done> setPolygon(World& world, ShapeId shape, std::span<const Vec2> points, float radius) {
    const auto checked = firstOf(checkAlive("setPolygon", world, shape),
                                 checkNumber("setPolygon radius", radius, 0.0, kLargest));
    if (!checked) return checked;
    const Result<Hull> hull = makeHull(points);
    if (!hull) return hull.error();
    freeCornersOf(world.shapes, shape.index);
    replace(world, shape.index, storePolygon(world.shapes, *hull, radius));
    return checked;
}

ShapeDefinition definitionOf(const World& world, ShapeId shape) {
    if (!alive(world, shape)) return {};
    const ShapeInfo& info = world.shapes.info[shape.index];
    const ShapeExtras& extras = world.shapes.extrasOf(shape.index);
    const Filter& filter = world.shapes.filter[shape.index];
    ShapeDefinition definition{info.density, info.friction, info.bounciness};
    definition.rollingResistance = extras.rollingResistance;
    definition.surfaceSpeed = extras.surfaceSpeed;
    definition.layers = filter.layers;
    definition.mask = filter.mask;
    definition.group = filter.group;
    definition.isTrigger = (info.flags & kTrigger) != 0;
    definition.oneWay = (info.flags & kOneWay) != 0;
    if (definition.oneWay) definition.oneWayDirection = extras.oneWayDirection;
    definition.reportsContacts = (info.flags & kReportsContacts) != 0;
    definition.user = info.user;
    definition.surface = info.surface;
    definition.frontLayers = extras.frontLayers;
    definition.frontMask = extras.frontMask;
    return definition;
}

Result<Done> setDefinition(World& world, ShapeId shape, const ShapeDefinition& definition) {
    const auto checked = firstOf(checkAlive("setDefinition", world, shape), check(definition));
    if (!checked) return checked;
    const ShapeDefinition before = definitionOf(world, shape);
    if (definition == before) return checked;
    if (definition.surface != before.surface)
        return usageError("ShapeDefinition.surface", "the surface of a shape cannot be changed",
                          "destroy the shape and create another");
    Shapes& shapes = world.shapes;
    ShapeInfo& info = shapes.info[shape.index];
    wakeTouching(world, info.body);
    countEffectsOfShape(world, shape.index, -1);
    take(definition, info);
    const ShapeExtras extras = extrasOf(definition);
    if (!(extras == shapes.extrasOf(shape.index))) shapes.extras.own(info.extras) = extras;
    countEffectsOfShape(world, shape.index, 1);
    if (definition.layers != before.layers || definition.mask != before.mask ||
        definition.group != before.group)
        setFilter(world, shape, definition.layers, definition.mask, definition.group);
    if (definition.density != before.density) updateMass(world, info.body);
    // Properties that are evaluated only when a contact begins.
    const auto atBegin = [](const ShapeDefinition& d) {
        return std::tuple{d.isTrigger,       d.oneWay,      d.oneWayDirection.x, d.oneWayDirection.y,
                          d.reportsContacts, d.frontLayers, d.frontMask};
    };
    atBegin(definition) != atBegin(before) ? alter(world, shape.index) : refreshContacts(world, shape.index);
    return Done{};
}

void setFilter(World& world, ShapeId shape, std::uint32_t layers, std::uint32_t mask, std::int32_t group) {
    if (!mayChange(world, shape)) return;
    Filter& filter = world.shapes.filter[shape.index];
    filter = {layers, mask, group, filter.body};
    world.filtersStale = true;
    wakeTouching(world, world.shapes.info[shape.index].body);
    noteChanged(world, shape.index);
    noteMoved(world, shape.index);
}

}  // namespace plumb::physics
