#include "tests/accuracy/reference/scene.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace plumb::reference {

namespace {

using physics::BodyKind;
using physics::Geometry;
using physics::ShapeKind;
using physics::World;

Error unknown(std::string where, std::string what, std::string remedy) {
    return {std::move(where), std::move(what), std::move(remedy)};
}

Result<Done> checkWorld(const World& world) {
    for (std::size_t i = 0; i < world.fields.all.size(); ++i) {
        if (world.fields.all[i].isAlive) {
            return unknown("reference", format("fields are not supported (field {})", i),
                           "remove it, or compare with a run with a smaller step");
        }
    }
    for (std::size_t i = 0; i < world.softBodies.all.size(); ++i) {
        if (world.softBodies.all[i].isAlive) {
            return unknown("reference", format("soft bodies are not supported (soft body {})", i),
                           "remove it, or compare with a run with a smaller step");
        }
    }
    return Done{};
}

Result<Done> checkBody(const World& world, std::uint32_t index) {
    const physics::BodyDrive& drive = world.bodies.driveOf(index);
    const auto where = [&] { return format("reference: body {}", index); };
    if (drive.force != Vec2{} || drive.torque != 0.0f) {
        return unknown(where(), "it has a pending force that acts for one step only",
                       "use a constant acceleration, or step the world once before");
    }
    if ((world.bodies.info[index].flags & physics::kHasTarget) != 0) {
        return unknown(where(), "it has a pending moveTo() target",
                       "set a velocity instead of calling moveTo()");
    }
    return Done{};
}

Result<Done> checkShape(const World& world, std::uint32_t index) {
    const physics::ShapeExtras& extras = world.shapes.extrasOf(index);
    const auto where = [&] { return format("reference: shape {}", index); };
    if ((world.shapes.info[index].flags & physics::kOneWay) != 0)
        return unknown(where(), "one-way shapes are not supported", "make it solid on all sides");
    if (extras.rollingResistance > 0.0f)
        return unknown(where(), "rolling resistance is not supported", "set its rolling resistance to 0");
    if (extras.frontLayers != 0)
        return unknown(where(), "inner borders are not supported", "use collision layers instead");
    return Done{};
}

Body bodyOf(const World& world, std::uint32_t index) {
    const physics::BodyInfo& info = world.bodies.info[index];
    const physics::BodyMass& mass = world.bodies.mass[index];
    const physics::BodyDrive& drive = world.bodies.driveOf(index);
    Body body;
    body.id = {index, info.generation};
    body.isPushed = info.kind == BodyKind::Dynamic;
    body.reach = static_cast<double>(info.reach) * (1.0 + 1.0e-6);
    if (!body.isPushed) return body;
    const auto kilograms = static_cast<double>(mass.mass), inertia = static_cast<double>(mass.inertia);
    body.mass = {kilograms, kilograms, inertia};
    body.inverseMass = {(info.flags & physics::kLockX) != 0 ? 0.0 : 1.0 / kilograms,
                        (info.flags & physics::kLockY) != 0 ? 0.0 : 1.0 / kilograms,
                        mass.inverseInertia > 0.0f ? 1.0 / inertia : 0.0};
    body.acceleration = static_cast<double>(drive.gravityScale) * toPoint(world.settings.gravity) +
                        toPoint(drive.acceleration);
    body.linearDrag = static_cast<double>(drive.linearDrag);
    body.angularDrag = static_cast<double>(drive.angularDrag);
    return body;
}

std::vector<Point> cornersOf(const World& world, const Geometry& geometry) {
    const Point a = toPoint(geometry.a), b = toPoint(geometry.b);
    switch (geometry.kind) {
        case ShapeKind::Circle: return {a};
        case ShapeKind::Box: {
            Turn turn{std::atan2(static_cast<double>(geometry.rotation.sin),
                                 static_cast<double>(geometry.rotation.cos))};
            std::vector<Point> corners;
            for (const Point corner : {Point{-b.x, -b.y}, Point{b.x, -b.y}, b, Point{-b.x, b.y}})
                corners.push_back(a + rotate(turn, corner));
            return corners;
        }
        case ShapeKind::Polygon: {
            std::vector<Point> corners;
            for (std::size_t i = 0; i < geometry.count; ++i)
                corners.push_back(toPoint(world.shapes.corners[geometry.first + i].point));
            return corners;
        }
        default: return {a, b};
    }
}

double areaOf(const std::vector<Point>& corners) {
    double twice = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        twice += cross(corners[i], corners[(i + 1) % corners.size()]);
    return 0.5 * twice;
}

/// Width of an outline: the minimum distance between two parallel lines that enclose all corners.
double widthOf(const Outline& outline) {
    double width = outline.corners.size() < 3 ? 0.0 : kEndless;
    for (std::size_t i = 0; outline.corners.size() >= 3 && i < outline.normals.size(); ++i) {
        double furthest = 0.0;
        for (const Point corner : outline.corners)
            furthest = std::max(furthest, dot(outline.normals[i], outline.corners[i] - corner));
        width = std::min(width, furthest);
    }
    return width + 2.0 * outline.radius;
}

/// Returns the normal of a neighbour segment of a chain;
/// at an end of the chain the outward direction `wayOn`.
Point neighbourNormal(Point start, Point end, Point wayOn) {
    return length(end - start) > 0.0 ? normalized(Point{(end - start).y, -(end - start).x})
                                     : normalized(wayOn);
}

void addNormals(Outline& outline, const Geometry& geometry) {
    std::vector<Point>& corners = outline.corners;
    if (corners.size() >= 3 && areaOf(corners) < 0.0) std::reverse(corners.begin(), corners.end());
    for (std::size_t i = 0; corners.size() >= 3 && i < corners.size(); ++i) {
        const Point way = corners[(i + 1) % corners.size()] - corners[i];
        outline.normals.push_back(normalized(Point{way.y, -way.x}));
    }
    if (corners.size() != 2) return;
    const Point way = corners[1] - corners[0];
    outline.normals.push_back(normalized(Point{way.y, -way.x}));
    outline.isChain = geometry.kind == ShapeKind::ChainSegment;
    if (!outline.isChain) {
        outline.normals.push_back(-outline.normals[0]);
        return;
    }
    const Point before = toPoint(beforeOf(geometry)), after = toPoint(geometry.after);
    outline.before = neighbourNormal(before, toPoint(geometry.a), -way);
    outline.after = neighbourNormal(toPoint(geometry.b), after, way);
}

Outline outlineOf(const World& world, std::uint32_t shape) {
    const physics::ShapeInfo& info = world.shapes.info[shape];
    const Geometry& geometry = world.shapes.geometry[shape];
    Outline outline;
    outline.body = info.body;
    outline.shape = shape;
    outline.corners = cornersOf(world, geometry);
    const Point centre = toPoint(world.bodies.pose[info.body].localCentre);
    for (Point& corner : outline.corners) corner = corner - centre;
    outline.radius = static_cast<double>(geometry.radius);
    addNormals(outline, geometry);
    outline.width = widthOf(outline);
    outline.friction = static_cast<double>(info.friction);
    outline.bounciness = static_cast<double>(info.bounciness);
    outline.surfaceSpeed = static_cast<double>(world.shapes.extrasOf(shape).surfaceSpeed);
    return outline;
}

void addState(const World& world, std::uint32_t index, Scene& scene) {
    const physics::BodyPose& pose = world.bodies.pose[index];
    const physics::BodyMotion& motion = world.bodies.motion[index];
    const double angle =
        std::atan2(static_cast<double>(pose.rotation.sin), static_cast<double>(pose.rotation.cos));
    scene.poses.push_back({pose.centre.x - scene.origin.x, pose.centre.y - scene.origin.y, angle});
    Triple velocity{static_cast<double>(motion.velocity.x), static_cast<double>(motion.velocity.y),
                    static_cast<double>(motion.angularVelocity)};
    if (world.bodies.info[index].kind == BodyKind::Static) velocity = {};
    scene.velocities.push_back(velocity);
}

physics::WorldPosition originOf(const World& world) {
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const physics::WorldPosition centre = world.bodies.pose[i].centre;
        if (world.bodies.info[i].kind != BodyKind::Dynamic) continue;
        // Near 0 the origin is not moved, so that round coordinates stay exact.
        const auto far = [](double at) { return std::fabs(at) < 1.0e4 ? 0.0 : std::floor(at); };
        return {far(centre.x), far(centre.y)};
    }
    return {};
}

