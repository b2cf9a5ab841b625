#include "render/recording_device.hpp"

#include <algorithm>

namespace plumb {
namespace {

std::size_t pixelCount(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

}  // namespace

void RecordingDevice::clearDraws() {
    spriteDraws.clear();
    geometryDraws.clear();
    showCalls.clear();
}

TextureHandle RecordingDevice::createTexture(const Image& image, TextureFilter) {
    textures_.push_back(image);
    ++texturesCreated;
    return {static_cast<std::uint32_t>(textures_.size() - 1)};
}

void RecordingDevice::updateTexture(TextureHandle texture, int x, int y, const Image& image) {
    Image& old = textures_[texture.index];
    PLUMB_ASSERT(x >= 0 && y >= 0 && x + image.width <= old.width && y + image.height <= old.height,
                 "an update must lie inside its texture");
    for (int row = 0; row < image.height; ++row) {
        const auto from = image.rgba.begin() + static_cast<std::ptrdiff_t>(pixelCount(image.width, row) * 4);
        const std::size_t to = (pixelCount(old.width, y + row) + static_cast<std::size_t>(x)) * 4;
        std::copy_n(from, image.width * 4, old.rgba.begin() + static_cast<std::ptrdiff_t>(to));
    }
}

void RecordingDevice::destroyTexture(TextureHandle texture) { textures_[texture.index] = Image{}; }

PixelSize RecordingDevice::textureSize(TextureHandle texture) const {
    return {textures_[texture.index].width, textures_[texture.index].height};
}

TargetHandle RecordingDevice::createTarget(int width, int height) {
    targets_.push_back(createTexture(
        {width, height, std::vector<std::uint8_t>(pixelCount(width, height) * 4)}, TextureFilter::Nearest));
    return {static_cast<std::uint32_t>(targets_.size() - 1)};
}

void RecordingDevice::destroyTarget(TargetHandle target) { destroyTexture(targets_[target.index]); }
TextureHandle RecordingDevice::targetTexture(TargetHandle target) const { return targets_[target.index]; }

InstanceBufferHandle RecordingDevice::createInstances(std::span<const SpriteInstance> instances) {
    ++buffersCreated;
    buffers_.emplace_back(instances.begin(), instances.end());
    return {static_cast<std::uint32_t>(buffers_.size() - 1)};
}

void RecordingDevice::destroyInstances(InstanceBufferHandle buffer) {
    buffers_[buffer.index] = std::vector<SpriteInstance>{};  // clear() would keep its memory
}

std::span<SpriteInstance> RecordingDevice::mapInstances(std::size_t count) {
    buffers_.front().resize(count);
    return buffers_.front();
}

void RecordingDevice::drawSprites(const SpriteBatch& batch) {
    if (!recordsDraws) return;
    const auto first = buffers_[batch.buffer.index].begin() + static_cast<std::ptrdiff_t>(batch.first);
    spriteDraws.push_back({batch, viewport_, {first, first + static_cast<std::ptrdiff_t>(batch.count)}});
}

void RecordingDevice::drawGeometry(const GeometryBatch& batch) {
    if (!recordsDraws) return;
    geometryDraws.push_back({{batch.vertices.begin(), batch.vertices.end()}, viewport_, spriteDraws.size()});
}

void RecordingDevice::show(TargetHandle source, const Viewport& viewport) {
    showCalls.push_back({source, viewport, spriteDraws.size()});
}

Image RecordingDevice::readPixels(TargetHandle target) {
    const PixelSize size = target.index == 0 ? windowSize_ : textureSize(targetTexture(target));
    Image image{size.width, size.height, {}};
    image.rgba.reserve(pixelCount(size.width, size.height) * 4);
    for (std::size_t i = 0; i < pixelCount(size.width, size.height); ++i) {
        image.rgba.insert(image.rgba.end(), {cleared_.r, cleared_.g, cleared_.b, cleared_.a});
    }
    return image;
}

}  // namespace plumb
