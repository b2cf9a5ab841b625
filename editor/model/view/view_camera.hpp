#pragma once

#include "math/rect.hpp"
#include "render/view.hpp"

namespace plumb::editor {

/// The camera of the scene view while editing. Its changes are not part of the undo history.
class ViewCamera {
public:
    static constexpr float kMinZoom = 0.02f;
    static constexpr float kMaxZoom = 64.0f;

    [[nodiscard]] const View& view() const { return view_; }
    [[nodiscard]] float zoom() const { return view_.zoom; }
    /// Sets the size of the viewport. @param size  px on screen
    void resize(Vec2 size) { view_.size = max(size, {1.0f, 1.0f}); }
    void centerOn(Vec2 world) { view_.center = world; }
    /// Moves the view so that the scene follows the mouse. @param motion  px on screen: displacement of the
    /// mouse
    void pan(Vec2 motion) { view_.center -= motion / view_.zoom; }
    /// Zooms about a point of the viewport. @param screen  px on screen @param steps  of the mouse wheel
    void zoomAt(Vec2 screen, float steps);
    /// Sets the zoom, within the limits; snaps to a near integer.
    void setZoom(float zoom);
    /// Sets center and zoom without snapping. @param zoom  px on screen per world px
    void show(Vec2 center, float zoom);
    /// Returns the largest zoom at which an image fits into the viewport: an integer, so that its pixels are
    /// equally large, or a value below 1.
    /// @param picture  px, world: size of the image
    /// @param margin   px on screen: free space around it
    [[nodiscard]] float zoomFor(Vec2 picture, float margin = 0.0f) const;
    /// Centers a box and zooms so that it fits with a margin.
    void frame(const AABB& box);

    [[nodiscard]] Vec2 toWorldPoint(Vec2 screen) const { return toWorld(view_, screen); }
    [[nodiscard]] Vec2 toScreenPoint(Vec2 world) const { return toScreen(view_, world); }

private:
    View view_{{320.0f, 180.0f}, {640.0f, 360.0f}, 1.0f, 0.0f};
};

}  // namespace plumb::editor
