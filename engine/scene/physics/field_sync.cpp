#include "scene/physics/field_sync.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "physics/model/fields.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/colliders/circle_collider.hpp"
#include "scene/components/fields/attractor.hpp"
#include "scene/components/fields/buoyancy_field.hpp"
#include "scene/components/fields/explosion.hpp"
#include "scene/components/fields/gravity_field.hpp"
#include "scene/components/fields/wind_field.hpp"
#include "scene/physics/entity_bodies.hpp"

namespace plumb {

namespace {

using physics::FieldDefinition;
using physics::RegionKind;

/// Functions of a field component type.
struct FieldRow {
    bool (*describe)(const World& world, EntityId entity, FieldDefinition& field, Vec2& size, float metres);
    std::uint64_t (*members)(const World& world);
    void (*forEach)(const World& world, void (*visit)(void*, EntityId), void* context);
};

template <class Component>
constexpr FieldRow fieldRow() {
    FieldRow row{};
    row.describe = [](const World& world, EntityId entity, FieldDefinition& field, Vec2& size, float metres) {
        const Component* component = world.find<Component>(entity);
        if (component == nullptr) return false;
        component->apply(field, metres);
        field.layers = component->layers;
        if constexpr (requires { component->size; }) size = component->size;
        return true;
    };
    row.members = [](const World& world) { return world.memberships<Component>(); };
    row.forEach = [](const World& world, void (*visit)(void*, EntityId), void* context) {
        for (auto [entity, field] : world.query<const Component>()) visit(context, entity.id());
    };
    return row;
}

constexpr FieldRow kFields[] = {
    fieldRow<GravityField>(), fieldRow<WindField>(), fieldRow<BuoyancyField>(),
    fieldRow<Attractor>(),    fieldRow<Explosion>(),
};

std::uint64_t fieldHash(const FieldDefinition& d) {
    Hasher hasher;
    const auto add = [&hasher](auto... values) { (hasher.add(values), ...); };
    const auto place = [&](double value) { add(std::bit_cast<std::uint64_t>(value)); };
    add(static_cast<std::uint64_t>(d.kind), static_cast<std::uint64_t>(d.region),
        std::uint64_t{d.replacesGravity}, std::uint64_t{d.linear}, std::uint64_t{d.layers});
    place(d.place.x), place(d.place.y);
    add(d.half.x, d.half.y, d.radius, d.acceleration.x, d.acceleration.y, d.velocity.x, d.velocity.y);
    add(d.strength, d.length, d.density, d.linearDrag, d.angularDrag, d.gust, std::uint64_t{d.gustSteps},
        std::uint64_t{d.a.index}, std::uint64_t{d.a.generation});
    return hasher.value() | 1;
}

class FieldSync {
public:
    FieldSync(World& world, PhysicsState& state) : world_{world}, state_{state} {}

    void followAll() {
        for (kind_ = 0; kind_ < std::size(kFields); ++kind_) {
            kFields[kind_].forEach(
                world_, [](void* sync, EntityId entity) { static_cast<FieldSync*>(sync)->follow(entity); },
                this);
        }
        std::erase_if(state_.fields, [this](const FieldLinkage& linkage) {
            if (linkage.seen == state_.syncs) return false;
            physics::destroyField(state_.world, linkage.field);
            return true;
        });
    }

    void bring(FieldLinkage& linkage) {
        FieldDefinition definition;
        if (!define(linkage, definition)) return;
        const std::uint64_t made = fieldHash(definition);
        const bool lives = physics::alive(state_.world, linkage.field);
        if (made == linkage.made && (lives || definition.kind == physics::FieldKind::Explosion)) return;
        linkage.made = made;
        if (lives) {
            accept(linkage, physics::setField(state_.world, linkage.field, definition));
        } else {
            const auto field = physics::createField(state_.world, definition);
            field ? accept(linkage, Done{}) : accept(linkage, field.error());
            if (field) linkage.field = *field;
        }
    }

private:
    void follow(EntityId entity) {
        const auto known = std::find_if(
            state_.fields.begin(), state_.fields.end(),
            [&](const FieldLinkage& linkage) { return linkage.entity == entity && linkage.kind == kind_; });
        FieldLinkage& linkage = known != state_.fields.end() ? *known : state_.fields.emplace_back();
        linkage.entity = entity;
        linkage.kind = static_cast<std::uint8_t>(kind_);
        linkage.seen = state_.syncs;
        bring(linkage);
    }

    /// Sets a box region. @param corner  px, from the Transform to the top-left corner @param size  px
    void setBox(FieldDefinition& field, const Pose& pose, Vec2 corner, Vec2 size) const {
        const Vec2 reach = scaled(size, {std::abs(pose.scale.x), std::abs(pose.scale.y)});
        field.region = RegionKind::Box;
        field.half = toMetres(reach * 0.5f, state_.scale);
        field.place = positionInMetres(pose.position + corner + reach * 0.5f, state_.scale);
    }

    bool define(const FieldLinkage& linkage, FieldDefinition& field) const {
        Vec2 size;
        if (!kFields[linkage.kind].describe(world_, linkage.entity, field, size, state_.scale.metres))
            return false;
        const Pose pose = worldPose(world_, linkage.entity);
        field.place = positionInMetres(pose.position, state_.scale);
        field.seed = linkage.entity.index;
        if (field.kind == physics::FieldKind::Explosion) return true;
        if (const auto* box = world_.find<BoxCollider>(linkage.entity)) {
            setBox(field, pose, box->offset, {box->width, box->height});
        } else if (const auto* circle = world_.find<CircleCollider>(linkage.entity)) {
            const float scale = std::max(std::abs(pose.scale.x), std::abs(pose.scale.y));
            field.region = RegionKind::Circle;
            field.radius = circle->radius * scale * state_.scale.metres;
            field.place = positionInMetres(pose.position + circle->offset, state_.scale);
        } else if (size != Vec2{}) {
            setBox(field, pose, {}, size);
        }
        if (field.kind == physics::FieldKind::Attractor && field.region == RegionKind::Everywhere) {
            field.a = bodyOf(state_, linkage.entity);  // its own body is the center, and is not attracted
            if (field.a) field.place = {};
        }
        return true;
    }

    void accept(const FieldLinkage& linkage, const Result<Done>& result) {
        if (!result) logRefusal(world_, state_, linkage.entity, result.error());
    }

    const World& world_;
    PhysicsState& state_;
    std::size_t kind_ = 0;
};

}  // namespace

void followFields(World& world, PhysicsState& state, bool all) {
    FieldSync sync{world, state};
    if (all) {
        sync.followAll();
        return;
    }
    for (FieldLinkage& linkage : state.fields) sync.bring(linkage);
}

void removeExploded(World& world, PhysicsState& state) {
    for (const FieldLinkage& linkage : state.fields) {
        if (kFields[linkage.kind].members == fieldRow<Explosion>().members && linkage.made != 0 &&
            !physics::alive(state.world, linkage.field))
            world.remove<Explosion>(linkage.entity);
    }
}

std::uint64_t fieldMembers(const World& world) {
    std::uint64_t members = 0;
    for (const FieldRow& row : kFields) members += row.members(world);
    return members;
}

}  // namespace plumb
