#pragma once

#include <cstdint>

#include "reflect/type_builder.hpp"

namespace plumb {

/// A paused entity: queries skip it, so that no system updates it. A query that names
/// Paused, or is made with `withPaused`, does include it: for drawing, saving, destroying.
struct Paused {
    std::uint32_t by = 0;  ///< id of the pause, so that only the same one ends it

    static void describe(TypeBuilder<Paused>& type) {
        type.name("Paused").doc("Stands still until what paused it ends.");
        type.field<&Paused::by>("by").transient();
    }
};

/// In a query: includes paused entities, `query<const Sprite>(withPaused)`.
struct WithPaused {};
inline constexpr WithPaused withPaused{};

}  // namespace plumb
