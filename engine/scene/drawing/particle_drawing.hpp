#pragma once

#include <array>
#include <vector>

#include "render/draw_list.hpp"
#include "render/texture_atlas.hpp"
#include "scene/particles.hpp"

namespace plumb {

/// How one stream is looked at.
struct ParticleLook {
    TextureRegion picture;
    Pose pose;          ///< of the emitter, as it is drawn
    float back = 0.0f;  ///< s from what is drawn to the end of the last tick
    Vec2 gravity;       ///< px/s^2 of the scene
    Color tint;         ///< of its layer
    Vec2 offset;        ///< px, world: by how much its layer is moved
    float sortY = kNoSortY;
};

/// Adds particles to draw lists: all of one emitter as one run. Keeps what follows from its curves.
class ParticleDrawing {
public:
    void draw(const Particles& particles, const ParticleStream& stream, const ParticleEmitter& emitter,
              const ParticleLook& look, DrawList& list);
    /// Before the streams of a picture.
    void begin() { used_ = 0; }

private:
    /// What particles look like along their life.
    struct Table {
        static constexpr std::size_t kSteps = 256;

        Curve sizes;
        Curve opacities;
        Color start;
        Color end;
        Color tint;
        bool made = false;
        std::array<float, kSteps> size{};  ///< ratio
        std::array<Color, kSteps> color{};
    };

    const Table& tableOf(const ParticleEmitter& emitter, Color tint);

    std::vector<Table> tables_;  // by the order of drawing: from picture to picture mostly the same
    std::size_t used_ = 0;
};

}  // namespace plumb
