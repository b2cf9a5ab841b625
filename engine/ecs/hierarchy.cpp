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
    if (child == parent || (parent && isAncestor(world, child, parent))) return false;
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

ChildList::Iterator ChildList::begin() const {
    const Children* family = world_->find<const Children>(parent_);
    return {*world_, family != nullptr ? family->first : EntityId{}};
}

std::size_t ChildList::size() const {
    const Children* family = world_->find<const Children>(parent_);
    return family != nullptr ? family->count : 0;
}

void leaveFamily(World& world, EntityId id) {
    while (const Children* family = world.find<const Children>(id)) {
        world.destroy(family->first);  // its leaveFamily() removes it from the list
    }
    if (const Parent* link = world.find<const Parent>(id)) {
        unlink(world, Parent{*link});
        world.remove<Parent>(id);
    }
}

}  // namespace plumb
