#include "core/hash.hpp"

#include "physics/simulation.hpp"

namespace plumb::physics {

namespace {

/// True if a type consists of these members alone: without padding, whose bytes are undefined, or a forgotten
/// member.
template <class T, class... Members>
constexpr bool isDense(Members T::*...) {
    return (sizeof(Members) + ...) == sizeof(T);
}

static_assert(isDense(&BodyPose::centre, &BodyPose::rotation, &BodyPose::localCentre));
static_assert(isDense(&BodyMotion::velocity, &BodyMotion::angularVelocity, &BodyMotion::restTime));
static_assert(isDense(&BodyMass::inverseMass, &BodyMass::inverseInertia, &BodyMass::mass,
                      &BodyMass::inertia));
static_assert(isDense(&BodyDrive::force, &BodyDrive::acceleration, &BodyDrive::torque,
                      &BodyDrive::gravityScale, &BodyDrive::linearDrag, &BodyDrive::angularDrag));
static_assert(isDense(&BodyInfo::generation, &BodyInfo::kind, &BodyInfo::flags, &BodyInfo::quality,
                      &BodyInfo::owned, &BodyInfo::firstShape, &BodyInfo::firstJoint, &BodyInfo::place,
                      &BodyInfo::island, &BodyInfo::sleepSpeed, &BodyInfo::drive, &BodyInfo::reach,
                      &BodyInfo::core, &BodyInfo::user));
static_assert(isDense(&SubstepController::quality, &SubstepController::before, &SubstepController::phase,
                      &SubstepController::patience, &SubstepController::wait, &SubstepController::error,
                      &SubstepController::first));
static_assert(isDense(&EnergyShare::credit, &EnergyShare::peak));
static_assert(isDense(&Geometry::kind, &Geometry::count, &Geometry::reserved, &Geometry::first,
                      &Geometry::radius, &Geometry::a, &Geometry::b, &Geometry::turn, &Geometry::after));
static_assert(isDense(&Corner::point, &Corner::normal));
static_assert(isDense(&AABB::min, &AABB::max));
static_assert(isDense(&Filter::layers, &Filter::mask, &Filter::group, &Filter::body));
static_assert(isDense(&ShapeInfo::generation, &ShapeInfo::body, &ShapeInfo::next, &ShapeInfo::flags,
                      &ShapeInfo::reserved, &ShapeInfo::density, &ShapeInfo::friction, &ShapeInfo::bounciness,
                      &ShapeInfo::margin, &ShapeInfo::user, &ShapeInfo::surface, &ShapeInfo::extras));
static_assert(isDense(&ShapeExtras::rollingResistance, &ShapeExtras::surfaceSpeed,
                      &ShapeExtras::oneWayDirection, &ShapeExtras::frontLayers, &ShapeExtras::frontMask));
static_assert(isDense(&Contact::shapeA, &Contact::shapeB, &Contact::bodyA, &Contact::bodyB, &Contact::flags,
                      &Contact::colour, &Contact::count, &Contact::bounciness, &Contact::rollingResistance,
                      &Contact::surfaceSpeed, &Contact::normal, &Contact::friction, &Contact::frictionImpulse,
                      &Contact::turn, &Contact::rollingImpulse, &Contact::ids, &Contact::anchors,
                      &Contact::separation0, &Contact::impulse0, &Contact::separation1, &Contact::impulse1,
                      &Contact::roundA, &Contact::roundB, &Contact::normalInA));
static_assert(isDense(&Joint::bodyA, &Joint::bodyB, &Joint::anchorA, &Joint::anchorB, &Joint::kind,
                      &Joint::flags, &Joint::colour, &Joint::quality, &Joint::generation, &Joint::force,
                      &Joint::torque, &Joint::rows, &Joint::nextA, &Joint::nextB, &Joint::place));
static_assert(isDense(&SleepingIsland::firstBody, &SleepingIsland::firstContact));
static_assert(isDense(&Manifest::callers, &Manifest::pinnedOn, &Manifest::pinnedOff));
static_assert(isDense(&JointId::index, &JointId::generation));

/// Adds values one by one, for types with padding.
class Values {
public:
    explicit Values(LaneHasher& hash) : hash_{hash} {}

