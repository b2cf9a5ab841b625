#pragma once

#include <functional>
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

/// Scene index that stands for all scenes of the stack.
inline constexpr int kAllScenes = -1;

/// Returns the view of the first enabled camera, interpolated between its last two ticks, with shake. Without
/// a camera: the view whose top-left corner is the world's origin.
/// @param picture  px, size of the game image
/// @param alpha    ratio between the last two ticks, 0..1
/// @param place    index in the scene stack; only cameras of that scene are considered
View cameraView(const World& world, Vec2 picture, float alpha, int place = kAllScenes);

/// Parameters for drawing a world.
struct SceneView {
    View view;
    float alpha = 1.0f;      ///< ratio between the last two ticks, 0..1
    Vec2 parallaxOrigin;     ///< px, world: top-left corner of the view at which parallax shifts nothing
    bool parallax = true;    ///< false: draw backdrops at their world positions
    float grid = 0.0f;       ///< target px per game image px, the grid that backdrops are aligned to; 0: none
    int place = kAllScenes;  ///< index in the scene stack of the scene to draw
    LabelText labelText = nullptr;     ///< fills in placeholders of labels; null: texts are drawn unchanged
    double ahead = 0.0;                ///< s by which animated tiles are ahead of the world's time
    std::span<const EntityId> hidden;  ///< sorted entities that are not drawn; their children are drawn
    const Particles* particles = nullptr;  ///< drawn instead of the world's particles; null: draw those
    float particleBack = 0.0f;             ///< s from the drawn moment to the last step of `particles`
};

inline constexpr double kSecondsPerTick = 1.0 / 60.0;  ///< s, fixed length of a tick

/// True if the entity is in a drawn scene and not in `how.hidden`. Does not check if it is inside the view.
[[nodiscard]] bool isSeen(const World& world, EntityId entity, const SceneView& how);

/// Draws a world: sprites, backdrops, tile layers, labels, particles and soft bodies. Caches GPU resources
/// between frames; does not change the world.
class SceneRenderer {
public:
    /// @param filter  filter of textures that are enlarged, rotated or not aligned to pixels
    SceneRenderer(RenderDevice& device, AssetStore& assets, TextureFilter filter = TextureFilter::Nearest);

    /// Adds the visible part of the world to `list`.
    void collect(const World& world, const SceneView& how, DrawList& list);

    /// Collects and draws each scene with its own camera, overlays on top. With
    /// software rendering, backdrops and, in large windows, whole scenes are
    /// drawn at a lower resolution and enlarged where the result looks the same.
    /// @param picture  px, size of the game image
    void draw(const World& world, Vec2 picture, float alpha, const Viewport& viewport,
              LabelText labelText = nullptr);

    /// Draws the physics debug view with a legend over the current image.
    /// @param how  parameters with which the scene was drawn
    void drawPhysics(const World& world, const PhysicsShown& shown, const SceneView& how,
                     const Viewport& viewport);
    /// Draws over the current image.
    /// @param size  of the view, px
    /// @param add   fills the list
    void drawOver(Vec2 size, const Viewport& viewport,
                  const std::function<void(LabelDrawing& labels, DrawList& list)>& add);
    /// Parameters with which the last draw() drew the bottom scene.
    [[nodiscard]] const SceneView& sceneView() const { return sceneView_; }

    [[nodiscard]] TextureLibrary& textures() { return textures_; }
    [[nodiscard]] Renderer& renderer() { return renderer_; }

private:
    void drawInto(const World& world, Vec2 picture, SceneView& how, const Viewport& viewport);
    void readLayers(const World& world, const SceneView& how);
    /// Returns the interpolation ratio of an entity; 1 if it
    /// is paused, as it stays at the pose of its last tick.
    [[nodiscard]] float alphaOf(const World& world, EntityId entity, const SceneView& how) const;
    /// Calls draw(alpha, components...) for every entity of the query that isSeen().
    template <class... T, class Draw>
    void forSeen(const Query<const T...>& query, const World& world, const SceneView& how,
                 const Draw& draw) const;
    void collectBackground(const World& world, const SceneView& how, DrawList& list);
    /// Returns the scene's settings of a layer number; null if there are none.
    [[nodiscard]] const SceneLayer* layerOf(int order) const;
    /// Adds a sprite with the settings of its layer. @param y  px, world: sort position in layers sorted by y
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
    WorldPoses poses_;  ///< within a collect()
    DrawList list_;
    std::vector<SceneLayer> layers_;  ///< layer settings of the drawn scenes, bottom scene first
    int lowestFrontLayer_ = 0;        ///< lowest layer of the last collect() that is not only backdrops
    SizedTarget backdropTarget_;      ///< target for backdrops, at the resolution of the game image
    SizedTarget canvas_;              ///< target for whole scenes, before they are enlarged to a large window
    SceneView sceneView_;
    bool anyPaused_ = false;  ///< an entity of the world is paused
};

}  // namespace plumb
