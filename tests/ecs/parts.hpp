#pragma once

#include <cstdint>

#include "ecs/world.hpp"

namespace plumb {

// Components shared by the tests of this folder, some with reflection and some without.

struct Position {
    float x = 0.0f;
    float y = 0.0f;

    Position() = default;
    Position(float px, float py) : x{px}, y{py} {}

    static void describe(TypeBuilder<Position>& type) {
        type.name("Position");
        type.field<&Position::x>("x");
        type.field<&Position::y>("y");
    }
};

struct Velocity {
    float x = 0.0f;
    float y = 0.0f;
};

struct Health {
    int points = 0;
    int armour = 0;
    int shield = 0;
};

/// References a tile grid of the world, like TileLayer.
struct Tiled {
    TilesId cells;
    int layer = 0;

    static void describe(TypeBuilder<Tiled>& type) {
        type.name("Tiled");
        type.field<&Tiled::cells>("cells");
        type.field<&Tiled::layer>("layer");
    }
};

struct Frozen {};
struct Player {};

/// One of many component types with the same fields.
template <int N>
struct Numbered {
    int value = N;
};

/// Adds `count` entities with Position (i, 0) and Velocity (1, i) to a world.
inline void fillWithMovers(World& world, int count) {
    for (int i = 0; i < count; ++i) {
        Entity entity = world.createEntity();
        entity.addComponent<Position>(static_cast<float>(i), 0.0f);
        entity.addComponent<Velocity>(1.0f, static_cast<float>(i));
    }
}

}  // namespace plumb
