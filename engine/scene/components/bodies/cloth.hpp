#pragma once

#include <algorithm>
#include <cstdint>

#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "scene/soft_look.hpp"

namespace plumb {

enum class ClothPins : std::uint8_t { None, TopCorners, TopEdge };  ///< particles of a cloth that are fixed

/// A cloth: a grid of particles whose top-left corner starts at the entity. The entity itself does not move.
struct Cloth : SoftLook {
    Vec2 size{200.0f, 200.0f};              ///< px, width and height at the start
    int columns = 20;                       ///< number of particles from left to right
    int rows = 20;                          ///< number of particles from top to bottom
    ClothPins pinned = ClothPins::TopEdge;  ///< particles fixed at their initial positions

    static void describe(TypeBuilder<Cloth>& type) {
        type.name("Cloth").doc(
            "A cloth made of a grid of particles; its top-left corner starts at the entity.");
        type.field<&Cloth::size>("size").unit(Unit::Pixels).doc("Width and height at the start, px.");
        type.field<&Cloth::columns>("columns")
            .range(2.0f, 100.0f)
            .doc("Number of particles from left to right.");
        type.field<&Cloth::rows>("rows").range(2.0f, 100.0f).doc("Number of particles from top to bottom.");
        type.field<&Cloth::pinned>("pinned")
            .names({{"none", 0}, {"topCorners", 1}, {"topEdge", 2}})
            .doc("Particles that are fixed at their initial positions.");
        describeSoft(type);
    }
    [[nodiscard]] int across() const { return std::clamp(columns, 2, 100); }
    void addTo(Hasher& hasher) const {
        SoftLook::addTo(hasher);
        hasher.add(size.x), hasher.add(size.y);
        for (const int value : {columns, rows, static_cast<int>(pinned)})
            hasher.add(static_cast<std::uint64_t>(value));
    }
    [[nodiscard]] Result<physics::SoftBodyId> make(physics::World& world, physics::WorldPosition at,
                                                   float metres) const {
        return physics::createCloth(world, at, size * metres, across(), std::clamp(rows, 2, 100),
                                    material(metres));
    }
    /// Initial bounds, px from the Transform.
    [[nodiscard]] AABB box() const { return {min(Vec2{}, size), max(Vec2{}, size)}; }
    [[nodiscard]] bool isPinned(int particle) const {
        if (pinned == ClothPins::None || particle >= across()) return false;
        return pinned == ClothPins::TopEdge || particle == 0 || particle == across() - 1;
    }
};

}  // namespace plumb
