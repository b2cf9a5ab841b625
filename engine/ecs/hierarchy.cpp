#include "ecs/hierarchy.hpp"

namespace plumb {

namespace {

/// Removes a child from its parent's list; the caller has to remove or replace its Parent component.
void unlink(World& world, const Parent& link) {
    if (Parent* previous = world.find<Parent>(link.previous)) previous->next = link.next;
    if (Parent* next = world.find<Parent>(link.next)) next->previous = link.previous;
    Children* family = world.find<Children>(link.entity);
    if (family == nullptr) return;
    if (!link.previous) family->first = link.next;
    if (!link.next) family->last = link.previous;
    if (--family->count == 0) world.remove<Children>(link.entity);
}

}  // namespace

bool setParent(World& world, EntityId child, EntityId parent) {
    if (!world.alive(child) || (parent && !world.alive(parent))) return false;
    // A chain is built in linear time: an entity without children is an ancestor of none.
    const bool mayBeAbove = parent && world.has<Children>(child);
    if (child == parent || (mayBeAbove && isAncestor(world, child, parent))) return false;
    if (const Parent* link = world.find<const Parent>(child)) {
        if (link->entity == parent) return true;
        unlink(world, Parent{*link});
        world.remove<Parent>(child);
    }
    if (!parent) return true;
    if (!world.has<Children>(parent)) world.add<Children>(parent);
    Children& family = world.get<Children>(parent);
    const Parent link{parent, family.last, {}};
    if (Parent* last = world.find<Parent>(family.last)) last->next = child;
    if (!family.first) family.first = child;
    family.last = child;
    ++family.count;
    world.add<Parent>(child, link);
    return true;
}

Entity parentOf(World& world, EntityId child) {
    const EntityId parent = parentOf(static_cast<const World&>(world), child);
    return parent ? world.entity(parent) : Entity{};
}

EntityId parentOf(const World& world, EntityId child) {
    const Parent* link = world.find<Parent>(child);
    return link != nullptr ? link->entity : EntityId{};
}

bool isAncestor(const World& world, EntityId ancestor, EntityId entity) {
    for (EntityId at = parentOf(world, entity); at; at = parentOf(world, at)) {
        if (at == ancestor) return true;
    }
    return false;
}

ChildList::Iterator::Iterator(World& world, EntityId at) : world_{&world}, at_{at} {
    if (const Parent* link = world.find<const Parent>(at)) next_ = link->next;
}

ChildList::Iterator& ChildList::Iterator::operator++() {
    *this = Iterator{*world_, next_};
    return *this;
}

ChildList::Iterator ChildList::begin() const { return {*world_, firstChildOf(*world_, parent_)}; }

std::size_t ChildList::size() const {
    const Children* family = world_->find<const Children>(parent_);
    return family != nullptr ? family->count : 0;
}

void leaveFamily(World& world, EntityId id) {
    // Without recursion, as a chain of entities may be of any length: destroys the first entity
    // below `id` that has no children, until there is none.
    EntityId at = id;
    while (true) {
        if (const Children* family = world.find<const Children>(at)) {
            const Parent* link = world.find<const Parent>(family->first);
            if (link != nullptr && link->entity == at) {
                at = family->first;
            } else {
                world.remove<Children>(at);  // not written by setParent()
            }
            continue;
        }
        const Parent* link = world.find<const Parent>(at);
        const EntityId above = link != nullptr ? link->entity : EntityId{};
        if (link != nullptr) {
            unlink(world, Parent{*link});
            world.remove<Parent>(at);
        }
        if (at == id) return;
        world.destroy(at);
        at = above;
    }
}

EntityId firstChildOf(const World& world, EntityId parent) {
    const Children* family = world.find<Children>(parent);
    return family != nullptr ? family->first : EntityId{};
}

EntityId nextBelow(const World& world, EntityId root, EntityId at, bool down) {
    if (down) {
        if (const EntityId child = firstChildOf(world, at)) return child;
    }
    while (at && at != root) {
        const Parent* link = world.find<Parent>(at);
        if (link == nullptr) return {};
        if (link->next) return link->next;
        at = link->entity;
    }
    return {};
}

}  // namespace plumb
