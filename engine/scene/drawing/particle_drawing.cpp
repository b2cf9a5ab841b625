#include "scene/drawing/particle_drawing.hpp"

#include <algorithm>
#include <cmath>

#include "math/angle.hpp"

namespace plumb {
namespace {

constexpr std::uint32_t kPiece = 512;  // maximum number of particles added to the draw list at once

std::uint8_t mixed(std::uint8_t from, std::uint8_t to, float t) {
    return static_cast<std::uint8_t>(lerp(static_cast<float>(from), static_cast<float>(to), t) + 0.5f);
}

Color mixed(Color from, Color to, float t) {
    return {mixed(from.r, to.r, t), mixed(from.g, to.g, t), mixed(from.b, to.b, t), mixed(from.a, to.a, t)};
}

/// Returns the rectangle of the texture page that a particle shows (texels).
Rect sourceOf(const ParticleEmitter& emitter, const TextureRegion& picture) {
    if (picture.texture == TextureHandle{}) return {0.0f, 0.0f, 1.0f, 1.0f};
    return emitter.source.empty() ? picture.whole() : picture.part(emitter.source);
}

/// Returns the half extents of a particle of size 1, whose longer side is 1.
Vec2 halfOf(const Rect& source) {
    const float longer = std::max(source.width, source.height);
    return longer > 0.0f ? Vec2{source.width, source.height} * (0.5f / longer) : Vec2{0.5f, 0.5f};
}

/// Transform from particle space to world space.
struct Placing {
    Vec2 x{1.0f, 0.0f};     // world displacement per px along the x axis of particle space
    Vec2 y{0.0f, 1.0f};     // world displacement per px along the y axis of particle space
    Vec2 offset;            // px, world: origin of particle space
    float rotation = 0.0f;  // rad, added to the rotation of particles
    float scale = 1.0f;     // ratio, multiplies the size of particles
};

Placing placingOf(const ParticleEmitter& emitter, const ParticleLook& look) {
    Placing placing;
    placing.offset = look.offset;
    if (emitter.space == ParticleSpace::World) return placing;
    placing.x = rotated({look.pose.scale.x, 0.0f}, look.pose.rotation);
    placing.y = rotated({0.0f, look.pose.scale.y}, look.pose.rotation);
    placing.offset += look.pose.position;
    placing.rotation = look.pose.rotation;
    placing.scale = std::fabs(look.pose.scale.y);
    return placing;
}

}  // namespace

const ParticleDrawing::Table& ParticleDrawing::tableOf(const ParticleEmitter& emitter, Color tint) {
    if (usedTables_ == tables_.size()) tables_.emplace_back();
    Table& table = tables_[usedTables_++];
    const bool same = table.made && table.sizes == emitter.sizeOverLife &&
                      table.opacities == emitter.opacityOverLife && table.start == emitter.colorStart &&
                      table.end == emitter.colorEnd && table.tint == tint;
    if (same) return table;
    table.sizes = emitter.sizeOverLife;
    table.opacities = emitter.opacityOverLife;
    table.start = emitter.colorStart;
    table.end = emitter.colorEnd;
    table.tint = tint;
    table.made = true;
    for (std::size_t i = 0; i < Table::kSteps; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(Table::kSteps - 1);
        table.size[i] = table.sizes.valueAt(t);
        table.color[i] = withOpacity(mixed(table.start, table.end, t) * tint, table.opacities.valueAt(t));
    }
    return table;
}

void ParticleDrawing::draw(const Particles& particles, const ParticleStream& stream,
                           const ParticleEmitter& emitter, const ParticleLook& look, DrawList& list) {
    if (stream.count == 0) return;
    const Table& table = tableOf(emitter, look.tint);
    const Rect source = sourceOf(emitter, look.picture);
    const Placing placing = placingOf(emitter, look);
    const Vec2 half = halfOf(source) * (emitter.size * placing.scale);
    const std::array<std::uint16_t, 4> uv{uvFromTexels(source.x), uvFromTexels(source.y),
                                          uvFromTexels(source.x + source.width),
                                          uvFromTexels(source.y + source.height)};
    const std::uint32_t slot = emitter.blend == ParticleBlend::Additive ? kSpriteAdditive : 0u;
    // The inverse motion, from the end of the tick back to the drawn moment.
    const ParticleTravel travel =
        ParticleTravel::over(look.back, gravityIn(emitter, look.pose, look.gravity), emitter.drag);
    const float reach = travel.reach / travel.keep;
    const Vec2 fall = travel.fall - travel.pull * reach;
    const AABB seen = list.visible();
    constexpr float kLast = static_cast<float>(Table::kSteps - 1);

    const auto fill = [&](std::uint32_t from, std::uint32_t to, SpriteInstance* const room) {
        SpriteInstance* out = room;
        for (std::uint32_t i = from; i < to; ++i) {
            const float t = particles.progress[i] - particles.pace[i] * look.back;
            if (!(t >= 0.0f)) continue;  // not yet emitted at the drawn moment
            const auto step = static_cast<std::uint32_t>(std::min(t, 1.0f) * kLast + 0.5f);
            const float x = particles.x[i] - particles.velocityX[i] * reach - fall.x;
            const float y = particles.y[i] - particles.velocityY[i] * reach - fall.y;
            const Vec2 center = placing.x * x + placing.y * y + placing.offset;
            const Vec2 halfSize = half * (table.size[step] * particles.size[i]);
            const float around = halfSize.x + halfSize.y;
            const bool inside = center.x + around > seen.min.x && center.x - around < seen.max.x &&
                                center.y + around > seen.min.y && center.y - around < seen.max.y;
            if (!inside) continue;
            const float rotation = placing.rotation + particles.turn[i] + particles.spin[i] * t;
            *out++ = {center, halfSize, rotation, uv, table.color[step], slot};
        }
        return static_cast<std::size_t>(out - room);
    };
    // Add small pieces: the list clears the memory it provides, which is then still in the L1 cache.
    const std::uint32_t end = stream.first + stream.count;
    for (std::uint32_t from = stream.first; from < end; from += kPiece) {
        const std::uint32_t to = std::min(from + kPiece, end);
        const std::size_t filled = fill(from, to, list.beginRun(to - from).data());
        list.endRun(filled, look.picture.texture, emitter.layer, look.sortY);
    }
}

}  // namespace plumb
