#pragma once

#include <algorithm>

#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "scene/soft_look.hpp"

namespace plumb {

/// A rope that starts at the entity. The entity itself does not move.
struct Rope : SoftLook {
    Vec2 to{0.0f, 200.0f};  ///< px from the Transform to the initial position of the other end
    int points = 24;        ///< number of particles
    bool pinStart = true;   ///< its first particle is fixed at the Transform
    bool pinEnd = false;    ///< its last particle is fixed at its initial position

    static void describe(TypeBuilder<Rope>& type) {
        type.name("Rope").doc("A rope that starts at the entity.");
        type.field<&Rope::to>("to")
            .unit(Unit::Pixels)
            .doc("Vector from the Transform to the initial position of the other end, px.");
        type.field<&Rope::points>("points").range(2.0f, 500.0f).doc("Number of particles of the rope.");
        type.field<&Rope::pinStart>("pinStart").doc("The first particle is fixed at the Transform.");
        type.field<&Rope::pinEnd>("pinEnd").doc("The last particle is fixed at its initial position.");
        describeSoft(type);
    }
    void addTo(Hasher& hasher) const {
        SoftLook::addTo(hasher);
        hasher.add(to.x), hasher.add(to.y);
        hasher.add(static_cast<std::uint64_t>(points) << 2 | std::uint64_t{pinStart} << 1 |
                   std::uint64_t{pinEnd});
    }
    [[nodiscard]] Result<physics::SoftBodyId> make(physics::World& world, physics::WorldPosition at,
                                                   float metres) const {
        return physics::createRope(world, at, at + to * metres, std::clamp(points, 2, 500), material(metres));
    }
    /// Initial bounds, px from the Transform.
    [[nodiscard]] AABB box() const { return {min(Vec2{}, to), max(Vec2{}, to)}; }
    [[nodiscard]] bool isPinned(int particle) const {
        return (pinStart && particle == 0) || (pinEnd && particle == std::clamp(points, 2, 500) - 1);
    }
};

}  // namespace plumb
