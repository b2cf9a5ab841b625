#include "scene/systems/character_controller_system.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "physics/character/character_controller.hpp"
#include "scene/components/bodies/character_body.hpp"
#include "scene/components/bodies/character_controller.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/colliders/capsule_collider.hpp"
#include "scene/components/colliders/circle_collider.hpp"
#include "scene/physics/collider_shapes.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics_bridge.hpp"

namespace plumb {

namespace {

/// Outline of a character, relative to its center.
struct Outline {
    physics::Geometry geometry;
    Vec2 middle;  // px, from the Transform to the center
    const ColliderSurface* surface = nullptr;
};

Outline outlineOf(const World& world, EntityId entity, Vec2 scale, PixelScale units) {
    if (const auto* box = world.find<BoxCollider>(entity)) {
        const Vec2 size = scaledSize(box->width, box->height, scale);
        return {physics::box(toMetres(size * 0.5f, units)), box->offset + size * 0.5f, box};
    }
    if (const auto* capsule = world.find<CapsuleCollider>(entity)) {
        const Vec2 size = scaledSize(capsule->width, capsule->height, scale);
        const float radius = 0.5f * std::min(size.x, size.y);
        const Vec2 arm = toMetres(size * 0.5f - Vec2{radius, radius}, units);
        return {physics::capsule(-arm, arm, radius * units.metres), capsule->offset + size * 0.5f, capsule};
    }
    if (const auto* circle = world.find<CircleCollider>(entity)) {
        const float radius = circle->radius * std::max(std::abs(scale.x), std::abs(scale.y));
        return {physics::circle(radius * units.metres), circle->offset, circle};
    }
    return {};
}

physics::CharacterDefinition definitionOf(const PhysicsState& state, EntityId entity,
                                          const CharacterController& character, const Outline& outline) {
    const float metres = state.scale.metres;
    physics::CharacterDefinition definition;
    definition.outline = outline.geometry;
    const Vec2 up = -normalized(state.world.settings.gravity);
    if (up != Vec2{}) definition.up = up;
    definition.steepest = character.steepest;
    definition.stepHeight = character.stepHeight * metres;
    definition.snap = character.snap * metres;
    definition.cornerCorrection = character.cornerCorrection * metres;
    definition.evenSpeed = character.evenSpeed;
    definition.gravityScale = character.gravityScale;
    definition.pushForce = character.pushForce * metres;
    definition.pushMass = character.pushMass;
    definition.weight = character.weight;
    definition.filter.layers = outline.surface->layers;
    definition.filter.mask = outline.surface->mask;
    definition.filter.except = bodyOf(state, entity);
    return definition;
}

std::uint64_t madeFrom(const physics::CharacterDefinition& d) {
    Hasher hasher;
    const auto add = [&hasher](auto... values) { (hasher.add(values), ...); };
    add(static_cast<std::uint64_t>(d.outline.kind), d.outline.radius, d.outline.a.x, d.outline.a.y,
        d.outline.b.x, d.outline.b.y, d.up.x, d.up.y);
    add(d.steepest, d.stepHeight, d.snap, d.cornerCorrection, std::uint64_t{d.evenSpeed}, d.gravityScale,
        d.pushForce, d.pushMass, d.weight);
    add(std::uint64_t{d.filter.layers}, std::uint64_t{d.filter.mask}, std::uint64_t{d.filter.except.index},
        std::uint64_t{d.filter.except.generation});
    return hasher.value();
}

CharacterLinkage* linkageOf(PhysicsState& state, EntityId entity) {
    const auto known =
        std::find_if(state.characters.begin(), state.characters.end(),
                     [&](const CharacterLinkage& linkage) { return linkage.entity == entity; });
    return known != state.characters.end() ? &*known : nullptr;
}

/// Returns the controller of a character, updated from its
/// component and Transform; null if these are invalid.
CharacterLinkage* prepared(const World& world, PhysicsState& state, EntityId entity,
                           const CharacterController& character, const Outline& outline, Vec2 middle) {
    const physics::CharacterDefinition definition = definitionOf(state, entity, character, outline);
    const std::uint64_t made = madeFrom(definition);
    CharacterLinkage* linkage = linkageOf(state, entity);
    Result<Done> result = Done{};
    if (linkage == nullptr) {
        const auto created =
            physics::CharacterController::create(definition, positionInMetres(middle, state.scale));
        if (created) {
            linkage = &state.characters.emplace_back(CharacterLinkage{entity, middle, made, *created});
        } else {
            result = created.error();
        }
    } else if (made != linkage->made) {
        result = linkage->controller.setDefinition(definition);
        if (result) linkage->made = made;
    }
    if (linkage != nullptr && middle != linkage->middle)
        result = linkage->controller.setPosition(positionInMetres(middle, state.scale));
    if (linkage != nullptr && result)
        result = linkage->controller.setVelocity(toMetres(character.velocity, state.scale));
    if (!result) logRefusal(world, state, entity, result.error());
    return result ? linkage : nullptr;
}

void move(World& world, PhysicsState& state, EntityId entity, CharacterController& character,
          Transform& transform, float dt) {
    const Outline outline = outlineOf(std::as_const(world), entity, transform.scale, state.scale);
    if (outline.surface == nullptr) return;
    CharacterLinkage* linkage =
        prepared(world, state, entity, character, outline, transform.position + outline.middle);
    if (linkage == nullptr) return;
    const physics::CharacterMotion motion = linkage->controller.update(state.world, dt);
    const Vec2 middle = positionInPixels(linkage->controller.position(), state.scale);
    if (middle != linkage->middle) transform.position = middle - outline.middle;
    linkage->middle = transform.position + outline.middle;
    character.velocity = toPixels(linkage->controller.velocity(), state.scale);
    character.grounded = linkage->controller.grounded();
    character.ground = character.grounded ? ownerOf(state, linkage->controller.ground().body) : EntityId{};
    character.groundNormal = character.grounded ? linkage->controller.ground().normal : Vec2{0.0f, -1.0f};
    character.hitWall = static_cast<bool>(motion.wall);
    character.hitCeiling = static_cast<bool>(motion.ceiling);
}

}  // namespace

void CharacterControllerSystem::update(World& world, float dt) {
    if (world.count<CharacterController>() == 0) return;
    for (auto [entity, character] :
         world.query<const CharacterController>(with<Transform>, without<CharacterBody>))
        entity.addComponent<CharacterBody>();
    syncBodies(world, dt);
    PhysicsState& state = world.resource<PhysicsState>();
    std::erase_if(state.characters, [&world](const CharacterLinkage& linkage) {
        return !std::as_const(world).has<CharacterController>(linkage.entity);
    });
    for (auto [entity, character, transform] : world.query<CharacterController, Transform>())
        move(world, state, entity.id(), character, transform, dt);
}

}  // namespace plumb
