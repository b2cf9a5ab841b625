#pragma once

#include "math/rect.hpp"
#include "render/view.hpp"

namespace plumb::editor {

/// How the scene is looked at while editing: not an edit, never undone.
class ViewCamera {
public:
    static constexpr float kMinZoom = 0.02f;
    static constexpr float kMaxZoom = 64.0f;

    [[nodiscard]] const View& view() const { return view_; }
    [[nodiscard]] float zoom() const { return view_.zoom; }
    /// @param size  px of the picture on screen
    void resize(Vec2 size) { view_.size = max(size, {1.0f, 1.0f}); }
    void centerOn(Vec2 world) { view_.center = world; }
    /// @param motion  px on screen; the world follows the hand
    void pan(Vec2 motion) { view_.center -= motion / view_.zoom; }
    /// Zooms by steps of the wheel so that what is under the cursor stays there.
    void zoomAt(Vec2 screen, float steps);
    void setZoom(float zoom);
    /// Looks exactly so. @param zoom  px of the screen per px of the world
    void show(Vec2 center, float zoom);
    /// The largest zoom at which all of a picture is seen: a whole number, so that its pixels are equally
    /// large, or less than one.
    /// @param picture  px, world
    /// @param margin   px of the screen around it
    [[nodiscard]] float zoomFor(Vec2 picture, float margin = 0.0f) const;
    /// Shows a box with a margin around it.
    void frame(const AABB& box);

    [[nodiscard]] Vec2 toWorldPoint(Vec2 screen) const { return toWorld(view_, screen); }
    [[nodiscard]] Vec2 toScreenPoint(Vec2 world) const { return toScreen(view_, world); }

private:
    View view_{{320.0f, 180.0f}, {640.0f, 360.0f}, 1.0f, 0.0f};
};

}  // namespace plumb::editor
