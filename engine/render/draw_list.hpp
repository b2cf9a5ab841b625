#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "math/angle.hpp"
#include "math/color.hpp"
#include "math/rect.hpp"
#include "render/draw_order.hpp"
#include "render/render_device.hpp"
#include "render/view.hpp"

namespace plumb {

/// The sortY of objects outside the y order: drawn first in their layer, in the order of insertion.
inline constexpr float kNoSortY = std::numeric_limits<float>::lowest();

/// A textured quad in the world.
struct SpriteQuad {
    Vec2 center;            ///< px, world
    Vec2 half;              ///< px, half of the drawn size
    float rotation = 0.0f;  ///< rad about the center, clockwise on screen
    TextureHandle texture;
    Rect source;  ///< region of the texture, texels
    Color tint;
    int layer = 0;           ///< higher layers are drawn on top
    float sortY = kNoSortY;  ///< px, world: within a layer, larger y is drawn on top
    bool flipX = false;
    bool flipY = false;
    bool additive = false;  ///< additive blending instead of alpha blending
};

/// Returns the center of a quad whose top left corner is at `origin - pivot * size`
/// before the quad is rotated about `origin`.
inline Vec2 quadCenter(Vec2 origin, Vec2 pivot, Vec2 size, float rotation) {
    return origin + rotated(scaled(Vec2{0.5f, 0.5f} - pivot, size), rotation);
}

/// Sprites that stay in the device's memory, e.g. one chunk of a tile layer.
struct RetainedSprites {
    InstanceBufferHandle buffer;
    std::size_t count = 0;
    std::array<TextureHandle, kTextureSlots> textures{};  ///< indexed by the slots of the instances
    std::size_t textureCount = 1;
    AABB bounds;  ///< px, without `offset`; used for culling
    Vec2 offset;  ///< px, world
    Color tint;
    int layer = 0;
};

/// Style of lines and shapes.
struct ShapeStyle {
    Color color;
    float thickness = 1.0f;  ///< screen px, independent of the zoom
    int layer = kHighestLayer;
};

/// Order of sprites with the same layer and y.
enum class TextureGrouping : std::uint8_t {
    Keep,   ///< drawn in the order of insertion
    Group,  ///< grouped 16 textures at a time: for worlds with very many textures
};

/// List of all objects drawn with one view. Refilled every frame; reuses its memory, so a
/// frame of usual size allocates nothing. Objects outside the view are not added.
class DrawList {
public:
    /// Clears the list and sets the view for the objects added next.
    void begin(const View& view, TextureGrouping grouping = TextureGrouping::Keep);

    [[gnu::always_inline]] void sprite(const SpriteQuad& quad);
    void retained(const RetainedSprites& sprites);
    /// Adds a quad that is already in the device's format; `instance.slot` must have kSprite... flags only.
    void instance(const SpriteInstance& instance, TextureHandle texture, int layer);

    /// Reserves memory for up to `maximum` quads of one texture and layer in the device's format;
    /// `slot` of each must have kSprite... flags only. Fill the memory front to back, then call endRun();
    /// add nothing else in between. The caller must skip quads outside visible().
    [[nodiscard]] std::span<SpriteInstance> beginRun(std::size_t maximum);
    /// Adds the quads written after beginRun(). @param count number of quads that were filled
    void endRun(std::size_t count, TextureHandle texture, int layer, float sortY = kNoSortY);

    void line(Vec2 from, Vec2 to, const ShapeStyle& style);
    void arrow(Vec2 from, Vec2 to, const ShapeStyle& style);
    void rect(const AABB& box, const ShapeStyle& style);
    void circle(Vec2 center, float radius, const ShapeStyle& style);
    void polygon(std::span<const Vec2> corners, const ShapeStyle& style);
    void filledRect(const AABB& box, Color color, int layer = kHighestLayer);
    void filledCircle(Vec2 center, float radius, Color color, int layer = kHighestLayer);
    /// @pre the corners form a convex shape, in order
    void filledPolygon(std::span<const Vec2> corners, Color color, int layer = kHighestLayer);

    [[nodiscard]] const View& view() const { return view_; }
    [[nodiscard]] const AABB& visible() const { return visible_; }  ///< bounding box of the view, px, world
    [[nodiscard]] std::size_t spriteCount() const { return instances_.size(); }
    [[nodiscard]] std::size_t culledCount() const { return culled_; }

