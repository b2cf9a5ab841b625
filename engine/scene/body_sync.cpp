#include "scene/body_sync.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/log.hpp"
#include "ecs/hierarchy.hpp"
#include "scene/components/box_collider.hpp"
#include "scene/components/character_body.hpp"
#include "scene/components/circle_collider.hpp"
#include "scene/components/kinematic_body.hpp"
#include "scene/components/rigid_body.hpp"
#include "scene/components/static_body.hpp"
#include "scene/components/tile_collider.hpp"
#include "scene/components/tile_layer.hpp"
#include "scene/physics_bridge.hpp"
#include "scene/physics_state.hpp"
#include "scene/physics_units.hpp"
#include "scene/tile_bodies.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

namespace {

using box_physics::BodyDefinition;
using box_physics::BodyId;
using box_physics::BodyKind;
using box_physics::Shape;

std::uint64_t userOf(EntityId entity) { return std::uint64_t{entity.index} << 32 | entity.generation; }

Shape shapeOf(const BoxCollider& collider, Vec2 scale) {
    const Vec2 size{collider.width * std::abs(scale.x), collider.height * std::abs(scale.y)};
    return Shape::box(toMetres(size * 0.5f), toMetres(collider.offset + size * 0.5f));
}

Shape shapeOf(const CircleCollider& collider, Vec2 scale) {
    const float size = std::max(std::abs(scale.x), std::abs(scale.y));
    return Shape::circle(collider.radius * size * kMetresPerPixel, toMetres(collider.offset));
}

/// A body without collider meets nobody; it only moves.
struct NoCollider {
    std::uint32_t layers = 0;
    std::uint32_t mask = 0;
    bool isTrigger = false;
    bool oneWay = false;
};
Shape shapeOf(const NoCollider&, Vec2) { return Shape::circle(0.01f); }

template <class Collider>
bool isOneWay(const Collider& collider) {
    if constexpr (requires { collider.oneWay; }) {
        return collider.oneWay;
    } else {
        return false;
    }
}

/// Brings the bodies of one world up to date with its components.
class Sync {
public:
    Sync(World& world, float dt) : world_{world}, state_{world.resource<PhysicsState>()}, dt_{dt} {
        ++state_.syncs;
    }

    void run() {
        visit<BoxCollider>();
        visit<CircleCollider>(without<BoxCollider>);
        visitBare();
        visitTiles();
        removeUnseen();
    }

private:
    template <class Collider, class... Filters>
    void visit(Filters... filters) {
        const auto queried = [this](EntityId entity, const Transform& transform, const Collider& collider,
                                    BodyKind kind, const RigidBody* body, const KinematicBody* kinematic) {
            follow(entity, transform, collider, kind, body, kinematic);
        };
        const World& world = world_;
        const auto asId = [](Entity entity) { return entity.id(); };
        for (auto [entity, t, c, body] : world.query<const Transform, const Collider, const RigidBody>(
                 without<CharacterBody>, filters...)) {
            queried(asId(entity), t, c, BodyKind::Dynamic, &body, nullptr);
        }
        for (auto [entity, t, c] :
             world.query<const Transform, const Collider>(with<CharacterBody>, filters...)) {
            queried(asId(entity), t, c, BodyKind::Kinematic, world.find<RigidBody>(entity), nullptr);
        }
        for (auto [entity, t, c, body] : world.query<const Transform, const Collider, const KinematicBody>(
                 without<RigidBody, CharacterBody>, filters...)) {
            queried(asId(entity), t, c, BodyKind::Kinematic, nullptr, &body);
        }
        for (auto [entity, t, c] : world.query<const Transform, const Collider>(
                 without<RigidBody, KinematicBody, CharacterBody>, filters...)) {
            queried(asId(entity), t, c, BodyKind::Static, nullptr, nullptr);
        }
    }

    /// Bodies without any collider still fall and move.
    void visitBare() {
        const World& world = world_;
        for (auto [entity, transform, body] : world.query<const Transform, const RigidBody>(
                 without<BoxCollider, CircleCollider, CharacterBody>)) {
            follow(entity, transform, NoCollider{}, BodyKind::Dynamic, &body, nullptr);
        }
        for (auto [entity, transform, body] : world.query<const Transform, const KinematicBody>(
                 without<BoxCollider, CircleCollider, RigidBody, CharacterBody>)) {
            follow(entity, transform, NoCollider{}, BodyKind::Kinematic, nullptr, &body);
        }
    }

