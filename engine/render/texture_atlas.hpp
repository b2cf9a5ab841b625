#pragma once

#include <vector>

#include "math/rect.hpp"
#include "render/render_device.hpp"
#include "render/skyline.hpp"

namespace plumb {

/// An image on the graphics card: a whole texture or a region of one.
struct TextureRegion {
    TextureHandle texture;
    int x = 0;  ///< texels
    int y = 0;
    int width = 0;
    int height = 0;

    /// Converts a rectangle of the image, px from its top left corner, to a sprite source in the
    /// texture. Clipped to the image, because other images may be adjacent in the texture.
    [[nodiscard]] Rect part(const Rect& rect) const;
    [[nodiscard]] Rect whole() const {
        return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(width),
                static_cast<float>(height)};
    }
    friend bool operator==(const TextureRegion&, const TextureRegion&) = default;
};

/// Uploads images to the graphics card, small ones to shared pages, so that sprites share draw
/// calls. No space is needed between images: the shaders never sample outside a sprite's source.
class TextureAtlas {
public:
    static constexpr int kPageSide = 1024;      ///< texels
    static constexpr int kLargestShared = 512;  ///< texels; images with a longer side have their own texture

    explicit TextureAtlas(RenderDevice& device, TextureFilter filter = TextureFilter::Nearest)
        : device_{device}, filter_{filter} {}
    ~TextureAtlas();
    TextureAtlas(const TextureAtlas&) = delete;
    TextureAtlas& operator=(const TextureAtlas&) = delete;

    TextureRegion add(const Image& image);
    /// Replaces the pixels of an image. @return its new region, the same as before if the size is unchanged
    TextureRegion replace(const TextureRegion& region, const Image& image);
    /// Removes an image. The space on a page is reused only after the page's last image is removed.
    void remove(const TextureRegion& region);

    [[nodiscard]] std::size_t textureCount() const { return pages_.size() + ownTextures_.size(); }

private:
    struct Page {
        TextureHandle texture;
        Skyline free{kPageSide};
        int pictures = 0;  ///< number of images on the page
    };

    TextureRegion addToPage(const Image& image);
    TextureRegion addAlone(const Image& image);

    RenderDevice& device_;
    TextureFilter filter_;
    std::vector<Page> pages_;
    std::vector<TextureHandle> ownTextures_;
};

}  // namespace plumb
