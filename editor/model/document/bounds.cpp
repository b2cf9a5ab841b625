#include "editor/model/document/bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "editor/model/document/scene_boxes.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/document/visibility.hpp"
#include "math/angle.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/colliders/capsule_collider.hpp"
#include "scene/components/colliders/chain_collider.hpp"
#include "scene/components/colliders/circle_collider.hpp"
#include "scene/components/colliders/polygon_collider.hpp"
#include "scene/components/drawing/label.hpp"
#include "scene/components/drawing/parallax_layer.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/drawing/tile_layer.hpp"
#include "scene/components/fields/attractor.hpp"
#include "scene/components/fields/buoyancy_field.hpp"
#include "scene/components/fields/gravity_field.hpp"
#include "scene/components/fields/wind_field.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/transform.hpp"
#include "scene/files/rough_text.hpp"
#include "scene/physics/soft_sync.hpp"
#include "scene/physics/tile_bodies.hpp"
#include "scene/world_transform.hpp"

namespace plumb::editor {
namespace {

constexpr float kMarkSize = 8.0f;  // px, half a side of the box of an entity with nothing to draw

AABB turnedBox(const Pose& pose, Vec2 from, Vec2 size) {
    const std::array<Vec2, 4> corners{from, from + Vec2{size.x, 0.0f}, from + size,
                                      from + Vec2{0.0f, size.y}};
    AABB box;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 at = pose.position + rotated(scaled(corners[i], pose.scale), pose.rotation);
        box = i == 0 ? AABB{at, at} : AABB{min(box.min, at), max(box.max, at)};
    }
    return box;
}

/// Calls add(box) with boxes (px, world) that cover the entity's colliders. The entity's scale applies
/// to the points of outlines, but not to the offsets of boxes, capsules and circles.
template <class Add>
void addColliders(const World& world, EntityId entity, const Pose& pose, Add&& add) {
    const Pose turned{pose.position, pose.rotation, {1.0f, 1.0f}};
    const Vec2 size{std::abs(pose.scale.x), std::abs(pose.scale.y)};
    if (const auto* box = world.find<BoxCollider>(entity))
        add(turnedBox(turned, box->offset, scaled({box->width, box->height}, size)));
    if (const auto* capsule = world.find<CapsuleCollider>(entity))
        add(turnedBox(turned, capsule->offset, scaled({capsule->width, capsule->height}, size)));
    if (const auto* circle = world.find<CircleCollider>(entity)) {
        const float radius = circle->radius * std::max(size.x, size.y);
        const Vec2 center = pose.position + rotated(circle->offset, pose.rotation);
        add(grown({center, center}, radius));
    }
    const auto addPoints = [&](const auto& points, Vec2 offset, float margin) {
        for (const Vec2 point : points) {
            const Vec2 at = pose.position + rotated(scaled(point + offset, pose.scale), pose.rotation);
            add(grown({at, at}, margin));
        }
    };
    if (const auto* polygon = world.find<PolygonCollider>(entity))
        addPoints(polygon->points, polygon->offset, polygon->rounding);
    if (const auto* chain = world.find<ChainCollider>(entity)) addPoints(chain->points, {}, 0.0f);
}

int layerOf(const World& world, EntityId entity) {
    if (const Sprite* sprite = world.find<Sprite>(entity)) return sprite->layer;
    if (const Label* label = world.find<Label>(entity)) return label->layer;
    if (const TileLayer* tiles = world.find<TileLayer>(entity)) return tiles->layer;
    return 0;
}

/// Returns the size of a force field's region, px, from the Transform's position on; zero for an entity with
/// a sprite or collider, by which it is picked instead.
Vec2 regionOf(const World& world, EntityId entity) {
    if (world.has<Sprite>(entity) || world.has<BoxCollider>(entity) || world.has<CircleCollider>(entity))
        return {};
    const FieldRegion* region = nullptr;
    const auto look = [&](const FieldRegion* field) { region = field != nullptr ? field : region; };
    look(world.find<WindField>(entity));
    look(world.find<GravityField>(entity));
    look(world.find<BuoyancyField>(entity));
    look(world.find<Attractor>(entity));
    return region != nullptr ? region->size : Vec2{};
}

/// True if the entity is a tile layer without a tile at the point, so that entities behind it can be picked.
bool isHole(const Document& document, ObjectId id, EntityId entity, Vec2 point) {
    const auto* layer = document.world.find<TileLayer>(entity);
    const TileGrid* grid = layer != nullptr ? document.world.tiles().find(layer->cells) : nullptr;
    if (grid == nullptr) return false;
    const CellPlace place = cellAt(document, id, point);
    return !grid->has(place.x, place.y) || grid->at(place.x, place.y) == 0;
}

/// Returns the root of the prefab instance that the entity is a part of, unless the part is selected already.
ObjectId pickTarget(const Document& document, ObjectId id) {
    const PrefabPart* part = document.world.find<PrefabPart>(document.find(id));
    if (part == nullptr || document.selection.has(id)) return id;
    const ObjectId root{part->instance};
    return document.find(root) ? root : id;
}

}  // namespace

