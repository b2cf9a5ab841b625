#include "physics/effects/field_types.hpp"

#include <algorithm>

#include "core/hash.hpp"
#include "physics/edits.hpp"
#include "physics/tuning.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

bool isInRegion(const FieldDefinition& field, Vec2 displacement, float reach) {
    const RegionKind region = regionOf(field);
    if (region == RegionKind::Circle) return length(displacement) <= field.radius + reach;
    return region != RegionKind::Box || (std::fabs(displacement.x) <= field.half.x + reach &&
                                         std::fabs(displacement.y) <= field.half.y + reach);
}

const FieldDefinition& fieldOf(const FieldView& view, std::uint32_t field) {
    return view.world.fields.all[field].definition;
}

FieldForce areaGravity(const FieldView& view, std::uint32_t f, std::uint32_t body, const BodyState& state) {
    const FieldDefinition& field = fieldOf(view, f);
    Vec2 pull = field.acceleration;
    if (field.strength != 0.0f) pull += field.strength * normalized(field.place - state.centre);
    if (field.replacesGravity && view.world.manifest.runs(Effect::Gravity))
        pull -= view.world.settings.gravity;
    return {{view.world.bodies.driveOf(body).gravityScale * pull, 0.0f}};
}

/// Returns the strength, from -1 to 1, of gust number `gust` in the random sequence of a seed.
float gustAt(std::uint32_t seed, std::uint64_t gust) {
    const auto bits = static_cast<std::uint32_t>(mixBits(mixBits(seed) ^ gust) >> 40);
    return static_cast<float>(bits) * 0x1p-23f - 1.0f;
}

/// Returns the gust in a step, -1 to 1, interpolated between consecutive gusts. Depends only on the step
/// number, so that a repeated step has the same wind.
float gustiness(const FieldDefinition& field, std::uint64_t step) {
    const std::uint64_t gust = step / field.gustSteps;
    const float t = static_cast<float>(step % field.gustSteps) / static_cast<float>(field.gustSteps);
    const float smooth = t * t * (3.0f - 2.0f * t);
    return lerp(gustAt(field.seed, gust), gustAt(field.seed, gust + 1), smooth);
}

/// Wind: F = density * width * speed^2, along the apparent wind.
FieldForce wind(const FieldView& view, std::uint32_t f, std::uint32_t body, const BodyState& state) {
    const FieldDefinition& field = fieldOf(view, f);
    const Vec2 felt = airOf(field, view.world.steps) - state.velocity;
    const float speed = length(felt);
    if (speed == 0.0f) return {};
    const float width = widthAcross(view.world, body, state.rotation, felt / speed);
    const float rate = field.density * width * speed * view.world.bodies.mass[body].inverseMass;  // 1/s
    return {{rate * felt, 0.0f}, rate * view.h};
}

/// Attractor: a = strength / distance^2 (Newton), or strength * distance. Softened after H. Plummer, 1911.
FieldForce attractor(const FieldView& view, std::uint32_t f, std::uint32_t, const BodyState& state) {
    const FieldDefinition& field = fieldOf(view, f);
    const WorldPosition centre = field.a ? view.stateOf(view, field.a.index).centre : field.place;
    const Vec2 displacement = centre - state.centre;
    if (field.linear) return {{field.strength * displacement, 0.0f}};
    const float square = lengthSquared(displacement) + field.length * field.length;
    if (square <= 1.0e-12f) return {};
    return {{(field.strength / (square * std::sqrt(square))) * displacement, 0.0f}};
}

/// One end of a spring.
struct End {
    WorldPosition place;  // m
    Vec2 velocity;
    Vec2 arm;  // m, from the center of mass
};

End endOf(const World& world, std::uint32_t body, const BodyState& state, Vec2 anchor) {
    const Vec2 arm = rotate(state.rotation, anchor - world.bodies.pose[body].localCentre);
    return {state.centre + arm, state.velocity + cross(state.angularVelocity, arm), arm};
}

