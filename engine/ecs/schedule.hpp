#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ecs/component_type.hpp"
#include "reflect/type_key.hpp"

namespace plumb {

class Profile;
class World;

/// A system with a name for the order table: `static constexpr std::string_view kName`.
template <class S>
concept NamedSystem = requires {
    std::string_view{S::kName};
};

/// The systems of a world, in the order in which they run.
class Schedule {
public:
    /// Adds a system; if there is one of the same type already, returns it.
    template <class S, class... Arguments>
    S& add(Arguments&&... arguments) {
        if (S* known = find<S>()) return *known;
        auto box = std::make_unique<BoxOf<S>>(std::forward<Arguments>(arguments)...);
        S& system = box->system;
        insert(std::move(box));
        return system;
    }
    template <class S>
    [[nodiscard]] S* find() const {
        Box* box = find(typeKey<S>());
        return box != nullptr ? &static_cast<BoxOf<S>*>(box)->system : nullptr;
    }

    /// Removes the system of this type; does nothing if there is none.
    void remove(TypeKey key);

    /// Systems named here run in this order, the others after them in the order in which they were added.
    void setOrder(std::span<const std::string_view> names);
    [[nodiscard]] std::vector<std::string_view> names() const;

    /// Runs every system once and applies the world's commands after each.
    /// @param profile  receives the time of each system; may be null
    void run(World& world, float dt, Profile* profile) const;

private:
    struct Box {
        TypeKey key = 0;
        std::string_view name;
        std::size_t added = 0;  // number of systems added before it

        virtual ~Box() = default;
        virtual void update(World& world, float dt) = 0;
    };
    template <class S>
    struct BoxOf final : Box {
        S system;

        template <class... Arguments>
        explicit BoxOf(Arguments&&... arguments) : system{std::forward<Arguments>(arguments)...} {
            key = typeKey<S>();
            if constexpr (NamedSystem<S>) {
                name = S::kName;
            } else {
                name = shortTypeName<S>();
            }
        }
        void update(World& world, float dt) override { system.update(world, dt); }
    };

    [[nodiscard]] Box* find(TypeKey key) const;
    void insert(std::unique_ptr<Box> box);
    void sort();

    std::vector<std::unique_ptr<Box>> boxes_;
    std::vector<std::string> order_;
    std::size_t added_ = 0;  // number of systems that were ever added
};

}  // namespace plumb
