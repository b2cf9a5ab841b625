#pragma once

#include "box_physics/narrowphase/sweep.hpp"
#include "box_physics/world.hpp"

namespace plumb::box_physics {

/// Where one mover touches one body: a corner of a room gives two.
struct TouchList {
    static constexpr int kMost = 6;

    Touch items[kMost];
    int count = 0;

    /// Keeps one touch per direction: the first in time, then the deepest.
    void add(const Touch& touch);
    /// Drops corners that only exist because a tile ends there, and what lies behind the first hit.
    void finish();
    [[nodiscard]] const Touch* first() const;
};

/// Finds where a mover touches a body that is at `place` (m). The mover's path is relative to the body's.
/// One-way bodies and cells only answer to what comes from the side of `up`.
void collideAt(const World& world, const Mover& mover, std::uint32_t body, Vec2 place,
               const Settings& settings, Vec2 up, TouchList& touches);

/// The same where the body is now.
inline void collide(const World& world, const Mover& mover, std::uint32_t body, const Settings& settings,
                    Vec2 up, TouchList& touches) {
    collideAt(world, mover, body, world.bodies.position[body], settings, up, touches);
}

/// The mover that a body is in this step. @pre its shape is a box or a circle
Mover moverOf(const World& world, std::uint32_t body, Vec2 path);

}  // namespace plumb::box_physics
