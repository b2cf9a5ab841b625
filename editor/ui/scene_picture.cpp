#include "editor/ui/scene_picture.hpp"

#include "gameplay/game_progress.hpp"

namespace plumb::editor::ui {
namespace {

constexpr Color kBackground{23, 24, 28, 255};

}  // namespace

std::uintptr_t SceneTexture::draw(const World& world, AssetStore* assets, const View& view, PixelSize size,
                                  float alpha, bool asGame, const PhysicsShown& physics) {
    if (size != size_) {
        device_.destroyTarget(target_);
        target_ = device_.createTarget(size.width, size.height);
        size_ = size;
    }
    if (assets != playAssets_) {
        playRenderer_ =
            assets == nullptr ? nullptr : std::make_unique<SceneRenderer>(device_, *assets, filter_);
        playAssets_ = assets;
    }
    SceneRenderer& renderer = playRenderer_ ? *playRenderer_ : renderer_;
    const Viewport viewport{target_, 0, 0, size.width, size.height};
    SceneView how;
    how.view = snappedToPixels(view);
    how.alpha = alpha;
    how.parallax = asGame;
    how.labelText = &fillPlaceholders;
    how.ahead = preview.ahead;
    how.hidden = preview.hidden;
    how.particles = preview.particles;
    how.particleBack = preview.particleBack;
    list_.begin(how.view);
    renderer.collect(world, how, list_);
    device_.setViewport(viewport);
    device_.clear(kBackground);
    renderer.renderer().resetCounts();
    renderer.renderer().draw(list_, viewport);
    renderer.drawPhysics(world, physics, how, viewport);
    counts = renderer.renderer().counts();
    return device_.nativeTexture(device_.targetTexture(target_));
}

TexturePart SceneTexture::part(TextureId id, const Rect& source) {
    const TextureRegion& region = renderer_.textures().regionOf(id);
    const Rect area = source.empty() ? region.whole() : region.part(source);
    const PixelSize size = device_.textureSize(region.texture);
    const Vec2 whole{static_cast<float>(size.width), static_cast<float>(size.height)};
    return {device_.nativeTexture(region.texture),
            {area.x / whole.x, area.y / whole.y},
            {(area.x + area.width) / whole.x, (area.y + area.height) / whole.y}};
}

}  // namespace plumb::editor::ui
