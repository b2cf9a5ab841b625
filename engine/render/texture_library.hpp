#pragma once

#include <cstdint>

#include "assets/asset_store.hpp"
#include "assets/asset_table.hpp"
#include "render/texture_atlas.hpp"

namespace plumb {

/// The textures of a project on the graphics card: each goes there when it is first drawn, and again when its
/// file changed. Their pixels are then dropped from memory.
class TextureLibrary {
public:
    TextureLibrary(RenderDevice& device, AssetStore& assets, TextureFilter filter = TextureFilter::Nearest)
        : atlas_{device, filter}, assets_{assets} {}

    /// Where the picture is on the card; the white pixel for an empty id, the placeholder for what is
    /// missing.
    const TextureRegion& regionOf(TextureId id);

    /// Brings pictures that changed to the card and takes off those that the store unloaded. Once a frame; a
    /// few ns for each picture.
    void refresh();
    /// Takes a picture off the card, e.g. after the store unloaded it.
    void forget(TextureId id);

    /// Grows when a region moved: what was made of regions before must be made anew.
    [[nodiscard]] std::uint32_t version() const { return version_; }

private:
    struct Uploaded {
        TextureRegion region;
        std::uint32_t revision = 0;  ///< of the asset, when it was brought here
    };

    TextureAtlas atlas_;
    AssetStore& assets_;
    AssetTable<Uploaded> uploaded_;
    std::uint32_t version_ = 1;
};

}  // namespace plumb
