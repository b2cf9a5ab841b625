#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "app/screen_settings.hpp"
#include "assets/asset_store.hpp"
#include "core/result.hpp"
#include "input/input_frame.hpp"
#include "platform/window.hpp"
#include "render/gl/gl_device.hpp"
#include "scene/drawing/draw_scene.hpp"

namespace plumb {

/// The window of a game and its renderer.
class Screen {
public:
    /// Opens a window. @error there is no video driver, or no OpenGL 3.3
    static Result<std::unique_ptr<Screen>> open(const ScreenSettings& settings);

    /// Draws the world to the back buffer; swap() shows it.
    /// @param physics  physics debug layers to draw over the scene
    void draw(const World& world, AssetStore& assets, float alpha, const PhysicsShown& physics = {});
    /// Draws over the image of draw(), on the whole window.
    /// @param size  of the view, px
    /// @param add   fills the list
    void drawOver(AssetStore& assets, Vec2 size,
                  const std::function<void(LabelDrawing& labels, DrawList& list)>& add);
    void swap() { window_->swap(); }
    /// Makes everything on the graphics card anew, when it is drawn next: it was lost. draw() calls it itself
    /// after a browser has taken the context of OpenGL away.
    void renew();
    /// Reads the drawn image; call before swap().
    [[nodiscard]] Image picture();

    [[nodiscard]] Window& window() { return *window_; }
    [[nodiscard]] const ScreenSettings& settings() const { return settings_; }
    /// Returns the rectangle of the game image in the window (px).
    [[nodiscard]] Viewport viewport() const;
    /// Converts the mouse position from px of the window to px of the game image. (0, 0), the place before
    /// the first event of the mouse, stays.
    void placeMouse(InputFrame& frame) const;
    [[nodiscard]] std::size_t drawCalls() const {
        return drawCalls_;
    }  ///< number of draw calls of the last frame

private:
    Screen(ScreenSettings settings, std::unique_ptr<Window> window, std::unique_ptr<GlDevice> device);

    void clear();
    SceneRenderer& rendererFor(AssetStore& assets);
    void drawNothing();
    static Result<std::unique_ptr<GlDevice>> openDevice(const ScreenSettings& settings);

    ScreenSettings settings_;
    std::unique_ptr<Window> window_;
    std::unique_ptr<GlDevice> device_;
    const AssetStore* drawnAssets_ = nullptr;
    std::unique_ptr<SceneRenderer> renderer_;
    std::size_t drawCalls_ = 0;
    unsigned contextsRestored_ = 0;  ///< when device_ was made
};

}  // namespace plumb