bool isBackground(const Document& document, EntityId entity) {
    const World& world = document.world;
    if (world.has<TileLayer>(entity) || world.has<ParallaxLayer>(entity)) return true;
    if (regionOf(world, entity) != Vec2{}) return true;
    if (!world.has<Sprite>(entity)) return false;
    const Vec2 size = boundsOf(world, entity).size();
    return size.x >= document.picture.x && size.y >= document.picture.y;
}

bool hasTransform(const World& world, EntityId entity) {
    return world.alive(entity) && world.has<Transform>(entity);
}

AABB boundsOf(const World& world, EntityId entity) {
    const Pose pose = worldPose(world, entity);
    std::optional<AABB> box;
    const auto add = [&](const AABB& part) { box = box ? merged(*box, part) : part; };
    if (const Sprite* sprite = world.find<Sprite>(entity)) {
        const Vec2 size{static_cast<float>(sprite->width), static_cast<float>(sprite->height)};
        add(turnedBox(pose, -scaled(sprite->pivot, size), size));
    }
    if (const TileLayer* layer = world.find<TileLayer>(entity)) {
        if (const TileGrid* grid = world.tiles().find(layer->cells)) {
            const Vec2 cells{static_cast<float>(grid->width()), static_cast<float>(grid->height())};
            add(turnedBox(pose, {}, scaled(tileSizeOf(world, *layer), cells)));
        }
    }
    if (const Label* label = world.find<Label>(entity)) {
        const AABB text = roughTextBox(world, *label);
        add(turnedBox(pose, text.min, text.size()));
    }
    addColliders(world, entity, pose, add);
    if (const auto soft = softBounds(world, entity)) add(*soft);
    if (const Vec2 size = regionOf(world, entity); size != Vec2{})
        add({pose.position, pose.position + scaled(size, {std::abs(pose.scale.x), std::abs(pose.scale.y)})});
    if (!box) return grown({pose.position, pose.position}, kMarkSize);
    return {min(box->min, box->max), max(box->min, box->max)};
}

std::optional<AABB> boundsOf(const Document& document, const std::vector<ObjectId>& objects) {
    std::optional<AABB> box;
    for (const ObjectId id : objects) {
        const EntityId entity = document.find(id);
        if (!hasTransform(document.world, entity)) continue;
        const AABB part = boundsOf(document.world, entity);
        if (isFinite(part.min) && isFinite(part.max)) box = box ? merged(*box, part) : part;
    }
    return box;
}

std::vector<ObjectId> pickAll(const Document& document, Vec2 point, float reach) {
    struct Hit {
        bool ground;
        int layer;
        std::size_t place;
        ObjectId id;
    };
    std::vector<Hit> hits;
    const std::vector<ObjectId>& all = document.objects();
    const SceneBoxes& boxes = document.boxes();
    boxes.eachTouching(grown({point, point}, reach), [&](std::size_t i) {
        const EntityId entity = document.find(all[i]);
        if (isHiddenOrLocked(document, all[i]) || isHole(document, all[i], entity, point)) return;
        hits.push_back({isBackground(document, entity), layerOf(document.world, entity), i, all[i]});
    });
    std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
        if (a.ground != b.ground) return b.ground;
        return a.layer != b.layer ? a.layer > b.layer : a.place > b.place;
    });
    std::vector<ObjectId> ids;
    for (const Hit& hit : hits) {
        ids.push_back(hit.id);
    }
    return ids;
}

ObjectId pickFirst(const Document& document, Vec2 point, float reach) {
    const std::vector<ObjectId> hits = pickAll(document, point, reach);
    return hits.empty() ? ObjectId{} : pickTarget(document, hits.front());
}

std::vector<ObjectId> pickInside(const Document& document, const AABB& box) {
    std::vector<ObjectId> ids;
    std::set<std::uint64_t> taken;  // several parts of one instance may touch the box
    const std::vector<ObjectId>& all = document.objects();
    const SceneBoxes& boxes = document.boxes();
    boxes.eachTouching(box, [&](std::size_t i) {
        if (!intersects(boxes.at(i), box)) return;
        if (isHiddenOrLocked(document, all[i]) || isBackground(document, document.find(all[i]))) return;
        const ObjectId meant = pickTarget(document, all[i]);
        if (taken.insert(meant.value).second) ids.push_back(meant);
    });
    return ids;
}

}  // namespace plumb::editor
