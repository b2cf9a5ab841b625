#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/draw_list.hpp"
#include "render/draw_order.hpp"
#include "render/render_device.hpp"

namespace plumb {

/// Statistics of drawing one or more lists.
struct RenderCounts {
    std::size_t drawCalls = 0;
    std::size_t sprites = 0;  ///< number of sprites in the lists, without retained ones
    std::size_t culled = 0;
};

/// Render target, smaller than the viewport, in which distant layers are drawn before they
/// are enlarged to the viewport. Saves time in software rendering where backdrops overlap.
struct FarLayersTarget {
    Viewport viewport;  ///< the whole target
    int nearLayer = 0;  ///< this layer and higher ones are drawn directly to the window
};

/// Draws lists on a device: sorts, writes the instances in
/// order, and splits them into batches of at most 16 textures.
class Renderer {
public:
    explicit Renderer(RenderDevice& device) : device_{device} {}

    void draw(const DrawList& list, const Viewport& viewport);
    /// Draws a list with all layers below `far.nearLayer` drawn to `far` first and enlarged to the viewport.
    void draw(const DrawList& list, const Viewport& viewport, const FarLayersTarget& far);

    [[nodiscard]] RenderDevice& device() { return device_; }
    [[nodiscard]] const RenderCounts& counts() const { return counts_; }
    void resetCounts() { counts_ = {}; }

private:
    /// A pending draw call: sprites of the frame, retained sprites or triangles.
    struct Step {
        DrawList::Kind kind = DrawList::Kind::Sprite;
        SpriteBatch batch;
        GeometryBatch geometry;
    };

    void drawItems(const DrawList& list, std::span<const DrawItem> order, const Viewport& viewport);
    void planSprites(const DrawList& list, std::span<const DrawItem> order, const ViewTransform& transform);
    std::size_t fillBatch(const DrawList& list, std::span<const DrawItem> items,
                          std::span<SpriteInstance> out, SpriteBatch& batch);
    void addRetained(const RetainedSprites& sprites, const ViewTransform& transform);
    void addGeometry(const DrawList& list, const DrawList::Triangles& part, const ViewTransform& transform);
    void submit();

    RenderDevice& device_;
    DrawOrder order_;
    std::vector<Step> steps_;
    /// The last batch that assigned a slot to a texture, and the slot.
    /// Because of the batch number, no table must be cleared between batches.
    struct Slot {
        std::uint32_t batch = 0;
        std::uint32_t slot = 0;
    };
    std::vector<Slot> slots_;  ///< indexed by texture
    std::uint32_t batchNumber_ = 0;
    RenderCounts counts_;
};

}  // namespace plumb
