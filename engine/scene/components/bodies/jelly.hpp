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

/// A jelly: a closed skin of particles that preserves its area. It starts as a circle around the entity; the
/// entity itself does not move.
struct Jelly : SoftLook {
    static constexpr int kMostPoints = 128;  ///< maximum number of particles

    float radius = 48.0f;  ///< px, at the start
    int points = 24;       ///< number of particles of the skin
    float squeeze = 0.0f;  ///< area compliance, m/N: larger is easier to compress

    Jelly() {
        softness = 1e-4f;
        thickness = 4.0f;
    }

    static void describe(TypeBuilder<Jelly>& type) {
        type.name("Jelly").doc("A round soft body that preserves its area.");
        type.field<&Jelly::radius>("radius")
            .unit(Unit::Pixels)
            .range(1.0f, 1e5f)
            .doc("Radius at the start, px.");
        type.field<&Jelly::points>("points").range(5.0f, 128.0f).doc("Number of particles of the skin.");
        type.field<&Jelly::squeeze>("squeeze")
            .range(0.0f, 1000.0f)
            .doc("Area compliance, m/N; larger is easier to compress.");
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
    /// Initial bounds, px from the Transform.
    [[nodiscard]] AABB box() const { return {{-radius, -radius}, {radius, radius}}; }
    [[nodiscard]] static bool isPinned(int) { return false; }
};

}  // namespace plumb
