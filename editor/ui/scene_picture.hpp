#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/draw_list.hpp"
#include "render/render_device.hpp"
#include "scene/drawing/draw_scene.hpp"

namespace plumb::editor::ui {

/// A part of a picture as ImGui draws it.
struct TexturePart {
    std::uintptr_t texture = 0;  ///< the graphics card's name
    Vec2 from;                   ///< ratio of the texture
    Vec2 to;                     ///< ratio of the texture
};

/// Draws a world into a texture by the renderer that the player uses.
class ScenePicture {
public:
    ScenePicture(RenderDevice& device, AssetStore& assets, TextureFilter filter)
        : device_{device}, filter_{filter}, renderer_{device, assets, filter} {}
    ~ScenePicture() { device_.destroyTarget(target_); }
    ScenePicture(const ScenePicture&) = delete;
    ScenePicture& operator=(const ScenePicture&) = delete;

    /// @param assets  those of the game that plays; null: the editor's own
    /// @param size   px of the texture
    /// @param alpha  between the last two ticks (ratio, 0..1)
    /// @param asGame  backdrops and texts on the screen keep to the picture, as the player draws it; else
    /// they
    ///                are where the scene has them
    /// @param physics  what of it is drawn over the scene
    /// @return the graphics card's name of the texture
    std::uintptr_t draw(const World& world, AssetStore* assets, const View& view, PixelSize size, float alpha,
                        bool asGame, const PhysicsShown& physics = {});

    /// What only the editor's own look at a scene has.
    struct Preview {
        double ahead = 0.0;                    ///< s: animated tiles move though nothing plays
        std::vector<EntityId> hidden;          ///< what is not drawn (sorted)
        const Particles* particles = nullptr;  ///< of emitters that are previewed
        float particleBack = 0.0f;             ///< s from what is drawn to their last step
    };
    Preview preview;
    RenderCounts counts;  ///< of the last picture

    /// Where a part of one of the editor's pictures is on the card. @param source  px; empty: all of it
    TexturePart part(TextureId id, const Rect& source);

private:
    RenderDevice& device_;
    TextureFilter filter_;
    SceneRenderer renderer_;
    std::unique_ptr<SceneRenderer> playRenderer_;  // a game has pictures of its own
    AssetStore* playAssets_ = nullptr;
    DrawList list_;
    TargetHandle target_;
    PixelSize size_;
};

}  // namespace plumb::editor::ui
