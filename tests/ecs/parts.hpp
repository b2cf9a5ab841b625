#pragma once

#include <cstdint>

#include "ecs/world.hpp"

namespace plumb {

// Components that the tests of this folder share; some described, some not.

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

/// Names a grid of the world, as a tile layer does.
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

/// One of many types, all alike.
template <int N>
struct Numbered {
    int value = N;
};

/// A world with `count` entities that move: position (i, 0), velocity (1, i).
inline void fillWithMovers(World& world, int count) {
    for (int i = 0; i < count; ++i) {
        Entity entity = world.createEntity();
        entity.addComponent<Position>(static_cast<float>(i), 0.0f);
        entity.addComponent<Velocity>(1.0f, static_cast<float>(i));
    }
}

}  // namespace plumb
