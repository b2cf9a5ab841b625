#include "scene/drawing/draw_scene.hpp"

#include <algorithm>
#include <cmath>

#include "ecs/hierarchy.hpp"
#include "ecs/paused.hpp"
#include "math/portable.hpp"
#include "render/camera_motion.hpp"
#include "scene/camera_target.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/drawing/hidden.hpp"
#include "scene/components/drawing/label.hpp"
#include "scene/components/drawing/parallax_layer.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/drawing/background.hpp"
#include "scene/drawing/lab_drawing.hpp"
#include "scene/drawing/soft_drawing.hpp"
#include "scene/loaded_scene.hpp"
#include "scene/scene_stack.hpp"
#include "scene/world_transform.hpp"

namespace plumb {
namespace {

constexpr float kLinesOfThinStrokes = 1080.0f;  // px: lines are n px wide on screens n times this high

Rect sourceOf(const Sprite& sprite) {
    if (!sprite.source.empty()) return sprite.source;
    const auto width = static_cast<float>(sprite.width);
    const auto height = static_cast<float>(sprite.height);
    return {static_cast<float>(sprite.frameX) * width, static_cast<float>(sprite.frameY) * height, width,
            height};
}

/// Returns the quad of a sprite at a pose. A negative scale mirrors it.
[[gnu::always_inline]] inline SpriteQuad quadOf(const Sprite& sprite, const Pose& pose,
                                                const TextureRegion& picture) {
    const Vec2 size{static_cast<float>(sprite.width) * pose.scale.x,
                    static_cast<float>(sprite.height) * pose.scale.y};
    SpriteQuad quad;
    quad.center = quadCenter(pose.position, sprite.pivot, size, pose.rotation);
    quad.half = {std::fabs(size.x) * 0.5f, std::fabs(size.y) * 0.5f};
    quad.rotation = pose.rotation;
    quad.texture = picture.texture;
    quad.source =
        picture.texture == TextureHandle{} ? Rect{0.0f, 0.0f, 1.0f, 1.0f} : picture.part(sourceOf(sprite));
    quad.tint = sprite.tint;
    quad.layer = sprite.layer;
    quad.flipX = sprite.flipX != (size.x < 0.0f);
    quad.flipY = sprite.flipY != (size.y < 0.0f);
    return quad;
}

/// Returns the factor by which the game image is enlarged if it is an integer, otherwise 0.
int wholeFactor(Vec2 picture, const Viewport& viewport) {
    const auto factor = static_cast<int>(static_cast<float>(viewport.width) / std::max(picture.x, 1.0f));
    const auto enlarged = [factor](float side) { return static_cast<int>(side) * factor; };
    return enlarged(picture.x) == viewport.width && enlarged(picture.y) == viewport.height ? factor : 0;
}

/// Returns the divisor of `factor` by which the resolution is reduced for software rendering. At least three
/// target px remain per px of the game image, which is fine enough for slow motion.
int shrinkOf(int factor) {
    int shrink = 1;
    for (int i = 2; factor / i >= 3; ++i) {
        if (factor % i == 0) shrink = i;
    }
    return shrink;
}

/// True if texels of backdrops are whole px of the game
/// image, so that drawing at low resolution looks the same.
bool isWholeZoom(float zoom) { return zoom >= 1.0f && zoom == std::floor(zoom); }

Vec2 topLeftOf(const View& view) { return view.center - view.size * (0.5f / view.zoom); }

/// True if the pose neither rotates nor scales: one texel is one px.
bool isPlain(const Pose& pose) {
    return pose.rotation == 0.0f && std::fabs(pose.scale.x) == 1.0f && std::fabs(pose.scale.y) == 1.0f;
}

/// Returns the quad's center with its top-left corner moved to the nearest target px; unchanged for grid 0.
Vec2 centerOnGrid(const SpriteQuad& quad, const View& view, float grid) {
    if (!(grid > 0.0f) || quad.rotation != 0.0f) return quad.center;
    const float pxPerWorld = grid * view.zoom;
    const Vec2 origin = topLeftOf(view) + quad.half;
    const Vec2 place = (quad.center - origin) * pxPerWorld;
    return origin + Vec2{std::floor(place.x + 0.5f), std::floor(place.y + 0.5f)} / pxPerWorld;
}

/// Returns the parallax displacement of a layer (px).
Vec2 parallaxOf(const SceneLayer& layer, const SceneView& how) {
    if (!how.parallax) return {};
    const Vec2 moved = topLeftOf(how.view) - how.parallaxOrigin;
    return {moved.x * (1.0f - layer.parallax.x), moved.y * (1.0f - layer.parallax.y)};
}

bool isAt(const World& world, EntityId entity, int place) {
    return place == kAllScenes || placeOf(world, entity) == static_cast<std::size_t>(place);
}

/// Quick test if a sprite can be in the view, before its quad is computed.
struct Sight {
    AABB visible;          // px, world
    bool isExact = false;  // no layer is displaced by parallax, so positions can be compared with `visible`