/// Spring: F = strength * (length - rest) + damping * speed.
FieldForce spring(const FieldView& view, std::uint32_t f, std::uint32_t body, const BodyState& state) {
    const FieldDefinition& field = fieldOf(view, f);
    const bool isA = field.a.index == body;
    const End here = endOf(view.world, body, state, isA ? field.anchorA : field.anchorB);
    End there{field.place, {}, {}};
    if (field.b) {
        const std::uint32_t other = isA ? field.b.index : field.a.index;
        there = endOf(view.world, other, view.stateOf(view, other), isA ? field.anchorB : field.anchorA);
    }
    const Vec2 displacement = there.place - here.place;
    const float size = length(displacement);
    if (size == 0.0f) return {};
    const Vec2 along = displacement / size;
    const Vec2 force = (view.springScales[f] * (field.strength * (size - field.length) +
                                                field.damping * dot(along, there.velocity - here.velocity))) *
                       along;
    const BodyMass& mass = view.world.bodies.mass[body];
    return {{mass.inverseMass * force, mass.inverseInertia * cross(here.arm, force)},
            view.springScales[f] * springStiffness(view.world, field, body, view.h)};
}

/// Field types in the order of FieldKind.
constexpr std::array<FieldType, static_cast<std::size_t>(FieldKind::Count)> kFieldTypes{{
    {Effect::AreaGravity, areaGravity},
    {Effect::Wind, wind},
    {Effect::Buoyancy, buoyancy},
    {Effect::Attractor, attractor},
    {Effect::Explosion, nullptr},
    {Effect::Springs, spring},
}};

/// Up to this number of fields, testing each costs less than a search.
constexpr std::size_t kFew = 8;

/// Returns a box around a position, enlarged by rounding errors (16 times 2^-24 of the largest coordinate).
AABB boxAround(WorldPosition place, Vec2 half) {
    const Vec2 at = toVec2(place);
    const float far = std::max(std::fabs(at.x) + half.x, std::fabs(at.y) + half.y);
    return grown({at - half, at + half}, 2.0f * kRounding * far);
}

AABB boundsOf(const World& world, const FieldDefinition& field) {
    constexpr float kEndless = std::numeric_limits<float>::max();
    const RegionKind region = regionOf(field);
    if (region == RegionKind::Everywhere) return {{-kEndless, -kEndless}, {kEndless, kEndless}};
    const Vec2 half = region == RegionKind::Circle ? Vec2{field.radius, field.radius} : field.half;
    return boxAround(centreOf(world, field), half);
}

}  // namespace

const FieldType& fieldTypeOf(FieldKind kind) { return kFieldTypes[static_cast<std::size_t>(kind)]; }

Vec2 airOf(const FieldDefinition& field, std::uint64_t step) {
    if (!(field.gust > 0.0f)) return field.velocity;
    const Vec2 along = lengthSquared(field.velocity) > 0.0f ? normalized(field.velocity) : Vec2{1.0f, 0.0f};
    return field.velocity + (field.gust * gustiness(field, step)) * along;
}

bool isOnLayers(const World& world, std::uint32_t layers, std::uint32_t body) {
    if (layers == 0xffffffffu) return true;
    for (std::uint32_t s = world.bodies.info[body].firstShape; s != kNone; s = world.shapes.info[s].next) {
        if ((world.shapes.filter[s].layers & layers) != 0) return true;
    }
    return false;
}

bool actsOn(const World& world, const FieldDefinition& field, std::uint32_t body) {
    if (field.kind == FieldKind::Spring) return field.a.index == body || (field.b && field.b.index == body);
    if (field.kind == FieldKind::Attractor && field.a && field.a.index == body) return false;
    if (!isOnLayers(world, field.layers, body)) return false;
    const Vec2 displacement = world.bodies.pose[body].centre - centreOf(world, field);
    // Fluids and explosions act on outlines, all other fields on centers of mass.
    const bool byOutline = field.kind == FieldKind::Buoyancy || field.kind == FieldKind::Explosion;
    const float reach = byOutline ? world.bodies.info[body].reach : 0.0f;
    return isInRegion(field, displacement, reach);
}

bool isInRegion(const FieldDefinition& field, WorldPosition place) {
    return isInRegion(field, place - field.place, 0.0f);
}

float springStiffness(const World& world, const FieldDefinition& field, std::uint32_t body, float h) {
    const Vec2 anchor = field.a.index == body ? field.anchorA : field.anchorB;
    const BodyMass& mass = world.bodies.mass[body];
    const float lever = lengthSquared(anchor - world.bodies.pose[body].localCentre);
    return (mass.inverseMass + mass.inverseInertia * lever) * h * (field.damping + 0.5f * h * field.strength);
}

