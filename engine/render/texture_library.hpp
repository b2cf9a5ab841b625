#pragma once

#include <cstdint>

#include "assets/asset_store.hpp"
#include "assets/asset_table.hpp"
#include "render/texture_atlas.hpp"

namespace plumb {

/// The textures of a project on the graphics card: each is uploaded when it is first
/// drawn, and again when its file changes. Its pixels in main memory are then released.
class TextureLibrary {
public:
    TextureLibrary(RenderDevice& device, AssetStore& assets, TextureFilter filter = TextureFilter::Nearest)
        : atlas_{device, filter}, assets_{assets} {}

    /// The region of a picture; the white pixel for an
    /// empty id, the placeholder for a missing one.
    const TextureRegion& regionOf(TextureId id);

    /// Uploads pictures that changed and removes those that the store
    /// unloaded. Call once per frame; costs a few ns per picture.
    void refresh();
    /// Removes a picture from the card, e.g. after the store unloaded it.
    void forget(TextureId id);

    /// Increases when a region moved: data derived from regions must be rebuilt.
    [[nodiscard]] std::uint32_t version() const { return version_; }

private:
    struct Uploaded {
        TextureRegion region;
        std::uint32_t revision = 0;  ///< of the asset, when it was uploaded
    };

    TextureAtlas atlas_;
    AssetStore& assets_;
    AssetTable<Uploaded> uploaded_;
    std::uint32_t version_ = 1;
};

}  // namespace plumb
