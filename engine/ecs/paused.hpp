#pragma once

#include <cstdint>

#include "reflect/type_builder.hpp"

namespace plumb {

/// Marks a paused entity: queries skip it, so that no system updates it. A query that names
/// Paused or withPaused includes it: for drawing, saving, destroying.
struct Paused {
    std::uint32_t by = 0;  ///< id of the pause that stopped the entity; only that pause ends it

    static void describe(TypeBuilder<Paused>& type) {
        type.name("Paused").doc("Stops the updates of the entity until the pause ends.");
        type.field<&Paused::by>("by").transient();
    }
};

/// Query filter: includes paused entities, `query<const Sprite>(withPaused)`.
struct WithPaused {};
inline constexpr WithPaused withPaused{};

}  // namespace plumb
