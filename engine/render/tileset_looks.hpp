#pragma once

#include <vector>

#include "assets/asset_store.hpp"
#include "render/texture_library.hpp"
#include "render/tile_chunks.hpp"

namespace plumb {

/// The looks of the tiles of one tileset on the graphics card, cached between frames.
class TilesetLooks {
public:
    /// @param tileSize  px of a cell in the world; {0, 0} takes the tileset's own
    /// @param seconds   since the scene began: which frame animated tiles show
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
