#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "physics/islands/sleeping.hpp"
#include "physics/shapes/shape_types.hpp"
#include "physics/solver/passes.hpp"

namespace plumb::physics {

namespace {

/// Returns the distance (m) from particles within which shapes are tested.
float reachOf(const SoftBody& body) { return body.radius + kSoftSlack; }

void findShapes(StepContext& step, const SoftBody& body) {
    const Shapes& shapes = step.world.shapes;
    std::vector<std::uint32_t>& found = step.work.softSurroundings.shapes;
    const auto first = static_cast<std::ptrdiff_t>(found.size());
    if (step.work.broadPhase != nullptr) {
        step.work.broadPhase->query(grown(rounded(boxOf(body, step.dt)), body.radius + reachOf(body)),
                                    body.mask, found);
    }
    const auto end = std::remove_if(found.begin() + first, found.end(), [&](std::uint32_t shape) {
        return (shapes.info[shape].flags & kTrigger) != 0 || (shapes.filter[shape].mask & body.layers) == 0;
    });
    found.erase(end, found.end());
    std::sort(found.begin() + first, found.end());
}

Vec2 velocityAt(const Float4& motion, Vec2 arm) { return Vec2{motion.x, motion.y} + cross(motion.z, arm); }

SoftObstacle obstacleOf(const World& world, std::uint32_t body) {
    const BodyMotion& motion = world.bodies.motion[body];
    const BodyPose& pose = world.bodies.pose[body];
    SoftObstacle obstacle{
        .body = body, .isPushed = isUp(world, body), .centre = pose.centre, .rotation = pose.rotation};
    if (!isDynamic(world, body))
        obstacle.motion = {motion.velocity.x, motion.velocity.y, motion.angularVelocity, 0.0f};
    const BodyMass& mass = world.bodies.mass[body];
    obstacle.inverseMass = unlocked(world, body, {mass.inverseMass, mass.inverseMass});
    obstacle.inverseInertia = mass.inverseInertia;
    return obstacle;
}

void measure(const World& world, const SoftObstacle& obstacle, SoftContact& contact) {
    const Vec2 arm = contact.particle->place - obstacle.centre;
    const ClosestPoint nearest =
        closestPoint(world.shapes.geometry[contact.shape], world.shapes.corners,
                     world.bodies.pose[obstacle.body].localCentre + unrotate(obstacle.rotation, arm));
    contact.normal = rotate(obstacle.rotation, nearest.normal);
    contact.gap = nearest.distance - contact.soft->radius;
}

/// Calls act(contact, velocity) for the particles that may touch a shape within the step.
/// @param velocity  m/s, relative to the shape
template <class Act>
void forParticlesNear(const StepContext& step, SoftBody& soft, std::uint32_t shape, Act&& act) {
    const SoftObstacle obstacle = obstacleOf(step.world, step.world.shapes.info[shape].body);
    const BodyMotion& motion = step.world.bodies.motion[obstacle.body];
    for (SoftParticle& p : soft.particles) {
        if (p.inverseMass == 0.0f) continue;
        SoftContact contact{.soft = &soft, .particle = &p, .shape = shape, .arm = p.place - obstacle.centre};
        measure(step.world, obstacle, contact);
        const Vec2 velocity = p.velocity - motion.velocity - cross(motion.angularVelocity, contact.arm);
        if (contact.gap < reachOf(soft) + step.dt * length(velocity)) act(contact, velocity);
    }
}

void rouse(const StepContext& step, SoftBody& soft, std::uint32_t shape) {
    const std::uint32_t body = step.world.shapes.info[shape].body;
    if (!isDynamic(step.world, body) || isUp(step.world, body)) return;
    bool hit = false;
    forParticlesNear(step, soft, shape, [&](const SoftContact& contact, Vec2 velocity) {
        hit = hit || dot(velocity, contact.normal) < -kRousing;
    });
    if (hit) wake(step.world, body);
}

std::uint32_t addObstacle(const World& world, SoftSurroundings& around, SoftGroup& group,
                          std::uint32_t body) {
    std::uint32_t& known = around.obstacleOf[body];
    if (known > group.obstacles.begin) return known - 1;  // otherwise the entry is of an earlier group
    around.obstacles.push_back(obstacleOf(world, body));
    known = static_cast<std::uint32_t>(around.obstacles.size());
    if (around.obstacles.back().isPushed) group.body = body;
    return known - 1;
}

/// Returns the force (N) of a shape on a particle at the end of the last step.
Vec2 forceOf(const SoftBody& soft, std::uint32_t shape, std::uint32_t particle) {
    const auto at = std::lower_bound(
        soft.touches.begin(), soft.touches.end(), shape, [&](const SoftTouch& touch, std::uint32_t) {
            return touch.shape != shape ? touch.shape < shape : touch.particle < particle;
        });
    return at != soft.touches.end() && at->shape == shape && at->particle == particle ? at->force : Vec2{};
}

void addContacts(StepContext& step, SoftGroup& group, SoftBody& soft, std::uint32_t shape) {
    SoftSurroundings& around = step.work.softSurroundings;
    forParticlesNear(step, soft, shape, [&](SoftContact& contact, Vec2) {
        const auto particle = static_cast<std::uint32_t>(contact.particle - soft.particles.data());
        contact.obstacle = addObstacle(step.world, around, group, step.world.shapes.info[shape].body);
        contact.impulse = forceOf(soft, shape, particle);
        around.contacts.push_back(contact);
    });
}

Float4& motionOf(StepContext& step, SoftObstacle& obstacle) {
    return obstacle.isPushed ? step.work.velocity[static_cast<std::size_t>(obstacle.slot)] : obstacle.motion;
}

void measure(const StepContext& step, SoftObstacle& obstacle, float elapsed) {
    const BodyPose& pose = step.world.bodies.pose[obstacle.body];
    const Float4& motion = obstacle.motion;
    Vec2 displacement = elapsed * Vec2{motion.x, motion.y};
    Rot rotation = motion.z == 0.0f ? Rot{} : rotFromAngle(elapsed * motion.z);
    if (obstacle.isPushed) {
        const Float4& moved = step.work.deltaPosition[static_cast<std::size_t>(obstacle.slot)];
        displacement = {moved.x, moved.y};
        rotation = {1.0f + moved.w, moved.z};
    }
    obstacle.pressed = 0.0f;
    obstacle.centre = pose.centre + displacement;
    obstacle.rotation = normalized(rotation * pose.rotation);
}

/// Returns the inverse effective mass (1/kg) of particle and body along a direction.
float weightOf(const SoftContact& contact, const SoftObstacle& obstacle, Vec2 direction) {
    const float lever = cross(contact.arm, direction);
    return contact.particle->inverseMass + obstacle.inverseMass.x * direction.x * direction.x +
           obstacle.inverseMass.y * direction.y * direction.y + obstacle.inverseInertia * lever * lever;
}

void pushBody(const SoftContact& contact, const SoftObstacle& obstacle, Float4& motion, Vec2 impulse) {
    if (!obstacle.isPushed) return;
    motion.x -= obstacle.inverseMass.x * impulse.x;
    motion.y -= obstacle.inverseMass.y * impulse.y;
    motion.z -= obstacle.inverseInertia * cross(contact.arm, impulse);
}

/// Adapts a contact's impulse to a relative velocity (soft constraint, Coulomb friction); returns the change.
Vec2 answer(SoftContact& contact, const SoftObstacle& obstacle, Vec2 velocity, float bias,
            const Softness& softness) {
    const Vec2 normal = contact.normal, along = perpendicular(normal), before = contact.impulse;
    const float speed = dot(velocity, normal) + bias, pushed = dot(before, normal);
    if (before == Vec2{} && speed >= 0.0f) return {};
    const float change = softness.massScale * speed / weightOf(contact, obstacle, normal);
    const float push = std::max(pushed - change - softness.impulseScale * pushed, 0.0f);
    const float maximum = contact.soft->friction * push;
    const float rub = dot(before, along) - dot(velocity, along) / weightOf(contact, obstacle, along);
    contact.impulse = push * normal + std::clamp(rub, -maximum, maximum) * along;
    return contact.impulse - before;
}

/// Damps a body that lies on a soft body by the soft body's damping, in proportion to the fraction of its
/// weight on this contact. Otherwise a heavy load on a soft spring would oscillate.
void calm(StepContext& step, const SoftContact& contact, SoftObstacle& obstacle, float h) {
    const float damping = contact.soft->damping;
    if (!obstacle.isPushed || contact.impulse == Vec2{} || damping == 0.0f) return;
    const auto slot = static_cast<std::size_t>(obstacle.slot);
    const Float4 &drive = step.work.drive[slot], &motion = step.work.velocity[slot];
    const float weight = h * step.world.bodies.mass[obstacle.body].mass * length(Vec2{drive.x, drive.y});
    const float part =
        std::min(damping * h, 1.0f) * length(contact.impulse) / std::max(obstacle.pressed, weight);
    const float inverse = weightOf(contact, obstacle, contact.normal) - contact.particle->inverseMass;
    if (!(weight > 0.0f && inverse > 0.0f)) return;
    const Vec2 impulse =
        part * dot(velocityAt(motion, contact.arm), contact.normal) / inverse * contact.normal;
    // Added to both velocities, so that warm starting does not repeat it in the next substep.
    for (Float4* row : {&step.work.velocity[slot], &step.work.velocityBeforeImpulses[slot]})
        pushBody(contact, obstacle, *row, impulse);
}

}  // namespace

void findSurroundings(StepContext& step) {
    World& world = step.world;
    SoftSurroundings& around = step.work.softSurroundings;
    around.shapes.clear();
    around.ends.clear();
    around.neighbours.clear();
    for (SoftBody& body : world.softBodies.all) {
        const auto soft = static_cast<std::uint32_t>(around.ends.size());
        if (body.isAlive) findShapes(step, body);
        around.ends.push_back(static_cast<std::uint32_t>(around.shapes.size()));
        for (const std::uint32_t shape : around.shapesOf(soft)) rouse(step, body, shape);
    }
    addKeys(world, step.work);
    for (std::uint32_t soft = 0; soft < around.ends.size(); ++soft) {
        for (const std::uint32_t shape : around.shapesOf(soft)) {
            const std::uint32_t body = world.shapes.info[shape].body;
            if (isUp(world, body)) around.neighbours.emplace_back(islandOf(world, body), soft);
        }
    }
    std::sort(around.neighbours.begin(), around.neighbours.end());
    around.obstacleOf.assign(around.shapes.empty() ? 0 : world.bodies.size(), 0);
    around.obstacles.clear();
    around.contacts.clear();
    around.groups.clear();
}

void findSoftContacts(StepContext& step, SoftGroup& group) {
    SoftSurroundings& around = step.work.softSurroundings;
    group.obstacles.begin = around.obstacles.size();
    group.contacts.begin = around.contacts.size();
    for (const std::uint32_t soft : group.bodies.of(step.work.softSoftContacts.order)) {
        for (const std::uint32_t shape : around.shapesOf(soft))
            addContacts(step, group, step.world.softBodies.all[soft], shape);
    }
    group.obstacles.end = around.obstacles.size();
    group.contacts.end = around.contacts.size();
}

int substepsOf(const StepContext& step, const SoftGroup& group) {
    const World& world = step.world;
    float heaviest = 0.0f, lightest = std::numeric_limits<float>::infinity();  // kg
    for (const SoftObstacle& obstacle : group.obstacles.of(step.work.softSurroundings.obstacles)) {
        if (!isDynamic(world, obstacle.body)) continue;
        const float mass = world.bodies.mass[obstacle.body].mass;
        heaviest = std::max(heaviest, mass);
        lightest = std::min(lightest, mass);
    }
    const float gravity = step.runs(Effect::Gravity) ? length(world.settings.gravity) : 0.0f;  // m/s2
    int most = 1;
    for (const std::uint32_t index : group.bodies.of(step.work.softSoftContacts.order)) {
        const SoftBody& soft = world.softBodies.all[index];
        most = std::max<int>(most, soft.substeps);
        if (soft.links.empty()) continue;
        const float mass = static_cast<float>(soft.particles.size()) * soft.particles[0].mass;
        // A load accelerates what carries it: particles below a body, or a body below the soft body.
        const float load = gravity * std::max(heaviest / (kBearing * mass), mass / lightest);  // m/s2
        const float needed = std::ceil(step.dt * std::sqrt(load / (kGivenWay * soft.links[0].length)));
        most = std::max(most, static_cast<int>(std::min(needed, 64.0f)));
    }
    if (group.body != kNone || heaviest == 0.0f) return most;
    // All its bodies sleep. As many as addSoftGroups() gives them when they are awake.
    return static_cast<int>(
        std::max(std::bit_ceil(static_cast<unsigned>(most)), 1u << world.settings.quality));
}

void measureSoftContacts(StepContext& step, const SoftGroup& group, float elapsed) {
    SoftSurroundings& around = step.work.softSurroundings;
    for (SoftObstacle& obstacle : group.obstacles.of(around.obstacles)) measure(step, obstacle, elapsed);
    for (SoftContact& contact : group.contacts.of(around.contacts))
        measure(step.world, around.obstacles[contact.obstacle], contact);
}

void warmStartSoft(StepContext& step, const SoftGroup& group, float h, bool first) {
    SoftSurroundings& around = step.work.softSurroundings;
    const auto contacts = group.contacts.of(around.contacts);
    for (SoftContact& contact : contacts) {
        if (contact.impulse == Vec2{}) continue;
        SoftObstacle& obstacle = around.obstacles[contact.obstacle];
        if (first) {
            contact.impulse *= h;  // converts a force to an impulse
            pushBody(contact, obstacle, motionOf(step, obstacle), contact.impulse);
        }
        SoftParticle& p = *contact.particle;
        p.place = p.place + (h * p.inverseMass) * contact.impulse;
        obstacle.pressed += length(contact.impulse);
    }
    for (const SoftContact& contact : contacts) calm(step, contact, around.obstacles[contact.obstacle], h);
}

void solveSoft(StepContext& step, const SoftGroup& group, const ContactPass& pass, bool relax) {
    SoftSurroundings& around = step.work.softSurroundings;
    const float rate = pass.substepRate;
    for (SoftContact& contact : group.contacts.of(around.contacts)) {
        SoftObstacle& obstacle = around.obstacles[contact.obstacle];
        SoftParticle& p = *contact.particle;
        Float4& motion = motionOf(step, obstacle);
        const float gap = contact.gap;
        const bool hard = relax || gap > 0.0f;
        float bias = relax && contact.impulse != Vec2{} ? 0.0f : std::max(gap, 0.0f) * rate;
        if (!hard) bias = std::max(gap * pass.softness.biasRate, gap * pass.deepPushRate - pass.pushSpeed);
        const Vec2 velocity = relax ? p.velocity : rate * (p.place - p.before);
        const Vec2 impulse = answer(contact, obstacle, velocity - velocityAt(motion, contact.arm), bias,
                                    hard ? Softness{} : pass.softness);
        if (!isFinite(impulse)) contact.impulse = {};  // a non-finite value must not spread to the other body
        if (impulse == Vec2{} || !isFinite(impulse)) continue;
        pushBody(contact, obstacle, motion, impulse);
        if (relax) {
            p.velocity += p.inverseMass * impulse;
        } else {
            p.place = p.place + (p.inverseMass / rate) * impulse;
        }
    }
}

void storeSoftContacts(StepContext& step, const SoftGroup& group, float h) {
    for (const std::uint32_t soft : group.bodies.of(step.work.softSoftContacts.order))
        step.world.softBodies.all[soft].touches.clear();
    for (const SoftContact& contact : group.contacts.of(step.work.softSurroundings.contacts)) {
        if (contact.impulse == Vec2{}) continue;
        const auto particle = static_cast<std::uint32_t>(contact.particle - contact.soft->particles.data());
        contact.soft->touches.push_back({particle, contact.shape, contact.impulse / h});
    }
}

}  // namespace plumb::physics
