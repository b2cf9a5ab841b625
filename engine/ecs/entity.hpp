#pragma once

#include <compare>

#include "reflect/entity_id.hpp"

namespace plumb {

class World;

/// A handle to an entity of a world: small, copyable, and checked. The handle of a destroyed entity
/// stays invalid, as the empty handle is, which functions return that found nothing: alive() is false,
/// find() returns nullptr, removeComponent() and destroy() do nothing.
///
/// get() and addComponent() must return a reference: without the entity, or get() without the component,
/// they report an error that names the running system, the component and the entity (an assertion fails;
/// without assertions it is logged, for each system and component once in a scene), and return a component
/// that belongs to no entity and whose bytes are 0.
///
/// The functions are defined in ecs/world.hpp.
class Entity {
public:
    Entity() = default;
    Entity(World& world, EntityId id) : world_{&world}, id_{id} {}

    /// Adds a component, or replaces the existing one. A constructor of T may take World& first.
    /// @pre alive()
    template <class T, class... Arguments>
    T& addComponent(Arguments&&... arguments) const;
    template <class T>
    void removeComponent() const;
    template <class T>
    [[nodiscard]] bool hasComponent() const;
    /// @pre the entity is alive and has the component; use find() where that is not certain
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
    /// @pre not the empty handle, which belongs to no world; stops the program
    [[nodiscard]] World& world() const;

    friend bool operator==(Entity a, Entity b) { return a.world_ == b.world_ && a.id_ == b.id_; }
    /// Orders by index, then by generation: independent of addresses.
    friend std::strong_ordering operator<=>(Entity a, Entity b) { return a.id_ <=> b.id_; }

private:
    World* world_ = nullptr;
    EntityId id_;
};

}  // namespace plumb
