#pragma once

#include <compare>
#include <cstdint>

namespace plumb {

/// Names an entity: its place, and how often the place was used before, so that an old name never means
/// a new entity. Plain data, for components that refer to others. The default names nobody.
struct EntityId {
    std::uint32_t index = 0;
    std::uint32_t generation = 0;

    explicit constexpr operator bool() const { return index != 0; }
    friend constexpr auto operator<=>(EntityId, EntityId) = default;
};

}  // namespace plumb
