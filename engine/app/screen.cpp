#include "app/screen.hpp"

#include <utility>

#include "core/log.hpp"
#include "gameplay/game_progress.hpp"

namespace plumb {

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
    Result<std::unique_ptr<GlDevice>> device = GlDevice::create();
    if (!device) return device.error();
    logNote("Engine", "OpenGL 3.3 Core Profile");
    return std::unique_ptr<Screen>{new Screen{settings, std::move(*opened), std::move(*device)}};
}

Screen::Screen(ScreenSettings settings, std::unique_ptr<Window> window, std::unique_ptr<GlDevice> device)
    : settings_{std::move(settings)}, window_{std::move(window)}, device_{std::move(device)} {}

void Screen::draw(World& world, AssetStore& assets, float alpha, const PhysicsShown& physics) {
    if (drawnAssets_ != &assets) {
        renderer_ = std::make_unique<SceneRenderer>(*device_, assets);
        drawnAssets_ = &assets;
    }
    device_->setWindowSize(window_->drawableSize());
    const Viewport whole{TargetHandle{}, 0, 0, window_->drawableSize().width, window_->drawableSize().height};
    device_->setViewport(whole);
    device_->clear(Color{0, 0, 0, 255});
    renderer_->renderer().resetCounts();
    renderer_->draw(world, settings_.picture, alpha, viewport(), &fillPlaceholders);
    renderer_->drawPhysics(world, physics, renderer_->sceneView(), viewport());
    drawCalls_ = renderer_->renderer().counts().drawCalls;
}

Image Screen::picture() { return device_->readPixels(TargetHandle{}); }

Viewport Screen::viewport() const {
    return viewportFor(settings_.scaling, settings_.picture, window_->drawableSize());
}

}  // namespace plumb