    template <class... T>
    void operator()(T... values) {
        (hash_.add(bitsOf(values)), ...);
    }

private:
    static std::uint64_t bitsOf(float value) { return std::bit_cast<std::uint32_t>(value); }
    static std::uint64_t bitsOf(Vec2 value) { return bitsOf(value.x) << 32 | bitsOf(value.y); }
    static std::uint64_t bitsOf(double value) { return std::bit_cast<std::uint64_t>(value); }
    template <class Thing>
    static std::uint64_t bitsOf(Id<Thing> id) {
        return std::uint64_t{id.index} << 32 | id.generation;
    }
    template <class T>
    requires std::is_integral_v<T> || std::is_enum_v<T>
    static std::uint64_t bitsOf(T value) { return static_cast<std::uint64_t>(value); }

    LaneHasher& hash_;
};

template <class T>
void add(LaneHasher& hash, const std::vector<T>& values) {
    hash.addBytes(values.data(), values.size() * sizeof(T));
}

template <class... T>
void addAll(LaneHasher& hash, const std::vector<T>&... arrays) {
    (add(hash, arrays), ...);
}

// These bind every member: a new member that is not named here does not compile.

void add(LaneHasher& hash, const Settings& settings) {
    const auto& [gravity, integrator, broadPhase, quality, iterations, automaticQuality, tolerance,
                 directJoints, contactStiffness, jointStiffness, contactDampingRatio, jointDampingRatio,
                 pushSpeed, deepPushRate, slop, speculativeDistance, recycleDistance, boundsMargin,
                 bounceSpeed, sleepTime, maxSpeed, continuous, sleeping, stayEvents] = settings;
    Values{hash}(gravity, integrator, broadPhase, quality, iterations, automaticQuality, directJoints,
                 contactStiffness, jointStiffness, contactDampingRatio, jointDampingRatio, pushSpeed,
                 deepPushRate, slop, speculativeDistance, recycleDistance, boundsMargin, bounceSpeed,
                 sleepTime, maxSpeed, continuous, sleeping, stayEvents);
    // Worlds without a tolerance keep the hash that they had before it existed.
    if (tolerance != 0.0f) Values{hash}(tolerance);
}

void add(LaneHasher& hash, const JointDefinition& definition) {
    const auto& [kind, a, b, anchorA, anchorB, axis, referenceAngle, length, ratio, groundA, groundB, target,
                 offset, velocity, jointA, jointB, limit, motor, spring, maxForce, maxTorque, breakForce,
                 breakTorque, reportForce, reportTorque, hertz, dampingRatio, collideConnected, quality,
                 user] = definition;
    Values values{hash};
    values(kind, a, b, anchorA, anchorB, axis, referenceAngle, length, ratio, groundA, groundB, target.x,
           target.y, offset, jointA, jointB, maxForce, maxTorque, breakForce, breakTorque, hertz,
           dampingRatio, collideConnected, quality, user);
    const auto& [limitOn, lower, upper] = limit;
    const auto& [motorOn, speed, mostForce] = motor;
    const auto& [springOn, springHertz, springDamping, rest] = spring;
    values(limitOn, lower, upper, motorOn, speed, mostForce, springOn, springHertz, springDamping, rest);
    // Joints without these keep the hash that they had before these existed.
    const JointDefinition usual;
    if (velocity != usual.velocity) values(velocity);
    if (reportForce != usual.reportForce || reportTorque != usual.reportTorque)
        values(reportForce, reportTorque);
}

void add(LaneHasher& hash, const Field& field) {
    const auto& [definition, fieldGeneration, fieldIsAlive] = field;
    const auto& [kind, region, replacesGravity, linear, layers, place, half, radius, acceleration, velocity,
                 strength, damping, length, density, linearDrag, angularDrag, gust, gustSteps, seed, a, b,
                 anchorA, anchorB] = definition;
    Values{hash}(kind, region, replacesGravity, linear, layers, place.x, place.y, half, radius, acceleration,
                 velocity, strength, damping, length, density, linearDrag, angularDrag, gust, gustSteps, seed,
                 a, b, anchorA, anchorB, fieldGeneration, fieldIsAlive);
}

void add(LaneHasher& hash, const SoftParticle& particle) {
    const auto& [place, before, velocity, inverseMass, mass] = particle;
    Values{hash}(place.x, place.y, before.x, before.y, velocity, inverseMass, mass);
}

void add(LaneHasher& hash, const SoftLink& link) {
    const auto& [a, b, length, compliance, isEdge] = link;
    Values{hash}(a, b, length, compliance, isEdge);
}

void add(LaneHasher& hash, const SoftBody& soft) {
    const auto& [particles, links, ring, touches, area, areaCompliance, radius, damping, friction, layers,
                 mask, generation, substeps, isAlive] = soft;
    for (const SoftParticle& particle : particles) add(hash, particle);
    for (const SoftLink& link : links) add(hash, link);
    add(hash, ring);
    for (const SoftTouch& touch : touches) Values{hash}(touch.particle, touch.shape, touch.force);
    Values{hash}(area, areaCompliance, radius, damping, friction, layers, mask, generation, substeps,
                 isAlive);
}

void add(LaneHasher& hash, const Shapes& shapes) {
    addAll(hash, shapes.geometry, shapes.bounds, shapes.filter, shapes.motion, shapes.info,
           shapes.extras.rows, shapes.extras.free, shapes.free, shapes.dying, shapes.corners);
    for (const std::vector<std::uint32_t>& free : shapes.freeCorners) add(hash, free);
}

void add(LaneHasher& hash, const Joints& joints) {
    addAll(hash, joints.hot, joints.awake, joints.free);
    for (const JointDefinition& definition : joints.definition) add(hash, definition);
}

}  // namespace

std::uint64_t hashOf(const World& world) {
    LaneHasher hash;
    const Bodies& bodies = world.bodies;
    const Sleepers& sleepers = world.sleepers;
    add(hash, world.settings);
    addAll(hash, bodies.pose, bodies.motion, bodies.mass, bodies.info, bodies.drives.rows, bodies.drives.free,
           bodies.free, bodies.dying);
    // Skipped where empty, as the tolerance above: even an empty list changes the hash.
    if (!bodies.substepControllers.empty()) add(hash, bodies.substepControllers);
    if (!bodies.energies.empty()) add(hash, bodies.energies);
    add(hash, world.shapes);
    add(hash, world.joints);
    for (const Field& field : world.fields.all) add(hash, field);
    add(hash, world.fields.free);
    for (const SoftBody& soft : world.softBodies.all) add(hash, soft);
    add(hash, world.softBodies.free);
    addAll(hash, world.awake, world.moved, world.contacts);
    if (!world.altered.empty()) add(hash, world.altered);
    addAll(hash, sleepers.islands, sleepers.freeIslands, sleepers.contacts, sleepers.nextContact,
           sleepers.freeContacts, sleepers.nextBody, sleepers.islandOf);
    for (const auto& [pair, hidden] : world.initialOverlaps) Values{hash}(pair, hidden);
    // Events belong to the last step: the next one does not depend on them.
    Values{hash}(world.qualityCallers, world.newJoints, world.filtersStale, world.islandsStale,
                 world.islandsAge, world.gravityOfLastStep, world.steps);
    hash.addBytes(&world.manifest, sizeof world.manifest);
    return hash.value();
}

void addTo(Hasher& hasher, const World& world) { hasher.add(hashOf(world)); }

}  // namespace plumb::physics
