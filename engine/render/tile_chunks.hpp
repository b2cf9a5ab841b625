#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/tile_grid.hpp"
#include "render/draw_list.hpp"
#include "render/texture_atlas.hpp"

namespace plumb {

/// The texture region shown for one tile.
struct TileLook {
    TextureHandle texture;
    Rect source;            ///< texels; empty: the tile is not drawn
    bool animated = false;  ///< the region may change every frame
};

/// Texture regions and sizes of the tiles of a layer.
struct TileSheet {
    std::span<const TileLook> looks;  ///< indexed by tile id
    Vec2 cellSize{16.0f, 16.0f};      ///< px, world; larger tiles are aligned to the cell's lower left corner
    Vec2 scale{1.0f, 1.0f};           ///< world px per texel
    Vec2 offset;                      ///< px added to every tile
    std::uint32_t version = 0;        ///< changes when the look of a tile without animation changes
};

/// Position and style of a whole layer.
struct TilePlacement {
    Vec2 offset;  ///< the layer's top left corner, px, world
    Color tint;
    int layer = 0;
};

/// Draws a tile layer in chunks of 32x32 tiles that are kept on the graphics card. A chunk
/// is built when it first becomes visible and rebuilt when one of its tiles changes;
/// invisible chunks cost nothing, so the layer can have any size. When the camera is zoomed
/// out so far that tiles would be smaller than 1.5 px, one tile represents a block of them.
///
/// Tiles are drawn row by row from the top, each row from the left. With tiles both wider and higher than
/// their cells, square chunks would break this order at their borders; then chunks have one row.
class TileChunks {
public:
    static constexpr int kSide = 32;               ///< tiles
    static constexpr std::size_t kMaxKept = 4096;  ///< chunks; if exceeded, those not visible are released

    explicit TileChunks(RenderDevice& device) : device_{device} {}
    ~TileChunks() { forget(); }
    TileChunks(const TileChunks&) = delete;
    TileChunks& operator=(const TileChunks&) = delete;

    /// Adds the visible part of the layer.
    void draw(DrawList& list, const TileGrid& grid, const TileSheet& sheet, const TilePlacement& placement);
    /// Releases all memory; the next draw rebuilds it.
    void forget();

    [[nodiscard]] std::size_t builtCount() const { return built_; }  ///< total number of chunks built
    [[nodiscard]] std::size_t keptCount() const { return kept_; }

private:
    /// Tiles of a chunk that fit into one draw call: at most 16 textures.
    struct Part {
        InstanceBufferHandle buffer;
        std::size_t count = 0;
        std::array<TextureHandle, kTextureSlots> textures{};
        std::size_t textureCount = 0;
    };
    struct Animated {
        std::uint32_t cell = 0;  ///< index in the grid: y * width + x
        std::size_t parts = 0;   ///< number of parts of the chunk drawn before the tile
    };
    struct Chunk {
        bool known = false;           ///< has been built
        std::uint64_t rowsStamp = 0;  ///< stampOfRows() at the last refresh
        std::uint64_t stamp = 0;      ///< stampOf() when it was built
        std::uint64_t lastSeen = 0;   ///< number of the last frame in which it was visible
        AABB bounds;
        std::vector<Part> parts;
        std::vector<Animated> animated;
    };
    struct Range {
        int left = 0, top = 0, right = 0, bottom = 0;  ///< chunk indices; right and bottom are exclusive
    };

    void prepare(const TileGrid& grid, const TileSheet& sheet, int level);
    [[nodiscard]] Range visibleChunks(const AABB& visible, const TileGrid& grid,
                                      const TileSheet& sheet) const;
    void refresh(Chunk& chunk, int chunkX, int chunkY, const TileGrid& grid, const TileSheet& sheet);
    void build(Chunk& chunk, int chunkX, int chunkY, const TileGrid& grid, const TileSheet& sheet);
    void addBlock(Chunk& chunk, int x, int y, TileCell cell, const TileGrid& grid, const TileSheet& sheet);
    void addTile(Chunk& chunk, const SpriteInstance& instance, TextureHandle texture);
    void closePart(Chunk& chunk);
    void drawChunk(DrawList& list, const Chunk& chunk, const TileGrid& grid, const TileSheet& sheet,
                   const TilePlacement& placement) const;
    static void drawAnimated(DrawList& list, std::uint32_t cell, const TileGrid& grid, const TileSheet& sheet,
                             const TilePlacement& placement);
    void release(Chunk& chunk);
    void dropUnseen();

    RenderDevice& device_;
    std::vector<Chunk> chunks_;
    int chunkWidth_ = kSide;  ///< cells of the grid
    int chunkHeight_ = kSide;
    bool overlaps_ = false;  ///< some tiles are larger than their cells
    bool byRows_ = false;    ///< some tiles are both wider and higher than their cells
    int level_ = 0;          ///< one tile represents a block with sides of 2^level tiles
    int columns_ = 0;
    int rows_ = 0;
    std::uint32_t sheetVersion_ = 0;
    Vec2 cellSize_;
    Vec2 overhang_;  ///< px by which the largest tile extends beyond its cell
    std::uint64_t frame_ = 0;
    std::size_t built_ = 0;
    std::size_t kept_ = 0;
    std::vector<SpriteInstance> scratch_;
    Part open_;  ///< part under construction; its instances are in scratch_
};

}  // namespace plumb
