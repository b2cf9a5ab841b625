#pragma once

#include <cstdint>

#include "assets/asset_store.hpp"
#include "assets/asset_table.hpp"
#include "render/texture_atlas.hpp"

namespace plumb {

/// The textures of a project on the graphics card. Each is uploaded when it is first drawn
/// and when its file changes; then its pixels in main memory are released.
class TextureLibrary {
public:
    TextureLibrary(RenderDevice& device, AssetStore& assets, TextureFilter filter = TextureFilter::Nearest)
        : atlas_{device, filter}, assets_{assets} {}

    /// Returns the region of a texture, uploaded if necessary; the white
    /// pixel for an empty id, the placeholder for a missing file.
    const TextureRegion& regionOf(TextureId id);

    /// Uploads textures that changed and removes those that the asset store
    /// unloaded. Call once per frame; costs a few ns per texture.
    void refresh();
    /// Removes a texture from the card, e.g. after the asset store unloaded it.
    void forget(TextureId id);

    /// Increases when a region moved: data derived from regions must be rebuilt.
    [[nodiscard]] std::uint32_t version() const { return version_; }

private:
    struct Uploaded {
        TextureRegion region;
        std::uint32_t revision = 0;  ///< revision of the uploaded asset
    };

    TextureAtlas atlas_;
    AssetStore& assets_;
    AssetTable<Uploaded> uploaded_;
    std::uint32_t version_ = 1;
};

}  // namespace plumb
