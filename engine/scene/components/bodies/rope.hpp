#pragma once

#include <algorithm>

#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "scene/soft_look.hpp"

namespace plumb {

/// A rope that hangs from the entity. The entity stays where it is.
struct Rope : SoftLook {
    Vec2 to{0.0f, 200.0f};  ///< px from the Transform to its other end
    int points = 24;        ///< particles that it is made of
    bool pinStart = true;   ///< its start stays at the Transform
    bool pinEnd = false;    ///< so does its other end where it begins

    static void describe(TypeBuilder<Rope>& type) {
        type.name("Rope").doc("A rope that hangs from the entity.");
        type.field<&Rope::to>("to").unit(Unit::Pixels).doc("From the Transform to its other end.");
        type.field<&Rope::points>("points").range(2.0f, 500.0f).doc("Particles that it is made of.");
        type.field<&Rope::pinStart>("pinStart").doc("Its start stays at the Transform.");
        type.field<&Rope::pinEnd>("pinEnd").doc("Its other end stays where it begins.");
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
    /// px from the Transform: where it begins
    [[nodiscard]] AABB box() const { return {min(Vec2{}, to), max(Vec2{}, to)}; }
    [[nodiscard]] bool isPinned(int particle) const {
        return (pinStart && particle == 0) || (pinEnd && particle == std::clamp(points, 2, 500) - 1);
    }
};

}  // namespace plumb
