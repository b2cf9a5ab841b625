#pragma once

#include <vector>

#include "math/rect.hpp"
#include "render/render_device.hpp"
#include "render/skyline.hpp"

namespace plumb {

/// A picture on the graphics card: a whole texture or a part of one.
struct TextureRegion {
    TextureHandle texture;
    int x = 0;  ///< texels
    int y = 0;
    int width = 0;
    int height = 0;

    /// A part of the picture, px from its own top left corner, as a sprite source. Clipped
    /// to the picture, because its surroundings in the texture are other pictures.
    [[nodiscard]] Rect part(const Rect& rect) const;
    [[nodiscard]] Rect whole() const {
        return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(width),
                static_cast<float>(height)};
    }
    friend bool operator==(const TextureRegion&, const TextureRegion&) = default;
};

/// Uploads pictures to the graphics card, small ones together on pages, so that sprites share draw
/// calls. No space is needed between them: the shaders never sample outside a sprite's source.
class TextureAtlas {
public:
    static constexpr int kPageSide = 1024;      ///< texels
    static constexpr int kLargestShared = 512;  ///< pictures with a longer side get their own texture

    explicit TextureAtlas(RenderDevice& device, TextureFilter filter = TextureFilter::Nearest)
        : device_{device}, filter_{filter} {}
    ~TextureAtlas();
    TextureAtlas(const TextureAtlas&) = delete;
    TextureAtlas& operator=(const TextureAtlas&) = delete;

    TextureRegion add(const Image& image);
    /// Replaces the pixels; the region stays the same if the size does.
    TextureRegion replace(const TextureRegion& region, const Image& image);
    /// A page is freed when its last picture is removed.
    void remove(const TextureRegion& region);

    [[nodiscard]] std::size_t textureCount() const { return pages_.size() + ownTextures_.size(); }

private:
    struct Page {
        TextureHandle texture;
        Skyline free{kPageSide};
        int pictures = 0;
    };

    TextureRegion addToPage(const Image& image);
    TextureRegion addAlone(const Image& image);

    RenderDevice& device_;
    TextureFilter filter_;
    std::vector<Page> pages_;
    std::vector<TextureHandle> ownTextures_;
};

}  // namespace plumb
