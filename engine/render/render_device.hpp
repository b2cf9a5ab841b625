#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "math/color.hpp"
#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "platform/image.hpp"
#include "platform/window.hpp"

namespace plumb {

/// Handle of a texture of a device; 0 is the device's built-in white texture of 1 x 1 px.
struct TextureHandle {
    std::uint32_t index = 0;
    friend bool operator==(TextureHandle, TextureHandle) = default;
};
/// Handle of a render target; 0 is the window.
struct TargetHandle {
    std::uint32_t index = 0;
    friend bool operator==(TargetHandle, TargetHandle) = default;
};
/// Handle of sprites that stay in the device's memory; 0: none.
struct InstanceBufferHandle {
    std::uint32_t index = 0;
    friend bool operator==(InstanceBufferHandle, InstanceBufferHandle) = default;
};

enum class TextureFilter : std::uint8_t { Nearest, Linear };

/// Source rectangles are stored in quarter texels, so integer texels are exact in textures of any size.
inline constexpr float kUvPerTexel = 4.0f;
constexpr std::uint16_t uvFromTexels(float texels) {
    const float quarters = texels * kUvPerTexel + 0.5f;
    if (quarters >= 65535.0f) return 65535;
    return quarters > 0.0f ? static_cast<std::uint16_t>(quarters) : std::uint16_t{0};
}

/// One textured quad in the device's format. 36 bytes: 50,000 of them are 1.8 MB per frame.
struct SpriteInstance {
    Vec2 center;                        ///< px, world
    Vec2 half;                          ///< half of the size, px
    float rotation = 0.0f;              ///< rad about the center
    std::array<std::uint16_t, 4> uv{};  ///< left, top, right, bottom in quarter texels; swapped ends flip
    Color tint;
    std::uint32_t slot = 0;  ///< texture slot of the batch (low byte) and the flags below
};
static_assert(sizeof(SpriteInstance) == 36, "the vertex layout in gl/ requires 36 bytes");

inline constexpr std::uint32_t kSpriteDiagonal = 0x100u;  ///< swaps x and y of the source (tiles)
inline constexpr std::uint32_t kSpriteAdditive = 0x200u;  ///< additive blending instead of alpha blending

/// A corner of a filled triangle.
struct GeometryVertex {
    Vec2 position;  ///< px, world
    Color color;
};

/// Transform from world to clip space: clip = {dot(x, world) + offset.x, dot(y, world) + offset.y}.
struct ViewTransform {
    Vec2 x{1.0f, 0.0f};
    Vec2 y{0.0f, 1.0f};
    Vec2 offset;
    friend bool operator==(const ViewTransform&, const ViewTransform&) = default;
};

inline constexpr std::size_t kTextureSlots = 16;

/// Sprites of one draw call: consecutive instances that need at most kTextureSlots textures.
struct SpriteBatch {
    InstanceBufferHandle buffer;  ///< 0: instances written by mapInstances() in this frame
    std::size_t first = 0;        ///< index of the first instance in the buffer
    std::size_t count = 0;
    std::array<TextureHandle, kTextureSlots> textures{};
    std::size_t textureCount = 0;
    ViewTransform transform;
    Color tint;  ///< multiplied with the color of every instance, e.g. to fade a retained layer
};

struct GeometryBatch {
    std::span<const GeometryVertex> vertices;  ///< three consecutive ones per triangle
    ViewTransform transform;
};

/// The area of a target for the next draws, px from its top left corner.
struct Viewport {
    TargetHandle target;
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    friend bool operator==(const Viewport&, const Viewport&) = default;
};

/// Interface of a graphics card for the renderer. One implementation uses
/// OpenGL, another records the calls so that tests need no card.
class RenderDevice {
public:
    virtual ~RenderDevice() = default;

    virtual TextureHandle createTexture(const Image& image, TextureFilter filter) = 0;
    /// Replaces a region of a texture; `image` is copied to (x, y) and must fit.
    virtual void updateTexture(TextureHandle texture, int x, int y, const Image& image) = 0;
    virtual void destroyTexture(TextureHandle texture) = 0;
    [[nodiscard]] virtual PixelSize textureSize(TextureHandle texture) const = 0;
    /// The API's own handle, e.g. for ImGui.
    [[nodiscard]] virtual std::uintptr_t nativeTexture(TextureHandle texture) const = 0;

    virtual TargetHandle createTarget(int width, int height) = 0;
    virtual void destroyTarget(TargetHandle target) = 0;
    /// Returns the content of a target as a texture, top row first.
    [[nodiscard]] virtual TextureHandle targetTexture(TargetHandle target) const = 0;

    virtual InstanceBufferHandle createInstances(std::span<const SpriteInstance> instances) = 0;
    virtual void destroyInstances(InstanceBufferHandle buffer) = 0;

    /// Sets the size of the window's framebuffer, px.
    virtual void setWindowSize(PixelSize size) = 0;
    virtual void setViewport(const Viewport& viewport) = 0;
    /// Clears the whole target of the viewport.
    virtual void clear(Color color) = 0;

    /// Returns memory for `count` instances: write it front to back, then call unmapInstances.
    /// Its previous content is lost; batches drawn before are not affected.
    virtual std::span<SpriteInstance> mapInstances(std::size_t count) = 0;
    virtual void unmapInstances() = 0;
    virtual void drawSprites(const SpriteBatch& batch) = 0;
    virtual void drawGeometry(const GeometryBatch& batch) = 0;
    /// Fills a viewport with the content of a target, scaled without smoothing and without blending.
    virtual void show(TargetHandle source, const Viewport& viewport) = 0;

    /// Returns the pixels of a target or, before the buffers are swapped, of the window.
    [[nodiscard]] virtual Image readPixels(TargetHandle target) = 0;
    [[nodiscard]] virtual std::string description() const = 0;
    /// Recommended maximum number of textures per sprite batch, 1..kTextureSlots.
    [[nodiscard]] virtual std::size_t batchTextures() const { return kTextureSlots; }
    /// True for software rendering, where every pixel costs CPU time.
    [[nodiscard]] virtual bool drawsInSoftware() const { return false; }
};

}  // namespace plumb