Acceleration accelerationAt(const FieldView& view, std::span<const std::uint32_t> fields, std::uint32_t body,
                            const BodyState& state, const Acceleration& other) {
    FieldForce sum;
    for (const std::uint32_t f : fields) {
        const FieldDefinition& field = fieldOf(view, f);
        if (isConstant(field)) continue;
        if (const auto force = fieldTypeOf(field.kind).force; force != nullptr)
            sum += force(view, f, body, state);
    }
    Acceleration result = sum.acceleration;
    if (sum.stiffness > 1.0f) {
        const float part = 1.0f / sum.stiffness;
        result = part * (result + other) - other;
    }
    result.angular -= std::min(sum.angularDrag, 1.0f / view.h) * state.angularVelocity;
    result.linear = unlocked(view.world, body, result.linear);
    return result;
}

BodyState stateAfter(const World& world, std::uint32_t body, float elapsed) {
    const BodyPose& pose = world.bodies.pose[body];
    const BodyMotion& motion = world.bodies.motion[body];
    const float angle = elapsed * motion.angularVelocity;
    const Rot rotation = angle == 0.0f ? pose.rotation : normalized(rotFromAngle(angle) * pose.rotation);
    return {pose.centre + elapsed * motion.velocity, rotation, motion.velocity, motion.angularVelocity};
}

float widthAcross(const Geometry& geometry, std::span<const Corner> corners, Vec2 direction) {
    const Convex convex = convexOf(geometry, corners);
    const Vec2 across = perpendicular(direction);
    const auto reach = [&](Vec2 side) {
        return dot(side, convex.corners()[static_cast<std::size_t>(farthest(convex.corners(), side))].point);
    };
    return reach(across) + reach(-across) + 2.0f * convex.radius;
}

float widthAcross(const World& world, std::uint32_t body, Rot rotation, Vec2 direction) {
    const Vec2 local = unrotate(rotation, direction);
    float width = 0.0f;
    forShapesOf(world, body, [&](std::uint32_t s) {
        if ((world.shapes.info[s].flags & kTrigger) == 0)
            width += widthAcross(world.shapes.geometry[s], world.shapes.corners, local);
    });
    return width;
}

void updateFieldBoxes(const World& world, Workspace& work) {
    std::vector<std::uint32_t>& searched = work.searchedFields;
    searched.clear();
    for (std::uint32_t f = 0; f < world.fields.all.size(); ++f) {
        const Field& field = world.fields.all[f];
        const FieldKind kind = field.definition.kind;
        if (!field.isAlive || kind == FieldKind::Spring) continue;
        if (world.manifest.runs(fieldTypeOf(kind).effect)) searched.push_back(f);
    }
    if (searched.size() <= kFew) return;
    BoxProxies& boxes = work.fieldBoxes;
    bool isCurrent = boxes.search != nullptr && boxes.bounds.size() == searched.size();
    boxes.bounds.resize(searched.size());
    boxes.filters.resize(searched.size());
    boxes.motions.assign(searched.size(), ProxyMotion::Awake);
    for (std::size_t i = 0; i < searched.size(); ++i) {
        const FieldDefinition& field = world.fields.all[searched[i]].definition;
        const AABB bounds = boundsOf(world, field);
        const std::uint32_t kind = 1u << static_cast<unsigned>(field.kind);
        isCurrent = isCurrent && bounds == boxes.bounds[i] && kind == boxes.filters[i].layers;
        boxes.bounds[i] = bounds;
        boxes.filters[i].layers = kind;
    }
    if (isCurrent) return;
    if (boxes.search == nullptr) boxes.search = makeBroadPhase(BroadPhaseKind::Tree);
    boxes.search->rebuild(boxes.view());
}

std::span<const std::uint32_t> fieldsNear(const World& world, Workspace& work, std::uint32_t body,
                                          std::uint32_t kinds) {
    if (work.searchedFields.size() <= kFew) return work.searchedFields;
    const float reach = world.bodies.info[body].reach;
    std::vector<std::uint32_t>& found = work.candidates;
    found.clear();
    work.fieldBoxes.search->query(boxAround(world.bodies.pose[body].centre, {reach, reach}), kinds, found);
    std::sort(found.begin(), found.end());
    for (std::uint32_t& field : found) field = work.searchedFields[field];
    return found;
}

}  // namespace plumb::physics
