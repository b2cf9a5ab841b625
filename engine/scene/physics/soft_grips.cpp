#include "scene/physics/soft_grips.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/soft/softbody.hpp"
#include "scene/components/bodies/soft_grip.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics/soft_sync.hpp"
#include "scene/soft_look.hpp"

namespace plumb {

namespace {

using physics::SoftBody;
using physics::SoftParticle;

constexpr float kEagerness = 15.0f;  // 1/s: target velocity per distance to the target

/// True if a position is inside the outline of a jelly, by counting intersections with a ray to the right.
bool isInside(const SoftBody& body, physics::WorldPosition place) {
    bool inside = false;
    for (std::size_t i = 0; i < body.ring.size(); ++i) {
        const Vec2 a = body.particles[body.ring[i]].place - place;
        const Vec2 b = body.particles[body.ring[(i + 1) % body.ring.size()]].place - place;
        if ((a.y > 0.0f) != (b.y > 0.0f) && a.x + (b.x - a.x) * a.y / (a.y - b.y) > 0.0f) inside = !inside;
    }
    return inside;
}

std::size_t nearestOf(const SoftBody& body, physics::WorldPosition place) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < body.particles.size(); ++i) {
        const auto far = [&](std::size_t which) {
            return lengthSquared(body.particles[which].place - place);
        };
        if (far(i) < far(nearest)) nearest = i;
    }
    return nearest;
}

/// Returns the distance from its particles within which a soft body is hit, m.
float widthOf(const SoftBody& body) {
    return body.radius + (body.links.empty() ? 0.0f : 0.75f * body.links.front().length);
}

void pull(PhysicsState& state, const SoftLinkage& linkage, const SoftGrip& grip, float dt) {
    const std::span<const SoftParticle> particles = particlesOf(state.world, linkage.body);
    if (particles.empty()) return;
    const auto last = static_cast<int>(particles.size()) - 1;
    const SoftParticle held = particles[static_cast<std::size_t>(std::clamp(grip.particle, 0, last))];
    const Vec2 way = positionInMetres(grip.target - grip.anchor, state.scale) - held.place;
    const Vec2 wanted = kEagerness * way - held.velocity;
    const float most = grip.acceleration * state.scale.metres * dt, speed = length(wanted);
    if (!(speed > 0.0f) || !std::isfinite(speed)) return;
    const Vec2 push = std::min(1.0f, most / speed) * wanted;
    const float reach = std::max(grip.reach * state.scale.metres, 1e-3f);
    for (int i = 0; i <= last; ++i) {
        const SoftParticle& particle = particles[static_cast<std::size_t>(i)];
        const float share = 1.0f / (1.0f + lengthSquared(particle.place - held.place) / (reach * reach));
        static_cast<void>(
            setParticleVelocity(state.world, linkage.body, i, particle.velocity + share * share * push));
    }
}

}  // namespace

std::optional<SoftHit> softBodyAt(World& world, Vec2 place, float reach, std::uint32_t mask) {
    const PhysicsState& state = world.resource<PhysicsState>();
    const physics::WorldPosition at = positionInMetres(place, state.scale);
    std::optional<SoftHit> best;
    float nearest = 0.0f;
    for (const SoftLinkage& linkage : state.softBodies) {
        const SoftLook* look = softLookOf(std::as_const(world), linkage);
        if (look == nullptr || (look->layers & mask) == 0 || !alive(state.world, linkage.body)) continue;
        const SoftBody& body = softBodyOf(state.world, linkage.body);
        const std::size_t particle = nearestOf(body, at);
        const float far = length(body.particles[particle].place - at);
        if (far > reach * state.scale.metres + widthOf(body) && !isInside(body, at)) continue;
        if (best && far >= nearest) continue;
        nearest = far;
        best = SoftHit{linkage.entity, static_cast<int>(particle),
                       positionInPixels(body.particles[particle].place, state.scale)};
    }
    return best;
}

std::optional<Vec2> gripPlace(const World& world, EntityId entity) {
    const auto* grip = world.find<SoftGrip>(entity);
    const auto* state = world.findResource<PhysicsState>();
    if (grip == nullptr || state == nullptr) return std::nullopt;
    for (const SoftLinkage& linkage : state->softBodies) {
        const auto particles = particlesOf(state->world, linkage.body);
        if (linkage.entity != entity || particles.empty()) continue;
        const auto last = static_cast<int>(particles.size()) - 1;
        const auto held = static_cast<std::size_t>(std::clamp(grip->particle, 0, last));
        return positionInPixels(particles[held].place, state->scale) + grip->anchor;
    }
    return std::nullopt;
}

void pullSoftBodies(World& world, PhysicsState& state, float dt) {
    const World& seen = world;
    if (seen.count<SoftGrip>() == 0) return;
    for (const SoftLinkage& linkage : state.softBodies) {
        const auto* grip = seen.find<SoftGrip>(linkage.entity);
        if (grip != nullptr && alive(state.world, linkage.body)) pull(state, linkage, *grip, dt);
    }
}

}  // namespace plumb
