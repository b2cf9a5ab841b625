#include "render/draw_list.hpp"

#include <algorithm>

namespace plumb {
void DrawList::begin(const View& view, TextureGrouping grouping) {
    view_ = view;
    visible_ = visibleBox(view);
    // The y order has 65535 steps over three view heights, because
    // the sortY of a visible sprite may be outside of the view.
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

void DrawList::instance(const SpriteInstance& instance, TextureHandle texture, int layer) {
    if (!isInView(instance.center, instance.half, instance.rotation)) {
        ++culled_;
        return;
    }
    add(Kind::Sprite, instances_.size(), drawKey(layer, 0, groupOf(texture)));
    instances_.push_back(instance);
    instances_.back().slot |= texture.index << kTextureShift;
}

std::span<SpriteInstance> DrawList::beginRun(std::size_t maximum) {
    runStart_ = instances_.size();
    instances_.resize(runStart_ + maximum);
    return {instances_.data() + runStart_, maximum};
}

void DrawList::endRun(std::size_t count, TextureHandle texture, int layer, float sortY) {
    culled_ += instances_.size() - runStart_ - count;
    instances_.resize(runStart_ + count);
    if (count == 0) return;
    add(Kind::Run, runs_.size(), drawKey(layer, yKey(sortY), groupOf(texture)));
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