    [[nodiscard]] bool mayShow(const Sprite& sprite, const Pose& pose) const {
        if (!isExact) return true;
        // Maximum distance of a corner from the origin, for any rotation.
        const float wide =
            (1.0f + std::fabs(sprite.pivot.x)) * std::fabs(static_cast<float>(sprite.width) * pose.scale.x);
        const float high =
            (1.0f + std::fabs(sprite.pivot.y)) * std::fabs(static_cast<float>(sprite.height) * pose.scale.y);
        const float reach = wide + high;
        // NaN gives true, so that such sprites are not culled here.
        return !(pose.position.x + reach < visible.min.x || pose.position.x - reach > visible.max.x ||
                 pose.position.y + reach < visible.min.y || pose.position.y - reach > visible.max.y);
    }
};

}  // namespace

bool isSeen(const World& world, EntityId entity, const SceneView& how) {
    return isAt(world, entity, how.place) &&
           (how.hidden.empty() || !std::binary_search(how.hidden.begin(), how.hidden.end(), entity));
}

View cameraView(const World& world, Vec2 picture, float alpha, int place) {
    View view;
    view.size = picture;
    view.center = picture * 0.5f;
    for (auto [entity, camera] : world.query<const Camera>(without<Hidden>, withPaused)) {
        if (!camera.enabled || !isAt(world, entity, place)) continue;
        const float between = world.has<Paused>(entity) ? 1.0f : alpha;
        view.center = worldPose(world, entity, between).position;
        view.zoom = lerp(camera.previousZoom, camera.zoom, between);
        if (!(view.zoom > 0.0f)) view.zoom = 1.0f;
        if (!camera.settled && world.alive(camera.follow)) {
            // No tick has moved the camera to its target yet: use the target.
            const Vec2 target = cameraTarget(world, camera, view.center);
            view.center = keptInLimits(target, picture / view.zoom, camera.limits);
        }
        const float time = camera.shakeTime + between * static_cast<float>(kSecondsPerTick);
        view.center += shakeOffset(camera.shakeStrength, camera.shakeSeconds, time);
        break;
    }
    return view;
}

SceneRenderer::SceneRenderer(RenderDevice& device, AssetStore& assets, TextureFilter filter)
    : assets_{assets},
      renderer_{device},
      textures_{device, assets, filter},
      tiles_{device, assets, textures_},
      labels_{device, assets},
      backdropTarget_{device},
      canvas_{device} {}

void SceneRenderer::draw(const World& world, Vec2 picture, float alpha, const Viewport& viewport,
                         LabelText labelText) {
    RenderDevice& device = renderer_.device();
    const int factor = device.drawsInSoftware() ? wholeFactor(picture, viewport) : 1;
    const int shrink = shrinkOf(factor);
    const Viewport canvas =
        shrink > 1 ? canvas_.whole(viewport.width / shrink, viewport.height / shrink) : viewport;
    if (shrink > 1) {
        device.setViewport(canvas);
        device.clear({0, 0, 0, 255});
    }
    const auto* loaded = world.findResource<LoadedScenes>();
    const int scenes = loaded == nullptr ? 0 : static_cast<int>(loaded->scenes.size());
    // Scenes that an overlay had paused are drawn without interpolation until the next tick.
    const bool resumed = loaded != nullptr && loaded->resumedAt == world.tick && world.tick > 0;
    SceneView how;
    how.alpha = resumed ? 1.0f : alpha;
    how.labelText = labelText;
    for (int place = 0; place < std::max(scenes, 1); ++place) {
        how.place = scenes > 1 ? place : kAllScenes;
        drawInto(world, picture, how, canvas);
        if (place == 0) sceneView_ = how;
    }
    if (shrink > 1) device.show(canvas.target, viewport);
}

void SceneRenderer::drawInto(const World& world, Vec2 picture, SceneView& how, const Viewport& viewport) {
    const float pixelScale = picture.x > 0.0f ? static_cast<float>(viewport.width) / picture.x : 1.0f;
    how.view = snappedToPixels(cameraView(world, picture, how.alpha, how.place), pixelScale);
    // The scenes below an overlay are visible, so its backdrops cannot be drawn separately.
    const bool farIsSmall = how.place <= 0 && renderer_.device().drawsInSoftware() &&
                            wholeFactor(picture, viewport) > 1 && isWholeZoom(how.view.zoom);
    how.grid = farIsSmall ? 1.0f : pixelScale;
    labels_.setPixelScale(pixelScale);
    list_.begin(how.view);
    collect(world, how, list_);
    if (farIsSmall) {
        const Viewport& far = backdropTarget_.whole(static_cast<int>(picture.x), static_cast<int>(picture.y));
        renderer_.draw(list_, viewport, {far, lowestFrontLayer_});
    } else {
        renderer_.draw(list_, viewport);
    }
}

void SceneRenderer::drawPhysics(const World& world, const PhysicsShown& shown, const SceneView& how,
                                const Viewport& viewport) {
    if (shown.any() == 0) return;
    const float lines = static_cast<float>(viewport.height);
    const float enlarged = std::max(1.0f, std::floor(lines / kLinesOfThinStrokes));
    const float pixel = enlarged * how.view.size.x / static_cast<float>(viewport.width);
    const float behind = anyPaused_ ? 0.0f : (1.0f - how.alpha) * static_cast<float>(kSecondsPerTick);
    list_.begin(how.view);
    physics_.draw(world, shown, behind, pixel, list_);
    renderer_.draw(list_, viewport);
    const Vec2 screen{static_cast<float>(viewport.width), lines};
    list_.begin({screen * 0.5f, screen});
    drawPhysicsPanel(world, shown, labels_, list_);
    renderer_.draw(list_, viewport);
}

void SceneRenderer::drawOver(Vec2 size, const Viewport& viewport,
                             const std::function<void(LabelDrawing&, DrawList&)>& add) {
    labels_.setPixelScale(static_cast<float>(viewport.height) / size.y);
    list_.begin({size * 0.5f, size});
    add(labels_, list_);
    renderer_.draw(list_, viewport);
}

void SceneRenderer::collect(const World& world, const SceneView& how, DrawList& list) {
    textures_.refresh();
    poses_.clear();
    if (how.place <= 0) tiles_.beginFrame(static_cast<double>(world.tick) * kSecondsPerTick + how.ahead);
    anyPaused_ = world.count<Paused>() > 0;
    readLayers(world, how);
    collectBackground(world, how, list);
    lowestFrontLayer_ = kHighestLayer;
    collectBackdrops(world, how, list);
    const std::size_t backdrops = list.items().size();
    collectTiles(world, how, list);
    collectSprites(world, how, list);
    drawSoftBodies(world, how, list);
    collectParticles(world, how, list);
    collectLabels(world, how, list);
    drawLab(world, how, labels_, list);
    for (const DrawItem& item : list.items().subspan(backdrops)) {
        lowestFrontLayer_ = std::min(lowestFrontLayer_, layerOfKey(item.key));
    }
}

void SceneRenderer::collectBackground(const World& world, const SceneView& how, DrawList& list) {
    const auto* loaded = world.findResource<LoadedScenes>();
    const auto place = static_cast<std::size_t>(std::max(how.place, 0));
    Color background{0, 0, 0, 0};
    if (loaded == nullptr || loaded->scenes.empty()) {
        if (const auto* own = world.findResource<Background>()) background = own->color;
    } else if (place < loaded->scenes.size()) {
        background = loaded->scenes[place].background;
    }
    if (background.a > 0) list.filledRect(visibleBox(how.view), background, kLowestLayer);
}

void SceneRenderer::readLayers(const World& world, const SceneView& how) {
    layers_.clear();
    const auto* loaded = world.findResource<LoadedScenes>();
    if (loaded == nullptr) return;
    for (std::size_t i = 0; i < loaded->scenes.size(); ++i) {
        const std::vector<SceneLayer>& layers = loaded->scenes[i].layers;
        const bool wanted = how.place == kAllScenes || static_cast<std::size_t>(how.place) == i;
        if (wanted) layers_.insert(layers_.end(), layers.begin(), layers.end());
    }
}

float SceneRenderer::alphaOf(const World& world, EntityId entity, const SceneView& how) const {
    return anyPaused_ && world.has<Paused>(entity) ? 1.0f : how.alpha;
}

const SceneLayer* SceneRenderer::layerOf(int order) const {
    for (const SceneLayer& layer : layers_) {
        if (layer.order == order) return &layer;
    }
    return nullptr;
}

template <class... T, class Draw>
void SceneRenderer::forSeen(const Query<const T...>& query, const World& world, const SceneView& how,
                            const Draw& draw) const {
    // Entity ids are looked up only if they are needed.
    if (how.place == kAllScenes && how.hidden.empty() && !anyPaused_)
        return query.each([&](const T&... parts) { draw(how.alpha, parts...); });
    query.each([&](Entity entity, const T&... parts) {
        if (isSeen(world, entity, how)) draw(alphaOf(world, entity, how), parts...);
    });
}

void SceneRenderer::add(const SpriteQuad& quad, float y, const SceneView& how, DrawList& list) const {
    const SceneLayer* look = layerOf(quad.layer);
    if (look == nullptr) return list.sprite(quad);
    if (!look->visible) return;
    SpriteQuad drawn = quad;
    drawn.tint = quad.tint * look->tint;
    drawn.center += parallaxOf(*look, how);
    if (look->ySort) drawn.sortY = y;
    list.sprite(drawn);
}

void SceneRenderer::collectSprites(const World& world, const SceneView& how, DrawList& list) {
    const Sight sight{visibleBox(how.view), !how.parallax || layers_.empty()};
    TextureId lastTexture;
    TextureRegion picture = textures_.regionOf(lastTexture);
    const auto collect = [&](const Sprite& sprite, const Pose& pose) {
        // Textures of invisible sprites are uploaded too, so that there is no delay when they become visible.
        if (sprite.texture != lastTexture) picture = textures_.regionOf(lastTexture = sprite.texture);
        if (sight.mayShow(sprite, pose)) add(quadOf(sprite, pose, picture), pose.position.y, how, list);
    };
    // Most sprites have no parent and need no world pose.
    forSeen(world.query<const Sprite, const Transform>(without<Hidden, ParallaxLayer, Parent>, withPaused),
            world, how, [&](float alpha, const Sprite& sprite, const Transform& transform) {
                collect(sprite, interpolated(transform, alpha));
            });
    forSeen(
        world.query<const Sprite, const Transform, const Parent>(without<Hidden, ParallaxLayer>, withPaused),
        world, how, [&](float alpha, const Sprite& sprite, const Transform& transform, const Parent& parent) {
            collect(sprite, poses_.of(world, interpolated(transform, alpha), parent.entity, alpha));
        });
    forSeen(world.query<const Sprite, const Parent>(without<Hidden, ParallaxLayer, Transform>, withPaused),
            world, how, [&](float alpha, const Sprite& sprite, const Parent& parent) {
                collect(sprite, poses_.of(world, Pose{}, parent.entity, alpha));
            });
}

void SceneRenderer::collectBackdrops(const World& world, const SceneView& how, DrawList& list) {
    const AABB seen = visibleBox(how.view);
    const Vec2 moved = topLeftOf(how.view) - how.parallaxOrigin;
    for (auto [entity, sprite, backdrop] :
         world.query<const Sprite, const ParallaxLayer>(without<Hidden>, withPaused)) {
        if (!isSeen(world, entity, how)) continue;
        const Pose pose = poses_.of(world, entity, alphaOf(world, entity, how));
        SpriteQuad quad = quadOf(sprite, pose, textures_.regionOf(sprite.texture));
        if (!isPlain(pose)) lowestFrontLayer_ = std::min(lowestFrontLayer_, quad.layer);
        if (how.parallax)
            quad.center += {moved.x * (1.0f - backdrop.factor.x), moved.y * (1.0f - backdrop.factor.y)};
        const Vec2 size = quad.half * 2.0f;
        if (!(size.x >= 1.0f) || !(size.y >= 1.0f)) continue;
        quad.center = centerOnGrid(quad, how.view, how.grid);
        // Start at the first visible copy; without repetition there is only one.
        const Vec2 first = quad.center;
        const auto start = [](bool repeats, float center, float step, float from) {
            return repeats ? center + std::ceil((from - center) / step - 0.5f) * step : center;
        };
        const float left = start(backdrop.repeatX, first.x, size.x, seen.min.x);
        const float top = start(backdrop.repeatY, first.y, size.y, seen.min.y);
        const float right = backdrop.repeatX ? seen.max.x + quad.half.x : left;
        const float bottom = backdrop.repeatY ? seen.max.y + quad.half.y : top;
        for (float y = top; y <= bottom; y += size.y) {
            for (float x = left; x <= right; x += size.x) {
                quad.center = {x, y};
                add(quad, kNoSortY, how, list);
            }
        }
    }
}

void SceneRenderer::collectTiles(const World& world, const SceneView& how, DrawList& list) {
    const Vec2 moved = topLeftOf(how.view) - how.parallaxOrigin;
    for (auto [entity, layer] : world.query<const TileLayer>(without<Hidden>, withPaused)) {
        if (!isSeen(world, entity, how)) continue;
        Pose pose = poses_.of(world, entity, alphaOf(world, entity, how));
        if (const auto* backdrop = world.find<ParallaxLayer>(entity); backdrop != nullptr && how.parallax) {
            pose.position += {moved.x * (1.0f - backdrop->factor.x), moved.y * (1.0f - backdrop->factor.y)};
        }
        TileLayer drawn = layer;
        if (const SceneLayer* look = layerOf(layer.layer)) {
            if (!look->visible) continue;
            drawn.tint = layer.tint * look->tint;
            pose.position += parallaxOf(*look, how);
        }
        tiles_.draw(world, entity, drawn, pose, list);
    }
}

void SceneRenderer::collectParticles(const World& world, const SceneView& how, DrawList& list) {
    const Particles* particles = how.particles != nullptr ? how.particles : world.findResource<Particles>();
    if (particles == nullptr) return;
    particles_.begin();
    const Vec2 gravity = particleGravity(world);
    for (const ParticleStream& stream : particles->streams) {
        const auto* emitter = world.find<ParticleEmitter>(stream.emitter);
        if (emitter == nullptr || world.has<Hidden>(stream.emitter)) continue;
        if (!isSeen(world, stream.emitter, how)) continue;
        const float alpha = alphaOf(world, stream.emitter, how);
        ParticleLook look;
        look.picture = textures_.regionOf(emitter->texture);
        look.pose = poses_.of(world, stream.emitter, alpha);
        look.back = how.particles != nullptr ? how.particleBack
                                             : (1.0f - alpha) * static_cast<float>(kSecondsPerTick);
        look.gravity = gravity;
        if (const SceneLayer* layer = layerOf(emitter->layer)) {
            if (!layer->visible) continue;
            look.tint = layer->tint;
            look.offset = parallaxOf(*layer, how);
            if (layer->ySort) look.sortY = look.pose.position.y;
        }
        particles_.draw(*particles, stream, *emitter, look, list);
    }
}

void SceneRenderer::collectLabels(const World& world, const SceneView& how, DrawList& list) {
    const Vec2 corner = how.parallax ? topLeftOf(how.view) : Vec2{};
    for (auto [entity, label] : world.query<const Label>(without<Hidden>, withPaused)) {
        if (!isSeen(world, entity, how)) continue;
        Pose pose = poses_.of(world, entity, alphaOf(world, entity, how));
        if (label.screen) pose.position += corner;
        if (const SceneLayer* look = layerOf(label.layer); look != nullptr && !look->visible) continue;
        labels_.draw(world, label, pose, how.labelText, list);
    }
}

}  // namespace plumb
