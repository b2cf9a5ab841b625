#include "editor/model/document/scene_boxes.hpp"

#include <limits>
#include <utility>

#include "ecs/hierarchy.hpp"
#include "editor/model/document/bounds.hpp"
#include "scene/components.hpp"
#include "scene/physics/soft_sync.hpp"

namespace plumb::editor {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr AABB kNoBox{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};

/// Calls `f` with the component types that change an entity's box (boundsOf). Transform is not among them: it
/// also moves the boxes of descendants.
template <class F>
void eachSeen(F&& f) {
    f.template operator()<Sprite, Label, BoxCollider, CircleCollider, CapsuleCollider, PolygonCollider,
                          ChainCollider, WindField, GravityField, BuoyancyField, Attractor>();
}

std::uint64_t membersOf(const World& world) {
    std::uint64_t sum = softMembers(world) + world.memberships<Transform, Parent, TileLayer>();
    eachSeen([&]<class... T>() { sum += world.memberships<T...>(); });
    return sum;
}

}  // namespace

void SceneBoxes::follow(const Document& document) {
    const World& world = document.world;
    const std::uint64_t members = membersOf(world);
    if (tree_ != document.treeRevision || members_ != members) {
        tree_ = document.treeRevision;
        members_ = members;
        makeAll(document);
    } else {
        ++pass_;
        world.eachChangedSince<Transform>(mark_, [&](EntityId entity) { updateMoved(document, entity); });
        eachSeen([&]<class... T>() {
            (world.eachChangedSince<T>(mark_, [&](EntityId entity) { update(document, entity); }), ...);
        });
        for (const EntityId entity : restless_) update(document, entity);
    }
    // Marking changes no component, so the document stays logically const.
    mark_ = const_cast<World&>(world).markChanges();
}

void SceneBoxes::makeAll(const Document& document) {
    const World& world = document.world;
    const std::vector<ObjectId>& all = document.objects();
    boxes_.assign(all.size(), kNoBox);
    passOf_.assign(all.size(), pass_);
    entities_.clear();
    placeOf_.clear();
    restless_.clear();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const EntityId entity = entities_.emplace_back(document.find(all[i]));
        if (placeOf_.size() <= entity.index) placeOf_.resize(entity.index + 1, kNowhere);
        placeOf_[entity.index] = static_cast<std::uint32_t>(i);
        update(document, entity);
        // Tile grids can grow and soft bodies can move without a component write.
        if (world.has<TileLayer>(entity) || softBounds(world, entity)) restless_.push_back(entity);
    }
}

void SceneBoxes::update(const Document& document, EntityId entity) {
    if (entity.index >= placeOf_.size()) return;
    const std::uint32_t place = placeOf_[entity.index];
    if (place == kNowhere || entities_[place] != entity) return;
    boxes_[place] = hasTransform(document.world, entity) ? boundsOf(document.world, entity) : kNoBox;
}

void SceneBoxes::updateMoved(const Document& document, EntityId entity) {
    if (entity.index < placeOf_.size() && placeOf_[entity.index] != kNowhere &&
        std::exchange(passOf_[placeOf_[entity.index]], pass_) == pass_)
        return;
    update(document, entity);
    const World& world = document.world;
    const Children* family = world.find<Children>(entity);
    EntityId child = family == nullptr ? EntityId{} : family->first;
    for (const Parent* link = nullptr; child; child = link->next) {
        updateMoved(document, child);
        link = world.find<Parent>(child);
    }
}

}  // namespace plumb::editor
