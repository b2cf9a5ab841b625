#pragma once

#include <vector>

#include "render/render_device.hpp"

namespace plumb {

/// A device that records its draw calls, for tests and headless runs without a graphics card.
class RecordingDevice final : public RenderDevice {
public:
    struct SpriteDraw {
        SpriteBatch batch;
        Viewport viewport;
        std::vector<SpriteInstance> instances;  ///< copy of the batch's instances, in drawing order
    };
    struct GeometryDraw {
        std::vector<GeometryVertex> vertices;
        Viewport viewport;
        std::size_t afterSprites = 0;  ///< number of sprite draws before this one
    };

    struct ShowCall {
        TargetHandle source;
        Viewport viewport;
        std::size_t afterSprites = 0;
    };

    std::vector<SpriteDraw> spriteDraws;
    std::vector<GeometryDraw> geometryDraws;
    std::vector<ShowCall> showCalls;
    std::size_t texturesCreated = 0;
    std::size_t buffersCreated = 0;
    std::size_t maxTextures = kTextureSlots;  ///< result of batchTextures()
    bool software = false;                    ///< result of drawsInSoftware()
    bool recordsDraws = true;  ///< false: sprite and geometry draws are discarded, to save memory

    [[nodiscard]] std::size_t drawCalls() const { return spriteDraws.size() + geometryDraws.size(); }
    /// Removes recorded draws; keeps textures and buffers.
    void clearDraws();

    TextureHandle createTexture(const Image& image, TextureFilter filter) override;
    void updateTexture(TextureHandle texture, int x, int y, const Image& image) override;
    void destroyTexture(TextureHandle texture) override;
    [[nodiscard]] PixelSize textureSize(TextureHandle texture) const override;
    [[nodiscard]] std::uintptr_t nativeTexture(TextureHandle texture) const override { return texture.index; }
    TargetHandle createTarget(int width, int height) override;
    void destroyTarget(TargetHandle target) override;
    [[nodiscard]] TextureHandle targetTexture(TargetHandle target) const override;
    InstanceBufferHandle createInstances(std::span<const SpriteInstance> instances) override;
    void destroyInstances(InstanceBufferHandle buffer) override;
    void setWindowSize(PixelSize size) override { windowSize_ = size; }
    void setViewport(const Viewport& viewport) override { viewport_ = viewport; }
    void clear(Color color) override { cleared_ = color; }
    std::span<SpriteInstance> mapInstances(std::size_t count) override;
    void unmapInstances() override {}
    void drawSprites(const SpriteBatch& batch) override;
    void drawGeometry(const GeometryBatch& batch) override;
    void show(TargetHandle source, const Viewport& viewport) override;
    /// Returns an image filled with the color of the last clear.
    [[nodiscard]] Image readPixels(TargetHandle target) override;
    [[nodiscard]] std::string description() const override { return "recording"; }
    [[nodiscard]] std::size_t batchTextures() const override { return maxTextures; }
    [[nodiscard]] bool drawsInSoftware() const override { return software; }

    /// Returns the current content of a texture.
    [[nodiscard]] const Image& image(TextureHandle texture) const { return textures_[texture.index]; }

private:
    std::vector<Image> textures_{Image{1, 1, {255, 255, 255, 255}}};
    std::vector<TextureHandle> targets_{TextureHandle{}};
    std::vector<std::vector<SpriteInstance>> buffers_{{}};
    PixelSize windowSize_;
    Viewport viewport_;
    Color cleared_;
};

}  // namespace plumb
