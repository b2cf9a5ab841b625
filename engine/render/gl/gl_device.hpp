#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/result.hpp"
#include "render/gl/gl_program.hpp"
#include "render/render_device.hpp"

namespace plumb {

/// Draws with OpenGL 3.3 core. The same context must be current at its creation and at every call.
class GlDevice final : public RenderDevice {
public:
    /// @error the context is older than 3.3
    static Result<std::unique_ptr<GlDevice>> create();
    ~GlDevice() override;
    GlDevice(const GlDevice&) = delete;
    GlDevice& operator=(const GlDevice&) = delete;

    TextureHandle createTexture(const Image& image, TextureFilter filter) override;
    void updateTexture(TextureHandle texture, int x, int y, const Image& image) override;
    void destroyTexture(TextureHandle texture) override;
    [[nodiscard]] PixelSize textureSize(TextureHandle texture) const override;
    [[nodiscard]] std::uintptr_t nativeTexture(TextureHandle texture) const override;
    TargetHandle createTarget(int width, int height) override;
    void destroyTarget(TargetHandle target) override;
    [[nodiscard]] TextureHandle targetTexture(TargetHandle target) const override;
    InstanceBufferHandle createInstances(std::span<const SpriteInstance> instances) override;
    void destroyInstances(InstanceBufferHandle buffer) override;
    /// Enables multisampling of the window, which smooths edges, with up to `samples` samples per
    /// pixel. Call resolveWindow() before the window is shown or read.
    void enableMultisampling(int samples);
    /// Resolves the samples of the window; does nothing without multisampling.
    void resolveWindow();
    void setWindowSize(PixelSize size) override;
    void setViewport(const Viewport& viewport) override;
    void clear(Color color) override;
    std::span<SpriteInstance> mapInstances(std::size_t count) override;
    void unmapInstances() override;
    void drawSprites(const SpriteBatch& batch) override;
    void drawGeometry(const GeometryBatch& batch) override;
    void show(TargetHandle source, const Viewport& viewport) override;
    [[nodiscard]] Image readPixels(TargetHandle target) override;
    [[nodiscard]] std::string description() const override;
    [[nodiscard]] std::size_t batchTextures() const override { return batchTextures_; }
    [[nodiscard]] bool drawsInSoftware() const override { return software_; }

private:
    struct Texture {
        GlName name = 0;
        PixelSize size;
    };
    struct Target {
        GlName name = 0;
        TextureHandle texture;
    };

    struct FrameBuffer {
        GlName name = 0;
        std::size_t capacity = 0;  ///< instances
        void* fence = nullptr;     ///< signaled when the card no longer reads the buffer
    };

    GlDevice() = default;
    void createState();
    Result<Done> buildPrograms();
    const GlProgram& spriteProgramFor(std::size_t textureCount);
    void bindTextures(const SpriteBatch& batch, const GlProgram& program);
    void setTransform(const GlProgram& program, const ViewTransform& transform) const;
    FrameBuffer& nextFrameBuffer(std::size_t count);
    [[nodiscard]] TextureHandle storeTexture(Texture texture);

    /// Programs for sprites by number of texture slots, built on first use.
    std::array<GlProgram, kTextureSlots + 1> spritePrograms_{};
    std::size_t batchTextures_ = kTextureSlots;
    bool software_ = false;
    GlProgram geometryProgram_;
    GlProgram textureProgram_;
    std::vector<Texture> textures_;
    std::vector<std::uint32_t> freeTextures_;
    std::vector<Target> targets_;
    std::vector<GlName> buffers_;  ///< indexed by handle; 0 is unused, it means the frame's memory
    std::vector<std::uint32_t> freeBuffers_;
    GlName spriteArray_ = 0;
    GlName geometryArray_ = 0;
    GlName geometryBuffer_ = 0;
    GlName emptyArray_ = 0;
    std::array<FrameBuffer, 3> frames_{};
    std::size_t frame_ = 0;                  ///< index in frames_ of the buffer written last
    std::vector<SpriteInstance> ownMemory_;  ///< used if the driver cannot map buffers
    std::size_t ownCount_ = 0;
    PixelSize windowSize_{1, 1};
    int windowSamples_ = 1;
    GlName windowSamplesBuffer_ = 0;  ///< multisampled renderbuffer of targets_[0]; 0: no multisampling
    bool flipped_ = false;  ///< drawing to a texture: upside down, so that its first row is the top one
    int maxTextureSide_ = 1024;
};

}  // namespace plumb
