#pragma once

#include <compare>

#include "reflect/entity_id.hpp"

namespace plumb {

class World;

/// A handle to an entity of a world: small, copyable, and checked. The handle of a destroyed entity
/// stays invalid: alive() is false, find() returns nullptr, and get() reports an error.
/// The functions are defined in ecs/world.hpp.
class Entity {
public:
    Entity() = default;
    Entity(World& world, EntityId id) : world_{&world}, id_{id} {}

    /// Adds a component, or replaces the existing one. A constructor of T may take World& first.
    template <class T, class... Arguments>
    T& addComponent(Arguments&&... arguments) const;
    template <class T>
    void removeComponent() const;
    template <class T>
    [[nodiscard]] bool hasComponent() const;
    /// @pre the entity is alive and has the component
    template <class T>
    T& get() const;
    /// nullptr if the entity does not exist or has no such component.
    template <class T>
    [[nodiscard]] T* find() const;

    void destroy() const;
    [[nodiscard]] bool alive() const;
    explicit operator bool() const { return alive(); }

    [[nodiscard]] EntityId id() const { return id_; }
    operator EntityId() const { return id_; }
    [[nodiscard]] World& world() const { return *world_; }

    friend bool operator==(Entity a, Entity b) { return a.world_ == b.world_ && a.id_ == b.id_; }
    /// Orders by index, then by generation: independent of addresses.
    friend std::strong_ordering operator<=>(Entity a, Entity b) { return a.id_ <=> b.id_; }

private:
    World* world_ = nullptr;
    EntityId id_;
};

}  // namespace plumb
