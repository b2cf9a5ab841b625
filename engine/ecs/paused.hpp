#pragma once

#include <cstdint>

#include "reflect/type_builder.hpp"

namespace plumb {

/// The entity stands still: queries leave it out, so that no system touches it. A query that names Paused, or
/// asks for everything with `withPaused`, does find it: for drawing, saving, destroying.
struct Paused {
    std::uint32_t by = 0;  ///< whose pause it is, so that it ends with its own and with no other

    static void describe(TypeBuilder<Paused>& type) {
        type.name("Paused").doc("Stands still until what paused it ends.");
        type.field<&Paused::by>("by").transient();
    }
};

/// In a query: also entities that are paused, `query<const Sprite>(withPaused)`.
struct WithPaused {};
inline constexpr WithPaused withPaused{};

}  // namespace plumb
