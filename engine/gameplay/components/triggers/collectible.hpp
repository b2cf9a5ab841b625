#pragma once

#include "reflect/type_builder.hpp"

namespace plumb {

enum class CollectibleKind : std::uint8_t { Coin, Key, Heart };

/// A trigger that a player picks up by touching it.
struct Collectible {
    CollectibleKind kind = CollectibleKind::Coin;  ///< kind of item
    int value = 1;                                 ///< number of coins, keys or health points it adds

    static void describe(TypeBuilder<Collectible>& type) {
        type.name("Collectible").doc("A trigger that a player picks up by touching it.");
        type.field<&Collectible::kind>("kind")
            .names({{"coin", 0}, {"key", 1}, {"heart", 2}})
            .doc("Kind of item: coin, key, or heart, which restores health.");
        type.field<&Collectible::value>("value")
            .range(0.0f, 1000.0f)
            .doc("Number of coins, keys or health points it adds.");
    }
};

}  // namespace plumb
