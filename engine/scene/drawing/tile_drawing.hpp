#pragma once

#include <memory>
#include <vector>

#include "assets/asset_store.hpp"
#include "ecs/world.hpp"
#include "render/texture_library.hpp"
#include "render/tile_chunks.hpp"
#include "render/tileset_looks.hpp"
#include "scene/components/drawing/tile_layer.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

/// True if the tileset has an animated tile.
bool isAnimated(const Tileset& tileset);

/// Draws the tile layers of a world; keeps their chunks in GPU memory between frames.
class TileDrawing {
public:
    TileDrawing(RenderDevice& device, AssetStore& assets, TextureLibrary& textures)
        : device_{device}, assets_{assets}, textures_{textures} {}

    /// @param seconds  game time, s, for animated tiles
    void beginFrame(double seconds);
    void draw(const World& world, EntityId entity, const TileLayer& layer, const Pose& pose, DrawList& list);

private:
    struct Sheet {
        TilesetId tileset;
        TilesetLooks looks;
    };
    struct Layer {
        EntityId entity;
        TilesId cells;
        TilesetId tileset;
        Vec2 scale;                    ///< world scale of the entity
        std::uint64_t drawnFrame = 0;  ///< frame_ of the last draw()
        std::unique_ptr<TileChunks> chunks;
    };

    TilesetLooks& looksOf(TilesetId id);
    TileChunks& chunksOf(EntityId entity, const TileLayer& layer, Vec2 scale);

    RenderDevice& device_;
    AssetStore& assets_;
    TextureLibrary& textures_;
    std::vector<std::unique_ptr<Sheet>> sheets_;
    std::vector<Layer> layers_;
    double seconds_ = 0.0;
    std::uint64_t frame_ = 0;
};

}  // namespace plumb
