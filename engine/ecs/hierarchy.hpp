#pragma once

#include <cstdint>

#include "ecs/entity.hpp"
#include "ecs/world.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Links an entity to its parent and its siblings. Written by setParent only.
struct Parent {
    EntityId entity;
    EntityId previous;  ///< the sibling before; empty for the first
    EntityId next;      ///< the sibling after; empty for the last

    static void describe(TypeBuilder<Parent>& type) {
        type.name("Parent").doc("Parent of the entity, which moves and is destroyed with its parent.");
        type.field<&Parent::entity>("entity").doc("The parent entity.");
        type.field<&Parent::previous>("previous").transient();
        type.field<&Parent::next>("next").transient();
    }
};

/// The children of an entity, in the order in which they were attached. Written by setParent only.
struct Children {
    EntityId first;
    EntityId last;
    std::uint32_t count = 0;

    static void describe(TypeBuilder<Children>& type) {
        type.name("Children").doc("The entities that have this one as parent.");
        type.field<&Children::first>("first").transient();
        type.field<&Children::last>("last").transient();
        type.field<&Children::count>("count").transient();
    }
};

/// Makes `child` the last child of `parent`; an empty `parent` makes it a root.
/// @return false, without a change, if that would create a cycle or one of the two does not exist
bool setParent(World& world, EntityId child, EntityId parent);

/// The parent, or the empty handle.
[[nodiscard]] Entity parentOf(World& world, EntityId child);
[[nodiscard]] EntityId parentOf(const World& world, EntityId child);

/// True if `ancestor` is the parent of `entity`, or of its parent, and so on.
[[nodiscard]] bool isAncestor(const World& world, EntityId ancestor, EntityId entity);

/// The children in order, for range-for: `for (Entity child : childrenOf(world, parent))`.
/// The current child may be destroyed or attached to another parent during the loop.
class ChildList {
public:
    class Iterator {
    public:
        Iterator(World& world, EntityId at);
        Entity operator*() const { return {*world_, at_}; }
        Iterator& operator++();
        bool operator!=(const Iterator& other) const { return at_ != other.at_; }

    private:
        World* world_;
        EntityId at_;
        EntityId next_;
    };

    ChildList(World& world, EntityId parent) : world_{&world}, parent_{parent} {}
    [[nodiscard]] Iterator begin() const;
    [[nodiscard]] Iterator end() const { return {*world_, {}}; }
    [[nodiscard]] std::size_t size() const;
    [[nodiscard]] bool empty() const { return size() == 0; }

private:
    World* world_;
    EntityId parent_;
};

[[nodiscard]] inline ChildList childrenOf(World& world, EntityId parent) { return {world, parent}; }

/// The first child; the empty id if there is none.
[[nodiscard]] EntityId firstChildOf(const World& world, EntityId parent);

/// The entity after `at` in the order parent, first child, its children, next child, …; the empty id after
/// the last one below `root`. For forEachBelow().
/// @param down  false: skips the children of `at`
[[nodiscard]] EntityId nextBelow(const World& world, EntityId root, EntityId at, bool down);

/// Calls `visit(EntityId)` for the descendants of an entity, parents before their children, at any depth
/// without recursion. `visit` returns false to skip the descendants of an entity, and must not
/// change the hierarchy.
template <class Visit>
void forEachBelow(const World& world, EntityId root, Visit&& visit) {
    EntityId at = nextBelow(world, root, root, true);
    while (at) at = nextBelow(world, root, at, visit(at));
}

/// First part of World::destroy: destroys the children and detaches the entity from its parent.
void leaveFamily(World& world, EntityId id);

}  // namespace plumb