    // Interface for the renderer. An item's reference is its kind
    // in the top two bits and its index in the list of that kind.
    enum class Kind : std::uint8_t { Sprite, Retained, Geometry, Run };
    struct Triangles {
        std::uint32_t first = 0;  ///< index of the first vertex
        std::uint32_t count = 0;  ///< number of vertices
    };
    struct Run {
        std::uint32_t first = 0;  ///< index of the first instance
        std::uint32_t count = 0;
        TextureHandle texture;
    };
    static Kind kindOf(DrawItem item) { return static_cast<Kind>(item.ref >> kKindShift); }
    static std::size_t indexOf(DrawItem item) { return item.ref & ((1u << kKindShift) - 1u); }
    /// In this list, SpriteInstance::slot has the flags in the low 16 bits and the texture's index above.
    static constexpr std::uint32_t kTextureShift = 16;
    static std::uint32_t textureOf(const SpriteInstance& instance) { return instance.slot >> kTextureShift; }

    [[nodiscard]] std::span<const DrawItem> items() const { return items_; }
    [[nodiscard]] std::span<const SpriteInstance> instances() const { return instances_; }
    [[nodiscard]] std::span<const RetainedSprites> retainedSprites() const { return retained_; }
    [[nodiscard]] std::span<const Run> runs() const { return runs_; }
    [[nodiscard]] std::span<const Triangles> triangles() const { return triangles_; }
    [[nodiscard]] std::span<const GeometryVertex> vertices() const { return vertices_; }

private:
    static constexpr std::uint32_t kKindShift = 30;
    static constexpr std::uint32_t kYSteps = 65535;

    [[nodiscard]] bool isInView(Vec2 center, Vec2 half, float rotation) const;
    [[nodiscard]] std::uint32_t yKey(float y) const;
    [[nodiscard]] std::uint32_t groupOf(TextureHandle texture) const {
        return (texture.index / static_cast<std::uint32_t>(kTextureSlots)) & groupMask_;
    }
    void add(Kind kind, std::size_t index, std::uint32_t key) {
        items_.push_back(
            {key, static_cast<std::uint32_t>(kind) << kKindShift | static_cast<std::uint32_t>(index)});
    }
    void fan(std::span<const Vec2> corners, Color color, int layer);

    View view_;
    AABB visible_;
    float yStart_ = 0.0f;
    float yScale_ = 1.0f;
    std::uint32_t groupMask_ = 0;
    std::size_t culled_ = 0;
    std::vector<DrawItem> items_;
    std::vector<SpriteInstance> instances_;
    std::vector<RetainedSprites> retained_;
    std::vector<Run> runs_;
    std::size_t runStart_ = 0;
    std::vector<Triangles> triangles_;
    std::vector<GeometryVertex> vertices_;
};

inline bool DrawList::isInView(Vec2 center, Vec2 half, float rotation) const {
    Vec2 reach{std::abs(half.x), std::abs(half.y)};
    if (rotation != 0.0f) reach.x = reach.y = reach.x + reach.y;
    // With NaN every comparison is false: invisible.
    return center.x + reach.x > visible_.min.x && center.x - reach.x < visible_.max.x &&
           center.y + reach.y > visible_.min.y && center.y - reach.y < visible_.max.y;
}

inline std::uint32_t DrawList::yKey(float y) const {
    if (y == kNoSortY) return 0;
    const float steps = (y - yStart_) * yScale_;
    return steps > 1.0f ? static_cast<std::uint32_t>(std::min(steps, static_cast<float>(kYSteps))) : 1u;
}

/// Returns left, top, right and bottom of the source in quarter texels; a flip swaps two of them.
inline std::array<std::uint16_t, 4> sourceCorners(const SpriteQuad& quad) {
    std::array<std::uint16_t, 4> uv{uvFromTexels(quad.source.x), uvFromTexels(quad.source.y),
                                    uvFromTexels(quad.source.x + quad.source.width),
                                    uvFromTexels(quad.source.y + quad.source.height)};
    if (quad.flipX) std::swap(uv[0], uv[2]);
    if (quad.flipY) std::swap(uv[1], uv[3]);
    return uv;
}

// Inline, so that constructing and converting a quad is optimized together: worlds have 100,000 of them.
inline void DrawList::sprite(const SpriteQuad& quad) {
    if (!isInView(quad.center, quad.half, quad.rotation)) {
        ++culled_;
        return;
    }
    add(Kind::Sprite, instances_.size(), drawKey(quad.layer, yKey(quad.sortY), groupOf(quad.texture)));
    instances_.push_back({quad.center, quad.half, quad.rotation, sourceCorners(quad), quad.tint,
                          quad.texture.index << kTextureShift | (quad.additive ? kSpriteAdditive : 0u)});
}

}  // namespace plumb
