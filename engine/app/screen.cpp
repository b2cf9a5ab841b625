#include "app/screen.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/log.hpp"
#include "gameplay/game_progress.hpp"
#include "platform/gl_profile.hpp"
#include "scene/effects.hpp"

namespace plumb {

namespace {

constexpr int kSmoothSamples = 4;  // antialiasing samples per px

}  // namespace

Result<std::unique_ptr<Screen>> Screen::open(const ScreenSettings& settings) {
    logNote("Engine", "Initializing SDL2...");
    WindowSettings window;
    window.title = settings.title;
    window.width = settings.windowWidth;
    window.height = settings.windowHeight;
    window.fullscreen = settings.fullscreen;
    Result<std::unique_ptr<Window>> opened = Window::open(window);
    if (!opened) return opened.error();
    logNote("Engine", "Created window: {}x{}", settings.windowWidth, settings.windowHeight);
    Result<std::unique_ptr<GlDevice>> device = openDevice(settings);
    if (!device) return device.error();
    logNote("Engine", "OpenGL 3.3 Core Profile");
    return std::unique_ptr<Screen>{new Screen{settings, std::move(*opened), std::move(*device)}};
}

Result<std::unique_ptr<GlDevice>> Screen::openDevice(const ScreenSettings& settings) {
    Result<std::unique_ptr<GlDevice>> device = GlDevice::create();
    if (device && settings.smooth) (*device)->enableMultisampling(kSmoothSamples);
    return device;
}

Screen::Screen(ScreenSettings settings, std::unique_ptr<Window> window, std::unique_ptr<GlDevice> device)
    : settings_{std::move(settings)},
      window_{std::move(window)},
      device_{std::move(device)},
      contextsRestored_{contextsRestored()} {}

void Screen::clear() {
    const PixelSize window = window_->drawableSize();
    device_->setViewport({TargetHandle{}, 0, 0, window.width, window.height});
    device_->clear(Color{0, 0, 0, 255});
}

void Screen::renew() {
    contextsRestored_ = contextsRestored();
    Result<std::unique_ptr<GlDevice>> device = openDevice(settings_);
    if (!device) return logError("Render", device.error());
    renderer_.reset();  // before the device with its textures
    drawnAssets_ = nullptr;
    device_ = std::move(*device);
}

/// Clears the window. Used while the effect "picture" does not run, so that no renderer is created.
void Screen::drawNothing() {
    clear();
    device_->resolveWindow();
    drawCalls_ = 0;
}

SceneRenderer& Screen::rendererFor(AssetStore& assets) {
    if (drawnAssets_ != &assets) {
        renderer_ = std::make_unique<SceneRenderer>(
            *device_, assets, settings_.smooth ? TextureFilter::Linear : TextureFilter::Nearest);
        drawnAssets_ = &assets;
    }
    return *renderer_;
}

void Screen::drawOver(AssetStore& assets, Vec2 size,
                      const std::function<void(LabelDrawing&, DrawList&)>& add) {
    const PixelSize window = window_->drawableSize();
    rendererFor(assets).drawOver(size, {TargetHandle{}, 0, 0, window.width, window.height}, add);
    device_->resolveWindow();
}

void Screen::draw(const World& world, AssetStore& assets, float alpha, const PhysicsShown& physics) {
    Effects* const effects = world.service<Effects>();
    if (isContextLost()) return;
    if (contextsRestored() != contextsRestored_) renew();
    const bool draws = effects == nullptr || effects->runs(world, "picture");
    device_->setWindowSize(window_->drawableSize());
    if (!draws && physics.any() == 0) return drawNothing();
    if (drawnAssets_ != &assets && effects != nullptr) effects->count("picture");
    static_cast<void>(rendererFor(assets));
    clear();
    renderer_->renderer().resetCounts();
    if (draws) renderer_->draw(world, settings_.picture, alpha, viewport(), &fillPlaceholders);
    renderer_->drawPhysics(world, physics, renderer_->sceneView(), viewport());
    device_->resolveWindow();
    drawCalls_ = renderer_->renderer().counts().drawCalls;
}

Image Screen::picture() { return device_->readPixels(TargetHandle{}); }

Viewport Screen::viewport() const {
    return viewportFor(settings_.scaling, settings_.picture, window_->drawableSize());
}

void Screen::placeMouse(InputFrame& frame) const {
    const PixelSize window = window_->size(), drawn = window_->drawableSize();
    if (window.width <= 0 || window.height <= 0 || frame.mouse() == Vec2{}) return;
    const Vec2 place{frame.mouse().x * static_cast<float>(drawn.width) / static_cast<float>(window.width),
                     frame.mouse().y * static_cast<float>(drawn.height) / static_cast<float>(window.height)};
    const Vec2 picture = screenFromWindow(viewport(), settings_.picture, place);
    frame.setMouse(picture);
}

}  // namespace plumb
