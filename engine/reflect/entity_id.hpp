#pragma once

#include <compare>
#include <cstdint>

namespace plumb {

/// Identifies an entity by its index and its generation, which changes with every reuse of the index, so that
/// a stale id never refers to a new entity. Plain data, for use in components. The default is no entity.
struct EntityId {
    std::uint32_t index = 0;
    std::uint32_t generation = 0;

    explicit constexpr operator bool() const { return index != 0; }
    friend constexpr auto operator<=>(EntityId, EntityId) = default;
};

}  // namespace plumb
