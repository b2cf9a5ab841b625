#pragma once

#include <vector>

#include "math/rect.hpp"
#include "render/render_device.hpp"
#include "render/skyline.hpp"

namespace plumb {

/// A picture on the graphics card: all of a texture or a part of one.
struct TextureRegion {
    TextureHandle texture;
    int x = 0;  ///< texels
    int y = 0;
    int width = 0;
    int height = 0;

    /// A part of the picture, px from its own top left, as a source for a sprite. What lies outside is cut
    /// off: there are other pictures.
    [[nodiscard]] Rect part(const Rect& rect) const;
    [[nodiscard]] Rect whole() const {
        return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(width),
                static_cast<float>(height)};
    }
    friend bool operator==(const TextureRegion&, const TextureRegion&) = default;
};

/// Puts pictures on the graphics card, small ones together on pages, so that what they draw shares draw
/// calls. No space is left between them: the shaders never sample outside a sprite's source.
class TextureAtlas {
public:
    static constexpr int kPageSide = 1024;      ///< texels
    static constexpr int kLargestShared = 512;  ///< a longer side gets a texture of its own

    explicit TextureAtlas(RenderDevice& device, TextureFilter filter = TextureFilter::Nearest)
        : device_{device}, filter_{filter} {}
    ~TextureAtlas();
    TextureAtlas(const TextureAtlas&) = delete;
    TextureAtlas& operator=(const TextureAtlas&) = delete;

    TextureRegion add(const Image& image);
    /// New pixels; the region stays where it is when the size is the same.
    TextureRegion replace(const TextureRegion& region, const Image& image);
    /// A page comes free when the last picture on it is removed.
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
