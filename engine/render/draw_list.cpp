#include "render/draw_list.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/angle.hpp"

namespace plumb {
namespace {

constexpr std::uint32_t kYSteps = 65535;

/// Left, top, right, bottom; a flip is an exchange of two ends.
std::array<std::uint16_t, 4> sourceCorners(const SpriteQuad& quad) {
    std::array<std::uint16_t, 4> uv{uvFromTexels(quad.source.x), uvFromTexels(quad.source.y),
                                    uvFromTexels(quad.source.x + quad.source.width),
                                    uvFromTexels(quad.source.y + quad.source.height)};
    if (quad.flipX) std::swap(uv[0], uv[2]);
    if (quad.flipY) std::swap(uv[1], uv[3]);
    return uv;
}

}  // namespace

Vec2 quadCenter(Vec2 origin, Vec2 pivot, Vec2 size, float rotation) {
    const Vec2 fromOrigin = scaled(Vec2{0.5f, 0.5f} - pivot, size);
    return origin + rotated(fromOrigin, rotation);
}

void DrawList::begin(const View& view, TextureGrouping grouping) {
    view_ = view;
    visible_ = visibleBox(view);
    // Sprites are sorted by y as finely as 65536 steps over three screens allow: what stands just outside may
    // reach in.
    const float height = std::max(visible_.size().y, 1.0f);
    yStart_ = visible_.min.y - height;
    yScale_ = static_cast<float>(kYSteps) / (3.0f * height);
    groupMask_ = grouping == TextureGrouping::Group ? 31u : 0u;
    culled_ = 0;
    items_.clear();
    instances_.clear();
    retained_.clear();
    runs_.clear();
    triangles_.clear();
    vertices_.clear();
}

std::uint32_t DrawList::yKey(float y) const {
    if (y == kNoSortY) return 0;
    const float steps = (y - yStart_) * yScale_;
    return steps > 1.0f ? static_cast<std::uint32_t>(std::min(steps, static_cast<float>(kYSteps))) : 1u;
}

void DrawList::sprite(const SpriteQuad& quad) {
    if (!sees(quad.center, quad.half, quad.rotation)) {
        ++culled_;
        return;
    }
    const std::uint32_t group = (quad.texture.index / static_cast<std::uint32_t>(kTextureSlots)) & groupMask_;
    add(Kind::Sprite, instances_.size(), drawKey(quad.layer, yKey(quad.sortY), group));
    instances_.push_back({quad.center, quad.half, quad.rotation, sourceCorners(quad), quad.tint,
                          quad.texture.index << kTextureShift | (quad.additive ? kSpriteAdditive : 0u)});
}

void DrawList::instance(const SpriteInstance& instance, TextureHandle texture, int layer) {
    if (!sees(instance.center, instance.half, instance.rotation)) {
        ++culled_;
        return;
    }
    const std::uint32_t group = (texture.index / static_cast<std::uint32_t>(kTextureSlots)) & groupMask_;
    add(Kind::Sprite, instances_.size(), drawKey(layer, 0, group));
    instances_.push_back(instance);
    instances_.back().slot |= texture.index << kTextureShift;
}

std::span<SpriteInstance> DrawList::beginRun(std::size_t most) {
    runStart_ = instances_.size();
    instances_.resize(runStart_ + most);
    return {instances_.data() + runStart_, most};
}

void DrawList::endRun(std::size_t count, TextureHandle texture, int layer, float sortY) {
    culled_ += instances_.size() - runStart_ - count;
    instances_.resize(runStart_ + count);
    if (count == 0) return;
    const std::uint32_t group = (texture.index / static_cast<std::uint32_t>(kTextureSlots)) & groupMask_;
    add(Kind::Run, runs_.size(), drawKey(layer, yKey(sortY), group));
    runs_.push_back({static_cast<std::uint32_t>(runStart_), static_cast<std::uint32_t>(count), texture});
}

void DrawList::retained(const RetainedSprites& sprites) {
    if (sprites.count == 0) return;
    if (!intersects({sprites.bounds.min + sprites.offset, sprites.bounds.max + sprites.offset}, visible_)) {
        ++culled_;
        return;
    }
    add(Kind::Retained, retained_.size(), drawKey(sprites.layer, 0, 0));
    retained_.push_back(sprites);
}

}  // namespace plumb