    void visitTiles() {
        const World& world = world_;
        for (auto [entity, transform, layer, collider] :
             world.query<const Transform, const TileLayer, const TileCollider>(
                 without<BoxCollider, CircleCollider, RigidBody, KinematicBody>)) {
            followTiles(entity, transform, layer, collider);
        }
    }

    template <class Collider>
    void follow(EntityId entity, const Transform& transform, const Collider& collider, BodyKind kind,
                const RigidBody* rigid, const KinematicBody* kinematic) {
        Vec2 place = transform.position;
        Vec2 scale = transform.scale;
        if (const EntityId parent = parentOf(std::as_const(world_), entity)) {
            const Pose pose = worldPose(world_, entity);
            place = pose.position;
            scale = pose.scale;
        }
        const Shape shape = shapeOf(collider, scale);
        const Vec2 velocity = rigid != nullptr       ? rigid->velocity
                              : kinematic != nullptr ? kinematic->velocity
                                                     : Vec2{};
        BodyId body = bodyOf(world_, entity);
        if (body && state_.world.bodies.kind[body.index] != kind) {
            box_physics::destroyBody(state_.world, body);
            body = {};
        }
        if (!body) {
            body = create(entity, kind, shape, place, velocity, rigid);
            if (!body) return;
        }
        const std::uint32_t i = body.index;
        BodyLink& link = state_.links[i];
        link.seen = state_.syncs;
        box_physics::Bodies& bodies = state_.world.bodies;
        if (!(bodies.shape[i] == shape)) accept(box_physics::setShape(state_.world, body, shape), entity);
        bodies.layers[i] = collider.layers;
        bodies.mask[i] = collider.mask;
        const bool flagsDiffer = ((bodies.flags[i] & box_physics::kTrigger) != 0) != collider.isTrigger ||
                                 ((bodies.flags[i] & box_physics::kOneWay) != 0) != isOneWay(collider);
        if (flagsDiffer) box_physics::setFlags(state_.world, body, collider.isTrigger, isOneWay(collider));
        if (kind == BodyKind::Kinematic) {
            steer(body, link, place, velocity, rigid);
        } else {
            if (place != link.place) jump(body, link, place);
            if (rigid != nullptr) followRigid(body, link, *rigid);
        }
    }

    /// Somebody put the entity elsewhere: the body goes there without a way.
    void jump(BodyId body, BodyLink& link, Vec2 place) {
        if (!accept(box_physics::setPosition(state_.world, body, toMetres(place)), link.entity)) {
            world_.get<Transform>(link.entity).position = link.place;
            return;
        }
        link.place = place;
    }

    /// A kinematic body goes where its Transform was put, or else as its velocity says.
    void steer(BodyId body, BodyLink& link, Vec2 place, Vec2 velocity, const RigidBody* driver) {
        link.drivenByOwner = driver != nullptr || place != link.place;
        const Vec2 target = link.drivenByOwner ? place : place + velocity * dt_;
        if (!accept(box_physics::moveTo(state_.world, body, toMetres(target)), link.entity)) {
            world_.get<Transform>(link.entity).position = link.place;
        }
    }

    void followRigid(BodyId body, BodyLink& link, const RigidBody& rigid) {
        const std::uint32_t i = body.index;
        box_physics::Bodies& bodies = state_.world.bodies;
        if (rigid.velocity != link.velocity) {
            if (accept(box_physics::setVelocity(state_.world, body, toMetres(rigid.velocity)), link.entity)) {
                link.velocity = rigid.velocity;
            } else {
                world_.get<RigidBody>(link.entity).velocity = link.velocity;
            }
        }
        const Vec2 acceleration = toMetres(rigid.acceleration);
        if (bodies.acceleration[i] != acceleration) {
            accept(box_physics::setAcceleration(state_.world, body, acceleration), link.entity);
        }
        if (bodies.friction[i] != rigid.friction || bodies.bounciness[i] != rigid.bounciness ||
            bodies.gravityScale[i] != rigid.gravityScale) {
            accept(
                box_physics::setSurface(state_.world, body, rigid.friction, rigid.bounciness, rigid.gravityScale),
                link.entity);
        }
        if (bodies.inverseMass[i] != 1.0f / rigid.mass) {
            accept(box_physics::setMass(state_.world, body, rigid.mass), link.entity);
        }
    }

