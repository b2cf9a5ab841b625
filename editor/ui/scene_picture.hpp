#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/draw_list.hpp"
#include "render/render_device.hpp"
#include "scene/drawing/draw_scene.hpp"

namespace plumb::editor::ui {

/// A rectangular part of a texture, to be drawn by ImGui.
struct TexturePart {
    std::uintptr_t texture = 0;  ///< native (OpenGL) name of the texture
    Vec2 from;                   ///< texture coordinates of the upper left corner, 0..1
    Vec2 to;                     ///< texture coordinates of the lower right corner, 0..1
};

/// Draws a world into a texture, with the same renderer as the player application.
class SceneTexture {
public:
    SceneTexture(RenderDevice& device, AssetStore& assets, TextureFilter filter)
        : device_{device}, filter_{filter}, renderer_{device, assets, filter} {}
    ~SceneTexture() { device_.destroyTarget(target_); }
    SceneTexture(const SceneTexture&) = delete;
    SceneTexture& operator=(const SceneTexture&) = delete;

    /// Draws a world.
    /// @param assets   asset store of the running game; null: the editor's own store
    /// @param size     px: size of the texture
    /// @param alpha    interpolation factor between the last two ticks, 0..1
    /// @param asGame   true: backdrops and screen-space texts are placed as in the player application; false:
    ///                 they are drawn at their positions in the scene
    /// @param physics  physics layers drawn over the scene
    /// @return native (OpenGL) name of the texture
    std::uintptr_t draw(const World& world, AssetStore* assets, const View& view, PixelSize size, float alpha,
                        bool asGame, const PhysicsShown& physics = {});

    /// Settings for drawing a scene that is edited, not played.
    struct Preview {
        double ahead = 0.0;                    ///< s: time by which animated tiles are advanced
        std::vector<EntityId> hidden;          ///< entities not drawn, sorted
        const Particles* particles = nullptr;  ///< particles of previewed emitters; may be null
        float particleBack = 0.0f;             ///< s: drawn moment to the (later) last step of the particles
    };
    Preview preview;
    RenderCounts counts;  ///< draw calls, sprites etc. of the last call of `draw`

    /// Returns a part of one of the editor's textures. @param source  px; empty: the whole texture
    TexturePart part(TextureId id, const Rect& source);

private:
    RenderDevice& device_;
    TextureFilter filter_;
    SceneRenderer renderer_;
    std::unique_ptr<SceneRenderer> playRenderer_;  // renderer of a running game, which has its own textures
    AssetStore* playAssets_ = nullptr;
    DrawList list_;
    TargetHandle target_;
    PixelSize size_;
};

}  // namespace plumb::editor::ui
