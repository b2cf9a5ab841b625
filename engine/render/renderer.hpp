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
    std::size_t sprites = 0;  ///< from lists; retained ones are not counted
    std::size_t culled = 0;
};

/// Distant layers, drawn into a smaller target that is then enlarged:
/// cheaper where every pixel costs time and backdrops cover each other.
struct FarPicture {
    Viewport viewport;  ///< all of a target
    int nearLayer = 0;  ///< this layer and those above it are drawn directly into the window
};

/// Draws lists on a device: sorts, writes the instances in
/// order, and splits them into batches of at most 16 textures.
class Renderer {
public:
    explicit Renderer(RenderDevice& device) : device_{device} {}

    void draw(const DrawList& list, const Viewport& viewport);
    /// The same, with everything behind `far.nearLayer` drawn into `far` and enlarged to the viewport.
    void draw(const DrawList& list, const Viewport& viewport, const FarPicture& far);

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
    /// By texture: the last batch that assigned it a slot,
    /// and the slot; so no table is cleared between batches.
    struct Slot {
        std::uint32_t batch = 0;
        std::uint32_t slot = 0;
    };
    std::vector<Slot> slots_;
    std::uint32_t batchNumber_ = 0;
    RenderCounts counts_;
};

}  // namespace plumb
