#include "render/renderer.hpp"

#include <algorithm>

namespace plumb {
namespace {

constexpr float kLargePart = 0.125f;  ///< ratio of the view's area above which a sprite counts as large

bool hasSprites(DrawItem item) {
    const DrawList::Kind kind = DrawList::kindOf(item);
    return kind == DrawList::Kind::Sprite || kind == DrawList::Kind::Run;
}

/// Returns the items with sprites at the front of `order`, up to the first item of another kind.
std::span<const DrawItem> leadingSprites(std::span<const DrawItem> order) {
    std::size_t count = 0;
    while (count < order.size() && hasSprites(order[count])) ++count;
    return order.first(count);
}

/// Returns the sprites of an item. @pre hasSprites(item)
std::span<const SpriteInstance> spritesOf(DrawItem item, const DrawList& list) {
    const std::size_t index = DrawList::indexOf(item);
    if (DrawList::kindOf(item) == DrawList::Kind::Sprite) return list.instances().subspan(index, 1);
    return list.instances().subspan(list.runs()[index].first, list.runs()[index].count);
}

/// Returns the number of sprites of the items.
std::size_t spritesIn(std::span<const DrawItem> order, const DrawList& list) {
    if (order.size() == list.items().size()) return list.spriteCount();
    std::size_t count = 0;
    for (const DrawItem item : order) {
        if (hasSprites(item)) count += spritesOf(item, list).size();
    }
    return count;
}

TextureHandle textureOf(DrawItem item, const SpriteInstance& first, const DrawList& list) {
    if (DrawList::kindOf(item) == DrawList::Kind::Run) return list.runs()[DrawList::indexOf(item)].texture;
    return {DrawList::textureOf(first)};
}

void countItems(const DrawList& list, RenderCounts& counts) {
    counts.sprites += list.spriteCount();
    counts.culled += list.culledCount();
}

}  // namespace

void Renderer::draw(const DrawList& list, const Viewport& viewport) {
    countItems(list, counts_);
    drawItems(list, order_.sort(list.items()), viewport);
}

void Renderer::draw(const DrawList& list, const Viewport& viewport, const FarLayersTarget& far) {
    countItems(list, counts_);
    const std::span<const DrawItem> order = order_.sort(list.items());
    const std::uint32_t nearKey = drawKey(far.nearLayer, 0, 0);
    const auto split = std::partition_point(order.begin(), order.end(),
                                            [nearKey](const DrawItem& item) { return item.key < nearKey; });
    const auto behind = static_cast<std::size_t>(split - order.begin());
    if (behind == 0) return drawItems(list, order, viewport);
    device_.setViewport(far.viewport);
    device_.clear({0, 0, 0, 255});
    drawItems(list, order.first(behind), far.viewport);
    device_.show(far.viewport.target, viewport);
    ++counts_.drawCalls;
    drawItems(list, order.subspan(behind), viewport);
}

void Renderer::drawItems(const DrawList& list, std::span<const DrawItem> order, const Viewport& viewport) {
    device_.setViewport(viewport);
    if (order.empty()) return;
    steps_.clear();
    planSprites(list, order, transformOf(list.view()));
    submit();
}

void Renderer::planSprites(const DrawList& list, std::span<const DrawItem> order,
                           const ViewTransform& transform) {
    const std::size_t sprites = spritesIn(order, list);
    const std::span<SpriteInstance> memory =
        sprites > 0 ? device_.mapInstances(sprites) : std::span<SpriteInstance>{};
    std::size_t written = 0;
    while (!order.empty()) {
        const DrawItem next = order.front();
        if (DrawList::kindOf(next) == DrawList::Kind::Retained) {
            addRetained(list.retainedSprites()[DrawList::indexOf(next)], transform);
            order = order.subspan(1);
        } else if (DrawList::kindOf(next) == DrawList::Kind::Geometry) {
            addGeometry(list, list.triangles()[DrawList::indexOf(next)], transform);
            order = order.subspan(1);
        } else {
            SpriteBatch batch;
            batch.first = written;
            batch.transform = transform;
            order = order.subspan(fillBatch(list, leadingSprites(order), memory.subspan(written), batch));
            written += batch.count;
            steps_.push_back({DrawList::Kind::Sprite, batch, {}});
        }
    }
    if (sprites > 0) device_.unmapInstances();
}

/// Writes sprites to a batch until all are written or no slot is free for a texture.
/// @return the number of items written
std::size_t Renderer::fillBatch(const DrawList& list, std::span<const DrawItem> items,
                                std::span<SpriteInstance> out, SpriteBatch& batch) {
    ++batchNumber_;
    const std::size_t maxTextures = device_.batchTextures();
    constexpr std::uint32_t kFlags = kSpriteDiagonal | kSpriteAdditive;
    // Software renderers need time per pixel for every slot: sprites that
    // cover much of the view are drawn in a separate batch with one slot.
    const bool slotsAreCostly = maxTextures < kTextureSlots;
    const Vec2 viewHalf = visibleBox(list.view()).size() * 0.5f;
    const float largeArea = viewHalf.x * viewHalf.y * kLargePart;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::span<const SpriteInstance> sprites = spritesOf(items[i], list);
        const Vec2 half = sprites.front().half;
        const bool alone = slotsAreCostly && sprites.size() == 1 && half.x * half.y > largeArea;
        if (alone && i > 0) return i;
        const std::uint32_t texture = textureOf(items[i], sprites.front(), list).index;
        if (texture >= slots_.size()) slots_.resize(texture + 1);
        Slot& slot = slots_[texture];
        if (slot.batch != batchNumber_) {
            if (batch.textureCount == maxTextures) return i;
            slot = {batchNumber_, static_cast<std::uint32_t>(batch.textureCount)};
            batch.textures[batch.textureCount++] = {texture};
        }
        for (const SpriteInstance& sprite : sprites) {
            SpriteInstance instance = sprite;
            instance.slot = (instance.slot & kFlags) | slot.slot;
            out[batch.count++] = instance;
        }
        if (alone) return 1;
    }
    return items.size();
}

void Renderer::addRetained(const RetainedSprites& sprites, const ViewTransform& transform) {
    Step step{DrawList::Kind::Retained, {}, {}};
    step.batch.buffer = sprites.buffer;
    step.batch.count = sprites.count;
    step.batch.textures = sprites.textures;
    step.batch.textureCount = sprites.textureCount;
    step.batch.transform = movedBy(transform, sprites.offset);
    step.batch.tint = sprites.tint;
    steps_.push_back(step);
}

void Renderer::addGeometry(const DrawList& list, const DrawList::Triangles& part,
                           const ViewTransform& transform) {
    const std::span<const GeometryVertex> vertices = list.vertices().subspan(part.first, part.count);
    // Consecutive items whose vertices are adjacent in memory share a draw call.
    if (!steps_.empty() && steps_.back().kind == DrawList::Kind::Geometry) {
        std::span<const GeometryVertex>& before = steps_.back().geometry.vertices;
        if (before.data() + before.size() == vertices.data()) {
            before = {before.data(), before.size() + vertices.size()};
            return;
        }
    }
    steps_.push_back({DrawList::Kind::Geometry, {}, {vertices, transform}});
}

void Renderer::submit() {
    for (const Step& step : steps_) {
        if (step.kind == DrawList::Kind::Geometry) {
            device_.drawGeometry(step.geometry);
        } else {
            device_.drawSprites(step.batch);
        }
    }
    counts_.drawCalls += steps_.size();
}

}  // namespace plumb
