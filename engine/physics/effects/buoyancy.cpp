#include "physics/effects/buoyancy.hpp"

#include "physics/bounds.hpp"
#include "physics/effects/field_types.hpp"
#include "physics/shapes/shape_types.hpp"

namespace plumb::physics {

namespace {

// By Green's theorem the submerged area is the integral of the depth d along the outline (s: position along
// the surface). d is clamped to the range from surface to bottom; the vertical sides of the fluid contribute
// nothing. So each piece of the outline is integrated separately, cut at the borders of the fluid.

struct Sums {
    double area = 0.0;     // integral of d ds
    double momentS = 0.0;  // integral of s d ds
    double momentD = 0.0;  // integral of d^2 / 2 ds
};

/// Up to eight crossings of a piece of the outline, sorted.
class Cuts {
public:
    void add(double t) {
        if (!(t > 0.0 && t < 1.0) || count_ == at_.size()) return;
        std::size_t place = count_++;
        for (; place > 0 && at_[place - 1] > t; --place) at_[place] = at_[place - 1];
        at_[place] = t;
    }
    template <class Act>
    void forPieces(Act&& act) {
        double from = 0.0;
        for (std::size_t i = 0; i <= count_; ++i) {
            const double to = i < count_ ? at_[i] : 1.0;
            if (to > from) act(from, to);
            from = to;
        }
    }

private:
    std::array<double, 8> at_{};
    std::size_t count_ = 0;
};

void addAlongBottom(Sums& sums, double sa, double sb, double depth) {
    sums.area += depth * (sb - sa);
    sums.momentS += depth * 0.5 * (sb * sb - sa * sa);
    sums.momentD += 0.5 * depth * depth * (sb - sa);
}

void addStraight(Sums& sums, Vec2 a, Vec2 b, const AABB& fluid) {
    const double s0 = a.x, d0 = a.y, ds = static_cast<double>(b.x) - s0, dd = static_cast<double>(b.y) - d0;
    const double half = fluid.max.x, depth = fluid.max.y;
    Cuts cuts;
    if (dd != 0.0) cuts.add(-d0 / dd), cuts.add((depth - d0) / dd);
    if (ds != 0.0) cuts.add((half - s0) / ds), cuts.add((-half - s0) / ds);
    cuts.forPieces([&](double from, double to) {
        const double middle = 0.5 * (from + to), dm = d0 + middle * dd;
        if (std::fabs(s0 + middle * ds) > half || dm <= 0.0) return;
        const double sa = s0 + from * ds, sb = s0 + to * ds;
        if (dm >= depth) return addAlongBottom(sums, sa, sb, depth);
        const double da = d0 + from * dd, db = d0 + to * dd;
        sums.area += (sb - sa) * 0.5 * (da + db);
        sums.momentS += (sb - sa) * (sa * (2.0 * da + db) + sb * (da + 2.0 * db)) / 6.0;
        sums.momentD += (sb - sa) * (da * da + da * db + db * db) / 6.0;
    });
}

/// Circular arc from `start` (rad) over `sweep` (rad).
struct Arc {
    Vec2 centre;
    float radius;
    float start;
    float sweep;
};

/// Adds cuts at which an arc crosses a line along or across the surface, `offset` (m) from the center.
void cutAtLine(Cuts& cuts, const Arc& arc, float offset, bool isAcross) {
    const float part = offset / arc.radius, sign = arc.sweep < 0.0f ? -1.0f : 1.0f;
    if (!(part > -1.0f && part < 1.0f)) return;
    const float other = std::sqrt(1.0f - part * part);
    for (const float side : {other, -other}) {
        float displacement = (isAcross ? arcTangent(side, part) : arcTangent(part, side)) - arc.start;
        while (sign * displacement < 0.0f) displacement += sign * kTau;
        while (sign * displacement >= kTau) displacement -= sign * kTau;
        cuts.add(static_cast<double>(displacement) / static_cast<double>(arc.sweep));
    }
}

/// Adds the integrals of an arc from angle a to b (rad), in closed form.
void addRound(Sums& sums, const Arc& arc, double a, double b) {
    const SinCos at = sinCos(static_cast<float>(a)), bt = sinCos(static_cast<float>(b));
    const double sinA = at.sin, cosA = at.cos, sinB = bt.sin, cosB = bt.cos;
    const double r = arc.radius, cs = arc.centre.x, cd = arc.centre.y;
    const double sin1 = cosA - cosB;
    const double sin2 = 0.5 * ((b - a) - (sinB * cosB - sinA * cosA));
    const double sin3 = sin1 - (cosA * cosA * cosA - cosB * cosB * cosB) / 3.0;
    const double cosSin = 0.5 * (sinB * sinB - sinA * sinA);
    const double cosSin2 = (sinB * sinB * sinB - sinA * sinA * sinA) / 3.0;
    // s = cs + r cos, d = cd + r sin, ds = -r sin.
    sums.area -= r * (cd * sin1 + r * sin2);
    sums.momentS -= r * (cs * cd * sin1 + cs * r * sin2 + r * cd * cosSin + r * r * cosSin2);
    sums.momentD -= 0.5 * r * (cd * cd * sin1 + 2.0 * cd * r * sin2 + r * r * sin3);
}

void addArc(Sums& sums, const Arc& arc, const AABB& fluid) {
    if (arc.sweep == 0.0f) return;
    Cuts cuts;
    cutAtLine(cuts, arc, 0.0f - arc.centre.y, false);
    cutAtLine(cuts, arc, fluid.max.y - arc.centre.y, false);
    cutAtLine(cuts, arc, fluid.max.x - arc.centre.x, true);
    cutAtLine(cuts, arc, fluid.min.x - arc.centre.x, true);
    const double start = arc.start, sweep = arc.sweep, half = fluid.max.x, depth = fluid.max.y;
    cuts.forPieces([&](double from, double to) {
        const double a = start + from * sweep, b = start + to * sweep;
        const SinCos middle = sinCos(static_cast<float>(0.5 * (a + b)));
        const Vec2 point = arc.centre + arc.radius * Vec2{middle.cos, middle.sin};
        if (std::fabs(static_cast<double>(point.x)) > half || point.y <= 0.0f) return;
        if (static_cast<double>(point.y) < depth) return addRound(sums, arc, a, b);
        const double cosA = cosine(static_cast<float>(a)), cosB = cosine(static_cast<float>(b));
        const double cs = arc.centre.x, r = arc.radius;
        addAlongBottom(sums, cs + r * cosA, cs + r * cosB, depth);
    });
}

Sums alongEdge(const Convex& convex, const Frame& toFluid, const AABB& fluid) {
    Sums sums;
    if (convex.count == 1) {
        addArc(sums, {apply(toFluid, convex.corners()[0].point), convex.radius, -kPi, kTau}, fluid);
        return sums;
    }
    const auto count = static_cast<std::size_t>(convex.count);
    for (std::size_t i = 0; i < count; ++i) {
        const Corner here = apply(toFluid, convex.corners()[i]);
        const Corner next = apply(toFluid, convex.corners()[(i + 1) % count]);
        const Vec2 out = convex.radius * here.normal;
        addStraight(sums, here.point + out, next.point + out, fluid);
        if (convex.radius == 0.0f) continue;
        const float rotation = arcTangent(cross(here.normal, next.normal), dot(here.normal, next.normal));
        // The ends of a capsule are half circles, for which the sign of the angle is undefined.
        const float sweep = count == 2 ? kPi : rotation;
        addArc(sums, {next.point, convex.radius, arcTangent(here.normal.y, here.normal.x), sweep}, fluid);
    }
    return sums;
}

/// Half width and depth (m) of an unbounded fluid.
constexpr float kEndlessPool = 1.0e7f;

/// A fluid in a frame whose y axis points along gravity.
struct Fluid {
    WorldPosition surface;  // m: middle of the surface
    Rot rotation;           // from the fluid's frame to the world: x along the surface, y down
    AABB box;               // m: from the surface, y = 0, to the bottom
};

Fluid fluidOf(const World& world, const FieldDefinition& field) {
    const Vec2 gravity = world.settings.gravity;
    const Vec2 down = lengthSquared(gravity) > 0.0f ? normalized(gravity) : Vec2{0.0f, 1.0f};
    const Rot rotation{down.y, -down.x};  // rotates (0, 1) to `down`
    if (field.region == RegionKind::Everywhere)
        return {field.place, rotation, {{-kEndlessPool, 0.0f}, {kEndlessPool, kEndlessPool}}};
    const Vec2 half = field.region == RegionKind::Circle ? Vec2{field.radius, field.radius} : field.half;
    const float along = std::fabs(rotation.cos) * half.x + std::fabs(rotation.sin) * half.y;
    const float deep = std::fabs(rotation.sin) * half.x + std::fabs(rotation.cos) * half.y;
    return {field.place + -deep * down, rotation, {{-along, 0.0f}, {along, 2.0f * deep}}};
}

}  // namespace

Submerged submergedPart(const Geometry& geometry, std::span<const Corner> corners, const Frame& toFluid,
                        const AABB& fluid) {
    if (!shapeTypeOf(geometry.kind).solid) return {};
    const AABB bounds = boundsOf(geometry, corners, toFluid);
    if (!intersects(bounds, fluid)) return {};
    if (contains(fluid, bounds)) {
        const MassProperties whole = massProperties(geometry, corners, 1.0f);
        return {whole.mass, apply(toFluid, whole.centre), bounds.size().x};
    }
    const Sums sums = alongEdge(convexOf(geometry, corners), toFluid, fluid);
    const double area = std::fabs(sums.area);
    if (!(area > 1.0e-12)) return {};
    return {static_cast<float>(area),
            {static_cast<float>(sums.momentS / sums.area), static_cast<float>(sums.momentD / sums.area)},
            bounds.size().x};
}

/// Archimedes' principle: the weight of the displaced fluid lifts each shape at the centroid of its submerged
/// part. Drag is proportional to the displaced mass.
FieldForce buoyancy(const FieldView& view, std::uint32_t f, std::uint32_t body, const BodyState& state) {
    const World& world = view.world;
    const FieldDefinition& field = world.fields.all[f].definition;
    const Fluid fluid = fluidOf(world, field);
    const BodyMass& mass = world.bodies.mass[body];
    const Vec2 origin =
        state.centre - fluid.surface - rotate(state.rotation, world.bodies.pose[body].localCentre);
    const Frame toFluid{unrotate(fluid.rotation, origin), between(fluid.rotation, state.rotation)};
    Acceleration sum;
    float displaced = 0.0f;  // kg: mass of the displaced fluid
    float stiffness = 0.0f;
    for (std::uint32_t s = world.bodies.info[body].firstShape; s != kNone; s = world.shapes.info[s].next) {
        const Submerged part =
            submergedPart(world.shapes.geometry[s], world.shapes.corners, toFluid, fluid.box);
        if (part.area == 0.0f || (world.shapes.info[s].flags & kTrigger) != 0) continue;
        const float weight = field.density * part.area;
        const Vec2 arm = rotate(fluid.rotation, part.centre) - (state.centre - fluid.surface);
        const Vec2 felt = field.velocity - (state.velocity + cross(state.angularVelocity, arm));
        const Vec2 force = -weight * world.settings.gravity + field.linearDrag * weight * felt;
        sum += Acceleration{mass.inverseMass * force, mass.inverseInertia * cross(arm, force)};
        displaced += weight;
        stiffness += (mass.inverseMass + mass.inverseInertia * lengthSquared(arm)) * view.h * field.density *
                     (field.linearDrag * part.area + view.h * length(world.settings.gravity) * part.width);
    }
    return {sum, stiffness,
            mass.inverseInertia > 0.0f ? field.angularDrag * displaced * mass.inverseMass : 0.0f};
}

}  // namespace plumb::physics