Result<Done> addOutlines(const World& world, std::uint32_t body, Scene& scene) {
    for (std::uint32_t s = world.bodies.info[body].firstShape; s != physics::kNone;
         s = world.shapes.info[s].next) {
        if ((world.shapes.info[s].flags & physics::kTrigger) != 0) continue;
        if (const auto checked = checkShape(world, s); !checked) return checked.error();
        scene.outlines.push_back(outlineOf(world, s));
        scene.filters.push_back(world.shapes.filter[s]);
    }
    return Done{};
}

void noteApart(const World& world, Scene& scene) {
    for (const physics::Joint& joint : world.joints.hot) {
        if (joint.bodyA == physics::kNone || (joint.flags & physics::kKeepsApart) == 0) continue;
        scene.apart.push_back(physics::pairKey(joint.bodyA, joint.bodyB));
    }
    std::sort(scene.apart.begin(), scene.apart.end());
}

}  // namespace

Result<Scene> makeScene(const World& world) {
    if (const auto checked = checkWorld(world); !checked) return checked.error();
    Scene scene;
    scene.origin = originOf(world);
    scene.bounceSpeed = static_cast<double>(world.settings.bounceSpeed);
    for (std::uint32_t i = 0; i < world.bodies.size(); ++i) {
        addState(world, i, scene);
        scene.bodies.push_back({});
        if (world.bodies.info[i].kind != BodyKind::None) {
            if (const auto checked = checkBody(world, i); !checked) return checked.error();
            scene.bodies[i] = bodyOf(world, i);
            if (const auto added = addOutlines(world, i, scene); !added) return added.error();
        }
    }
    noteApart(world, scene);
    auto laws = lawsOf(world);
    if (!laws) return laws.error();
    scene.laws = std::move(*laws);
    for (Law& law : scene.laws) {
        const Point far{scene.origin.x, scene.origin.y};
        law.measure.groundA = law.measure.groundA - far;
        law.measure.groundB = law.measure.groundB - far;
    }
    return scene;
}

bool mayCollide(const Scene& scene, std::uint32_t a, std::uint32_t b) {
    const std::uint32_t bodyA = scene.outlines[a].body, bodyB = scene.outlines[b].body;
    if (!scene.bodies[bodyA].isPushed && !scene.bodies[bodyB].isPushed) return false;
    if (!physics::mayCollide(scene.filters[a], scene.filters[b])) return false;
    return !std::binary_search(scene.apart.begin(), scene.apart.end(), physics::pairKey(bodyA, bodyB));
}

}  // namespace plumb::reference
