#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "math/angle.hpp"
#include "math/portable.hpp"
#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "scene/soft_look.hpp"

namespace plumb {

/// A round skin that keeps its area, at first around the entity. The entity stays where it is.
struct Jelly : SoftLook {
    static constexpr int kMostPoints = 128;

    float radius = 48.0f;  ///< px
    int points = 24;       ///< particles of its skin
    float squeeze = 0.0f;  ///< m/N: larger is squeezed more easily

    Jelly() {
        softness = 1e-4f;
        thickness = 4.0f;
    }

    static void describe(TypeBuilder<Jelly>& type) {
        type.name("Jelly").doc("A round skin that keeps its area.");
        type.field<&Jelly::radius>("radius").unit(Unit::Pixels).range(1.0f, 1e5f);
        type.field<&Jelly::points>("points").range(5.0f, 128.0f).doc("Particles of its skin.");
        type.field<&Jelly::squeeze>("squeeze")
            .range(0.0f, 1000.0f)
            .doc("m/N: larger is squeezed more easily.");
        describeSoft(type);
    }
    void addTo(Hasher& hasher) const {
        SoftLook::addTo(hasher);
        hasher.add(radius), hasher.add(squeeze), hasher.add(static_cast<std::uint64_t>(points));
    }
    [[nodiscard]] Result<physics::SoftBodyId> make(physics::World& world, physics::WorldPosition at,
                                                   float metres) const {
        const int count = std::clamp(points, 5, kMostPoints);
        std::array<Vec2, kMostPoints> outline;
        for (int i = 0; i < count; ++i) {
            const float angle = kTau * static_cast<float>(i) / static_cast<float>(count);
            outline[static_cast<std::size_t>(i)] =
                Vec2{cosine(wrapAngle(angle)), sine(wrapAngle(angle))} * (radius * metres);
        }
        physics::SoftMaterial made = material(metres);
        made.areaCompliance = squeeze;
        return physics::createJelly(world, at, std::span{outline.data(), static_cast<std::size_t>(count)},
                                    made);
    }
    /// px from the Transform: where it begins
    [[nodiscard]] AABB box() const { return {{-radius, -radius}, {radius, radius}}; }
    [[nodiscard]] static bool isPinned(int) { return false; }
};

}  // namespace plumb
