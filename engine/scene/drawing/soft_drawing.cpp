#include "scene/drawing/soft_drawing.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "ecs/paused.hpp"
#include "scene/components/bodies/cloth.hpp"
#include "scene/components/drawing/hidden.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/loaded_scene.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics/soft_sync.hpp"
#include "scene/scene_stack.hpp"

namespace plumb {

namespace {

Color shaded(Color color, float light) {
    const auto part = [light](std::uint8_t value) {
        return static_cast<std::uint8_t>(std::clamp(static_cast<float>(value) * light, 0.0f, 255.0f));
    };
    return {part(color.r), part(color.g), part(color.b), color.a};
}

/// Adds a soft body to a draw list.
class SoftPicture {
public:
    SoftPicture(const PhysicsState& state, const physics::SoftBody& body, const SoftLook& look, float alpha,
                DrawList& list)
        : scale_{state.scale},
          particles_{body.particles},
          back_{(1.0f - alpha) * static_cast<float>(kSecondsPerTick)},
          look_{look},
          list_{list} {}

    void rope() const {
        for (std::size_t i = 0; i + 1 < particles_.size(); ++i) thread(i, i + 1, look_.color);
    }

    void jelly() const {
        Vec2 middle;
        for (std::size_t i = 0; i < particles_.size(); ++i) middle += at(i);
        middle = middle / static_cast<float>(particles_.size());
        for (std::size_t i = 0; i < particles_.size(); ++i) {
            const std::array<Vec2, 3> slice{middle, at(i), at(after(i))};
            list_.filledPolygon(slice, look_.color, look_.layer);
        }
        for (std::size_t i = 0; i < particles_.size(); ++i) thread(i, after(i), shaded(look_.color, 0.78f));
    }

    /// Draws folds darker: the brightness of a cell increases with its current width.
    void cloth(const Cloth& cloth) const {
        const auto columns = static_cast<std::size_t>(cloth.across());
        const float width = cloth.size.x / static_cast<float>(columns - 1);
        for (std::size_t i = 0; i + columns < particles_.size(); ++i) {
            if (i % columns == columns - 1) continue;
            const std::array<Vec2, 4> cell{at(i), at(i + 1), at(i + columns + 1), at(i + columns)};
            const float lies =
                std::clamp(length(cell[1] - cell[0] + cell[2] - cell[3]) * 0.5f / width, 0.0f, 1.2f);
            list_.filledPolygon(cell, shaded(look_.color, 0.55f + 0.45f * lies), look_.layer);
        }
    }

private:
    [[nodiscard]] std::size_t after(std::size_t i) const { return i + 1 == particles_.size() ? 0 : i + 1; }
    [[nodiscard]] Vec2 at(std::size_t i) const {
        const physics::SoftParticle& particle = particles_[i];
        return positionInPixels(particle.place, scale_) - toPixels(particle.velocity, scale_) * back_;
    }
    void thread(std::size_t from, std::size_t to, Color color) const {
        const Vec2 a = at(from), b = at(to);
        const Vec2 side = perpendicular(normalized(b - a)) * (0.5f * look_.thickness);
        const std::array<Vec2, 4> corners{a + side, b + side, b - side, a - side};
        list_.filledPolygon(corners, color, look_.layer);
        list_.filledCircle(a, 0.5f * look_.thickness, color, look_.layer);
    }

    PixelScale scale_;
    std::span<const physics::SoftParticle> particles_;
    float back_;  // s from the drawn moment to the end of the last tick
    const SoftLook& look_;
    DrawList& list_;
};

void drawThoseOf(const PhysicsState& state, const World& world, const SceneView& how, DrawList& list) {
    for (const SoftLinkage& linkage : state.softBodies) {
        if (!physics::alive(state.world, linkage.body) || world.has<Hidden>(linkage.entity)) continue;
        if (std::binary_search(how.hidden.begin(), how.hidden.end(), linkage.entity)) continue;
        if (how.place != kAllScenes && placeOf(world, linkage.entity) != static_cast<std::size_t>(how.place))
            continue;
        const SoftLook* look = softLookOf(world, linkage);
        if (look == nullptr) continue;
        const physics::SoftBody& body = softBodyOf(state.world, linkage.body);
        const SoftPicture picture{state, body, *look, world.has<Paused>(linkage.entity) ? 1.0f : how.alpha,
                                  list};
        if (!body.ring.empty()) {
            picture.jelly();
        } else if (const auto* cloth = world.find<Cloth>(linkage.entity); look == cloth && cloth != nullptr) {
            picture.cloth(*cloth);
        } else {
            picture.rope();
        }
    }
}

}  // namespace

void drawSoftBodies(const World& world, const SceneView& how, DrawList& list) {
    if (const auto* loaded = world.findResource<LoadedScenes>()) {
        for (const LoadedScene& scene : loaded->scenes) {
            if (scene.below != nullptr) drawThoseOf(*scene.below, world, how, list);
        }
    }
    if (const auto* state = world.findResource<PhysicsState>()) drawThoseOf(*state, world, how, list);
}

}  // namespace plumb
