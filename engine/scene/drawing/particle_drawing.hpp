#pragma once

#include <array>
#include <vector>

#include "render/draw_list.hpp"
#include "render/texture_atlas.hpp"
#include "scene/particles.hpp"

namespace plumb {

/// Parameters for drawing one particle stream.
struct ParticleLook {
    TextureRegion picture;   ///< image of a particle
    Pose pose;               ///< interpolated pose of the emitter
    float back = 0.0f;       ///< s from the drawn moment to the end of the last tick
    Vec2 gravity;            ///< px/s^2, gravity of the scene
    Color tint;              ///< tint of the drawing layer
    Vec2 offset;             ///< px, world: displacement of the drawing layer by parallax
    float sortY = kNoSortY;  ///< px, world: sort position in layers sorted by y
};

/// Adds particles to draw lists, emitter by emitter. Caches size and color tables of the emitters.
class ParticleDrawing {
public:
    void draw(const Particles& particles, const ParticleStream& stream, const ParticleEmitter& emitter,
              const ParticleLook& look, DrawList& list);
    /// Call before drawing the streams of a frame.
    void begin() { usedTables_ = 0; }

private:
    /// Size and color of an emitter's particles over their lifetime.
    struct Table {
        static constexpr std::size_t kSteps = 256;

        Curve sizes;
        Curve opacities;
        Color start;
        Color end;
        Color tint;
        bool made = false;                 ///< the table has been computed
        std::array<float, kSteps> size{};  ///< multiplier of the particle size
        std::array<Color, kSteps> color{};
    };

    const Table& tableOf(const ParticleEmitter& emitter, Color tint);

    // Kept over frames: the n-th stream drawn in a frame reuses the n-th table if its emitter looks the same.
    std::vector<Table> tables_;
    std::size_t usedTables_ = 0;  // number of streams drawn so far in this frame
};

}  // namespace plumb
