#pragma once

#include <vector>

#include "assets/asset_store.hpp"
#include "render/texture_library.hpp"
#include "render/tile_chunks.hpp"

namespace plumb {

/// Cache of the texture regions of a tileset's tiles on the graphics card.
class TilesetLooks {
public:
    /// Returns the texture regions of all tiles at the time `seconds`.
    /// @param tileSize  cell size, px, world; {0, 0}: the tileset's tile size
    /// @param seconds   time since the scene began, for animated tiles
    /// @return          valid until the next call
    TileSheet sheet(const AssetStore& assets, TextureLibrary& textures, TilesetId id, Vec2 tileSize,
                    double seconds);

private:
    void rebuild(const Tileset& tileset, TextureLibrary& textures);
    void animate(const Tileset& tileset, TextureLibrary& textures, double seconds);

    std::vector<TileLook> looks_;
    TilesetId id_;
    std::uint32_t revision_ = 0;
    std::uint32_t textureVersion_ = 0;
    std::uint32_t version_ = 0;
};

}  // namespace plumb
