#pragma once

#include <algorithm>
#include <cstdint>

#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "scene/soft_look.hpp"

namespace plumb {

enum class ClothPins : std::uint8_t { None, TopCorners, TopEdge };

/// A net of threads whose top-left corner is at the entity. The entity stays where it is.
struct Cloth : SoftLook {
    Vec2 size{200.0f, 200.0f};  ///< px
    int columns = 20;           ///< particles from left to right
    int rows = 20;              ///< and from top to bottom
    ClothPins pinned = ClothPins::TopEdge;

    static void describe(TypeBuilder<Cloth>& type) {
        type.name("Cloth").doc("A net of threads whose top-left corner is at the entity.");
        type.field<&Cloth::size>("size").unit(Unit::Pixels);
        type.field<&Cloth::columns>("columns").range(2.0f, 100.0f).doc("Particles from left to right.");
        type.field<&Cloth::rows>("rows").range(2.0f, 100.0f).doc("And from top to bottom.");
        type.field<&Cloth::pinned>("pinned")
            .names({{"none", 0}, {"topCorners", 1}, {"topEdge", 2}})
            .doc("What of it stays in its place.");
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
    /// px from the Transform: where it begins
    [[nodiscard]] AABB box() const { return {min(Vec2{}, size), max(Vec2{}, size)}; }
    [[nodiscard]] bool isPinned(int particle) const {
        if (pinned == ClothPins::None || particle >= across()) return false;
        return pinned == ClothPins::TopEdge || particle == 0 || particle == across() - 1;
    }
};

}  // namespace plumb