    BodyId create(EntityId entity, BodyKind kind, const Shape& shape, Vec2 place, Vec2 velocity,
                  const RigidBody* rigid) {
        BodyDefinition d;
        d.kind = kind;
        d.shape = shape;
        d.position = toMetres(place);
        d.velocity = toMetres(velocity);
        d.user = userOf(entity);
        if (rigid != nullptr) {
            d.mass = rigid->mass;
            d.friction = rigid->friction;
            d.bounciness = rigid->bounciness;
            d.gravityScale = rigid->gravityScale;
            d.acceleration = toMetres(rigid->acceleration);
        }
        const auto body = box_physics::createBody(state_.world, d);
        if (!body) {
            tell(entity, body.error());
            return {};
        }
        adopt(*body, entity, place, velocity);
        return *body;
    }

    void adopt(BodyId body, EntityId entity, Vec2 place, Vec2 velocity) {
        if (state_.links.size() <= body.index) state_.links.resize(state_.world.bodies.size());
        if (state_.bodyOf.size() <= entity.index) state_.bodyOf.resize(entity.index + 1);
        state_.links[body.index] = {};
        state_.links[body.index].entity = entity;
        state_.links[body.index].place = place;
        state_.links[body.index].velocity = velocity;
        state_.links[body.index].seen = state_.syncs;
        state_.bodyOf[entity.index] = body.index + 1;
    }

    void followTiles(EntityId entity, const Transform& transform, const TileLayer& layer,
                     const TileCollider& collider) {
        const TileGrid* grid = world_.tiles().find(layer.cells);
        if (grid == nullptr || grid->width() == 0 || grid->height() == 0) return;
        BodyId body = bodyOf(world_, entity);
        if (!body) {
            BodyDefinition d;
            d.kind = BodyKind::Static;
            d.position = toMetres(transform.position);
            d.user = userOf(entity);
            const auto made = box_physics::createBody(state_.world, d);
            if (!made) return tell(entity, made.error());
            body = *made;
            adopt(body, entity, transform.position, {});
            state_.world.bodies.shape[body.index].field =
                box_physics::addField(state_.world, std::make_shared<const box_physics::TileField>());
        }
        BodyLink& link = state_.links[body.index];
        link.seen = state_.syncs;
        box_physics::Bodies& bodies = state_.world.bodies;
        const Vec2 size = tileSizeOf(world_, layer);
        if (link.tilesVersion != grid->version() || link.tiles != layer.cells ||
            link.tileset != layer.tileset || link.tileSize != size) {
            const std::uint32_t number = bodies.shape[body.index].field;
            box_physics::replaceField(state_.world, number,
                                  std::make_shared<const box_physics::TileField>(tileFieldOf(world_, layer)));
            accept(box_physics::setShape(state_.world, body, box_physics::shapeOfField(state_.world, number)),
                   entity);
            link.tilesVersion = grid->version();
            link.tiles = layer.cells;
            link.tileset = layer.tileset;
            link.tileSize = size;
        }
        box_physics::setFilter(state_.world, body, collider.layers, collider.mask);
        bodies.friction[body.index] = collider.friction;
        bodies.bounciness[body.index] = std::clamp(collider.bounciness, 0.0f, 1.0f);
        if (transform.position != link.place) jump(body, link, transform.position);
    }

    void removeUnseen() {
        for (std::uint32_t i = 0; i < state_.links.size(); ++i) {
            BodyLink& link = state_.links[i];
            if (!link.entity || link.seen == state_.syncs) continue;
            if (state_.bodyOf[link.entity.index] == i + 1) state_.bodyOf[link.entity.index] = 0;
            const Shape& shape = state_.world.bodies.shape[i];
            if (shape.kind == box_physics::ShapeKind::Tiles)
                box_physics::replaceField(state_.world, shape.field, nullptr);
            box_physics::destroyBody(state_.world, {i, state_.world.bodies.generation[i]});
            link = {};
        }
    }

    bool accept(const Result<Done>& result, EntityId entity) {
        if (!result) tell(entity, result.error());
        return result.ok();
    }

    /// Once per entity, or a broken one would fill the log.
    void tell(EntityId entity, const Error& error) {
        if (std::find(state_.refused.begin(), state_.refused.end(), entity) != state_.refused.end()) return;
        state_.refused.push_back(entity);
        logWarning("Physics", Error{format("entity {}", entity.index), error.what, error.remedy});
    }

    World& world_;
    PhysicsState& state_;
    float dt_;
};

}  // namespace

bool hasColliders(const World& world) {
    return world.count<BoxCollider>() > 0 || world.count<CircleCollider>() > 0 ||
           world.count<TileCollider>() > 0;
}

box_physics::Settings physicsSettingsOf(World& world) {
    box_physics::Settings settings;
    settings.gravity = toMetres(world.resource<PhysicsSettings>().gravity);
    return settings;
}

void syncBodies(World& world, float dt) { Sync{world, dt}.run(); }

}  // namespace plumb
