#pragma once

#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "platform/window.hpp"
#include "render/render_device.hpp"

namespace plumb {

/// The visible part of the world. The only place that converts between world and screen.
struct View {
    Vec2 center;            ///< px, world
    Vec2 size{1.0f, 1.0f};  ///< px: the picture before it is scaled to the window
    float zoom = 1.0f;      ///< picture px per world px
    float rotation = 0.0f;  ///< rad, of the camera: the world turns the other way

    friend bool operator==(const View&, const View&) = default;
};

/// World px to picture px, from its top left corner; and the inverse.
Vec2 toScreen(const View& view, Vec2 world);
Vec2 toWorld(const View& view, Vec2 screen);

/// The bounding box of the visible part of the world.
AABB visibleBox(const View& view);

/// The view, moved so that world px align with window px: pixel art and text stay sharp at whole zooms.
/// @param pixelScale window px per px of the picture; 1 moves in steps of a picture px
View snappedToPixels(const View& view, float pixelScale = 1.0f);

ViewTransform transformOf(const View& view);
/// The transform for an object drawn at `offset` (px, world), e.g. a parallax layer.
ViewTransform movedBy(const ViewTransform& transform, Vec2 offset);

/// How a picture of fixed size is scaled to a window of any size.
enum class WindowScale : unsigned char {
    Fit,      ///< as large as fits, bars on two sides
    Integer,  ///< the largest whole factor that fits: every px the same size
    Stretch,  ///< fills the window, may distort
    Fill,     ///< fills the window, may cut off two sides
};

/// The area of the window for a picture of `picture` px; with Fill it may extend beyond the window.
Viewport viewportFor(WindowScale scale, Vec2 picture, PixelSize window);
/// Converts a position in the window (e.g. of the mouse) to one in the picture.
Vec2 pictureFromWindow(const Viewport& viewport, Vec2 picture, Vec2 place);

}  // namespace plumb
