#include "render/texture_atlas.hpp"

#include <algorithm>

namespace plumb {
namespace {

Image emptyPage() {
    constexpr auto kSide = static_cast<std::size_t>(TextureAtlas::kPageSide);
    return {TextureAtlas::kPageSide, TextureAtlas::kPageSide, std::vector<std::uint8_t>(kSide * kSide * 4)};
}

}  // namespace

Rect TextureRegion::part(const Rect& rect) const {
    const auto wide = static_cast<float>(width);
    const auto high = static_cast<float>(height);
    const Vec2 low{std::clamp(rect.x, 0.0f, wide), std::clamp(rect.y, 0.0f, high)};
    const Vec2 size{std::clamp(rect.x + rect.width, low.x, wide) - low.x,
                    std::clamp(rect.y + rect.height, low.y, high) - low.y};
    return {low.x + static_cast<float>(x), low.y + static_cast<float>(y), size.x, size.y};
}

TextureAtlas::~TextureAtlas() {
    for (const Page& page : pages_) device_.destroyTexture(page.texture);
    for (const TextureHandle texture : ownTextures_) device_.destroyTexture(texture);
}

TextureRegion TextureAtlas::add(const Image& image) {
    if (image.empty()) return {{}, 0, 0, 1, 1};
    const bool shared = std::max(image.width, image.height) <= kLargestShared;
    return shared ? addToPage(image) : addAlone(image);
}

TextureRegion TextureAtlas::addToPage(const Image& image) {
    for (std::size_t i = 0; i <= pages_.size(); ++i) {
        if (i == pages_.size()) {
            Page page;
            page.texture = device_.createTexture(emptyPage(), filter_);
            pages_.push_back(std::move(page));
        }
        Page& page = pages_[i];
        if (const std::optional<Skyline::Place> place = page.free.add(image.width, image.height)) {
            ++page.pictures;
            device_.updateTexture(page.texture, place->x, place->y, image);
            return {page.texture, place->x, place->y, image.width, image.height};
        }
    }
    return {};
}

TextureRegion TextureAtlas::addAlone(const Image& image) {
    const TextureHandle texture = device_.createTexture(image, filter_);
    if (texture == TextureHandle{}) return {{}, 0, 0, 1, 1};  // the image is larger than the card supports
    ownTextures_.push_back(texture);
    return {texture, 0, 0, image.width, image.height};
}

TextureRegion TextureAtlas::replace(const TextureRegion& region, const Image& image) {
    if (region.texture == TextureHandle{} || region.width != image.width || region.height != image.height) {
        remove(region);
        return add(image);
    }
    device_.updateTexture(region.texture, region.x, region.y, image);
    return region;
}

void TextureAtlas::remove(const TextureRegion& region) {
    const auto page = std::find_if(pages_.begin(), pages_.end(), [&](const Page& candidate) {
        return candidate.texture == region.texture;
    });
    if (page != pages_.end()) {
        if (--page->pictures == 0) page->free = Skyline{kPageSide};
        return;
    }
    const auto own = std::find(ownTextures_.begin(), ownTextures_.end(), region.texture);
    if (own == ownTextures_.end()) return;
    device_.destroyTexture(*own);
    ownTextures_.erase(own);
}

}  // namespace plumb
