#include "scene/physics/soft_sync.hpp"

#include <algorithm>
#include <utility>

#include "core/hash.hpp"
#include "scene/components/bodies/cloth.hpp"
#include "scene/components/bodies/jelly.hpp"
#include "scene/components/bodies/rope.hpp"
#include "scene/physics/entity_bodies.hpp"

namespace plumb {

namespace {

using physics::SoftBodyId;
using physics::WorldPosition;

/// Functions of a soft body component type.
struct SoftRow {
    const SoftLook* (*find)(const World& world, EntityId entity);
    Result<SoftBodyId> (*make)(const SoftLook& look, physics::World& world, WorldPosition at, float metres);
    bool (*isPinned)(const SoftLook& look, int particle);
    void (*addTo)(const SoftLook& look, Hasher& hasher);
    AABB (*box)(const SoftLook& look);
    std::uint64_t (*members)(const World& world);
    std::size_t (*count)(const World& world);
    void (*forEach)(const World& world, void (*visit)(void*, EntityId), void* context);
};

template <class Component>
constexpr SoftRow softRow() {
    SoftRow row{};
    row.find = [](const World& world, EntityId entity) -> const SoftLook* {
        return world.find<Component>(entity);
    };
    row.make = [](const SoftLook& look, physics::World& world, WorldPosition at, float metres) {
        return static_cast<const Component&>(look).make(world, at, metres);
    };
    row.isPinned = [](const SoftLook& look, int particle) {
        return static_cast<const Component&>(look).isPinned(particle);
    };
    row.box = [](const SoftLook& look) { return static_cast<const Component&>(look).box(); };
    row.count = [](const World& world) { return world.count<Component>(); };
    row.members = [](const World& world) { return world.memberships<Component>(); };
    row.addTo = [](const SoftLook& look, Hasher& hasher) {
        static_cast<const Component&>(look).addTo(hasher);
    };
    row.forEach = [](const World& world, void (*visit)(void*, EntityId), void* context) {
        for (auto [entity, soft] : world.query<const Component>()) visit(context, entity.id());
    };
    return row;
}

constexpr SoftRow kSoft[] = {softRow<Rope>(), softRow<Cloth>(), softRow<Jelly>()};

/// Returns the linkage of an entity's soft body of this kind; null if it does not exist.
const SoftLinkage* linkageOf(const PhysicsState& state, EntityId entity, std::size_t kind) {
    for (const SoftLinkage& linkage : state.softBodies) {
        if (linkage.entity == entity && linkage.kind == kind && physics::alive(state.world, linkage.body))
            return &linkage;
    }
    return nullptr;
}

std::uint64_t softHash(const SoftRow& row, const SoftLook& look, Vec2 place) {
    Hasher hasher;
    row.addTo(look, hasher);
    hasher.add(place.x), hasher.add(place.y);
    return hasher.value() | 1;
}

class SoftSync {
public:
    SoftSync(World& world, PhysicsState& state) : world_{world}, state_{state} {}

    void followAll() {
        for (kind_ = 0; kind_ < std::size(kSoft); ++kind_) {
            kSoft[kind_].forEach(
                world_, [](void* sync, EntityId entity) { static_cast<SoftSync*>(sync)->follow(entity); },
                this);
        }
        std::erase_if(state_.softBodies, [this](const SoftLinkage& linkage) {
            if (linkage.seen == state_.syncs) return false;
            physics::destroySoftBody(state_.world, linkage.body);
            return true;
        });
    }

    void bring(SoftLinkage& linkage) {
        const SoftLook* look = softLookOf(world_, linkage);
        if (look == nullptr) return;
        const SoftRow& row = kSoft[linkage.kind];
        const Vec2 place = worldPose(world_, linkage.entity).position;
        const std::uint64_t from = softHash(row, *look, place);
        if (from == linkage.made) return;
        linkage.made = from;
        physics::destroySoftBody(state_.world, linkage.body);
        linkage.body = {};
        const auto made =
            row.make(*look, state_.world, positionInMetres(place, state_.scale), state_.scale.metres);
        if (!made) {
            logRefusal(world_, state_, linkage.entity, made.error());
            return;
        }
        linkage.body = *made;
        const auto count = static_cast<int>(particlesOf(state_.world, *made).size());
        for (int i = 0; i < count; ++i) {
            if (row.isPinned(*look, i)) static_cast<void>(pinParticle(state_.world, *made, i, true));
        }
    }

private:
    void follow(EntityId entity) {
        const auto known = std::find_if(
            state_.softBodies.begin(), state_.softBodies.end(),
            [&](const SoftLinkage& linkage) { return linkage.entity == entity && linkage.kind == kind_; });
        SoftLinkage& linkage = known != state_.softBodies.end() ? *known : state_.softBodies.emplace_back();
        linkage.entity = entity;
        linkage.kind = static_cast<std::uint8_t>(kind_);
        linkage.seen = state_.syncs;
    }

    const World& world_;
    PhysicsState& state_;
    std::size_t kind_ = 0;
};

}  // namespace

bool hasSoftBodies(const World& world) {
    return std::any_of(std::begin(kSoft), std::end(kSoft),
                       [&](const SoftRow& row) { return row.count(world) > 0; });
}

std::optional<AABB> softBounds(const World& world, EntityId entity) {
    std::optional<AABB> bounds;
    const auto add = [&](const AABB& box) { bounds = bounds ? merged(*bounds, box) : box; };
    const auto* state = world.findResource<PhysicsState>();
    for (std::size_t kind = 0; kind < std::size(kSoft); ++kind) {
        const SoftLook* look = kSoft[kind].find(world, entity);
        if (look == nullptr) continue;
        const SoftLinkage* linkage = state == nullptr ? nullptr : linkageOf(*state, entity, kind);
        const float margin = 0.5f * look->thickness;
        if (linkage == nullptr) {
            const Vec2 place = worldPose(world, entity).position;
            const AABB box = kSoft[kind].box(*look);
            add(grown({place + box.min, place + box.max}, margin));
            continue;
        }
        for (const physics::SoftParticle& particle : particlesOf(state->world, linkage->body)) {
            const Vec2 place = positionInPixels(particle.place, state->scale);
            add(grown({place, place}, margin));
        }
    }
    return bounds;
}

const SoftLook* softLookOf(const World& world, const SoftLinkage& linkage) {
    return kSoft[linkage.kind].find(world, linkage.entity);
}

void followSoftBodies(World& world, PhysicsState& state, bool all) {
    SoftSync sync{world, state};
    if (all) sync.followAll();
    for (SoftLinkage& linkage : state.softBodies) sync.bring(linkage);
}

std::uint64_t softMembers(const World& world) {
    std::uint64_t members = 0;
    for (const SoftRow& row : kSoft) members += row.members(world);
    return members;
}

}  // namespace plumb
