#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

enum class CollectibleKind : std::uint8_t { Coin, Key, Heart };

/// A trigger that a player picks up by touching it.
struct Collectible {
    CollectibleKind kind = CollectibleKind::Coin;  ///< what it counts as
    int value = 1;                                 ///< how many of them it is worth

    static void describe(TypeBuilder<Collectible>& type) {
        type.name("Collectible").doc("A trigger that a player picks up by touching it.");
        type.field<&Collectible::kind>("kind")
            .names({{"coin", 0}, {"key", 1}, {"heart", 2}})
            .doc("What it counts as.");
        type.field<&Collectible::value>("value").range(0.0f, 1000.0f).doc("How many of them it is worth.");
    }
};

}  // namespace plumb
