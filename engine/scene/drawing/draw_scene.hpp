#pragma once

#include <span>
#include <vector>

#include "assets/asset_store.hpp"
#include "ecs/world.hpp"
#include "render/draw_list.hpp"
#include "render/renderer.hpp"
#include "render/sized_target.hpp"
#include "render/texture_library.hpp"
#include "scene/drawing/label_drawing.hpp"
#include "scene/drawing/particle_drawing.hpp"
#include "scene/drawing/physics_drawing.hpp"
#include "scene/drawing/tile_drawing.hpp"
#include "scene/scene_layer.hpp"

namespace plumb {

/// For a place in the stack of scenes: all of them.
inline constexpr int kEveryScene = -1;

/// The view of the first enabled camera between its last two ticks, shake included; without one, the view
/// whose top-left corner is the world's origin.
/// @param picture  px, size of the game's picture
/// @param place    in the stack of scenes: only a camera of that scene
View cameraView(const World& world, Vec2 picture, float alpha, int place = kEveryScene);

/// How a world is looked at.
struct SceneView {
    View view;
    float alpha = 1.0f;    ///< between the last two ticks (ratio, 0..1)
    Vec2 parallaxOrigin;   ///< px, world: where the view's top-left corner shows backdrops at their place
    bool parallax = true;  ///< false draws backdrops where they are, as part of the world
    float grid = 0.0f;     ///< px of the target for each px of the picture: backdrops keep to them; 0: they
                           ///< lie where they come to lie
    int place = kEveryScene;               ///< in the stack of scenes: what is drawn
    LabelText labelText = nullptr;         ///< null shows texts as they are written
    double ahead = 0.0;                    ///< s by which animated tiles are shown ahead of the world's time
    std::span<const EntityId> hidden;      ///< entities not drawn (sorted), without those below them
    const Particles* particles = nullptr;  ///< drawn in place of the world's own
    float particleBack = 0.0f;             ///< s before the last step of `particles` that is drawn
};

inline constexpr double kSecondsPerTick = 1.0 / 60.0;  ///< of the fixed rate

/// Whether a view shows an entity, as far as scenes and hiding go.
[[nodiscard]] bool isSeen(const World& world, EntityId entity, const SceneView& how);

/// Turns a world into draw lists: sprites, backdrops, tile layers, texts. Keeps what is costly to make
/// between frames; changes nothing in the world.
class SceneRenderer {
public:
    /// @param filter  of pictures that are drawn enlarged, turned or between px
    SceneRenderer(RenderDevice& device, AssetStore& assets, TextureFilter filter = TextureFilter::Nearest);

    /// Fills `list` with what `how` sees of the world.
    void collect(const World& world, const SceneView& how, DrawList& list);

    /// Collects and draws each scene by its own camera, overlays over those below. Where no graphics card
    /// helps, what can be drawn small and enlarged without showing it is: backdrops, and everything in large
    /// windows.
    /// @param picture  px of the game's picture
    void draw(const World& world, Vec2 picture, float alpha, const Viewport& viewport,
              LabelText labelText = nullptr);

    /// Draws the physics over what is there already, with a legend.
    /// @param how  as the scene was looked at
    void drawPhysics(const World& world, const PhysicsShown& shown, const SceneView& how,
                     const Viewport& viewport);
    /// How the last draw looked at the lowest scene.
    [[nodiscard]] const SceneView& sceneView() const { return sceneView_; }

    [[nodiscard]] TextureLibrary& textures() { return textures_; }
    [[nodiscard]] Renderer& renderer() { return renderer_; }

private:
    void drawInto(const World& world, Vec2 picture, SceneView& how, const Viewport& viewport);
    void readLayers(const World& world, const SceneView& how);
    /// What is paused stands where its last tick left it.
    [[nodiscard]] float alphaOf(const World& world, EntityId entity, const SceneView& how) const;
    /// Calls draw(alpha, components...) for those of a query that are not left out.
    template <class... T, class Draw>
    void forSeen(const Query<const T...>& query, const World& world, const SceneView& how,
                 const Draw& draw) const;
    void collectBackground(const World& world, const SceneView& how, DrawList& list);
    /// What its scene says of a layer number; null draws it plainly.
    [[nodiscard]] const SceneLayer* layerOf(int order) const;
    /// Adds a sprite as its layer wants it. @param y  px, world: where it stands, for layers sorted by y
    void add(const SpriteQuad& quad, float y, const SceneView& how, DrawList& list) const;
    void collectSprites(const World& world, const SceneView& how, DrawList& list);
    void collectBackdrops(const World& world, const SceneView& how, DrawList& list);
    void collectTiles(const World& world, const SceneView& how, DrawList& list);
    void collectParticles(const World& world, const SceneView& how, DrawList& list);
    void collectLabels(const World& world, const SceneView& how, DrawList& list);

    AssetStore& assets_;
    Renderer renderer_;
    TextureLibrary textures_;
    TileDrawing tiles_;
    LabelDrawing labels_;
    ParticleDrawing particles_;
    PhysicsDrawing physics_;
    DrawList list_;
    std::vector<SceneLayer> layers_;  ///< of the scenes, by order
    int nearLayer_ = 0;               ///< the lowest layer of the last collect that is no plain backdrop
    SizedTarget far_;                 ///< the backdrops, one px for each px of the picture
    SizedTarget canvas_;              ///< everything, before it is enlarged to a large window
    SceneView sceneView_;
    bool anyPaused_ = false;
};

}  // namespace plumb
