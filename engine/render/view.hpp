#pragma once

#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "platform/window.hpp"
#include "render/render_device.hpp"

namespace plumb {

/// The visible part of the world. Screen px are px of the game's resolution, before scaling to the window.
struct View {
    Vec2 center;            ///< px, world
    Vec2 size{1.0f, 1.0f};  ///< the game's resolution, screen px
    float zoom = 1.0f;      ///< screen px per world px
    float rotation = 0.0f;  ///< camera rotation, rad; the world appears rotated in the opposite direction

    friend bool operator==(const View&, const View&) = default;
};

/// Converts world px to screen px, measured from the screen's top left corner, and back.
Vec2 toScreen(const View& view, Vec2 world);
Vec2 toWorld(const View& view, Vec2 screen);

/// Returns the bounding box of the visible part of the world, px.
AABB visibleBox(const View& view);

/// Moves a view so that world px align with window px: pixel art and text stay sharp at integer zooms.
/// @param pixelScale window px per screen px; 1 aligns to screen px
View snappedToPixels(const View& view, float pixelScale = 1.0f);

ViewTransform transformOf(const View& view);
/// Returns the transform for an object drawn at `offset` (px, world), e.g. a parallax layer.
ViewTransform movedBy(const ViewTransform& transform, Vec2 offset);

/// Modes in which the screen of fixed resolution is scaled to a window of any size.
enum class WindowScale : unsigned char {
    Fit,      ///< the largest size that fits, with bars on two sides
    Integer,  ///< the largest integer factor that fits: all px have the same size
    Stretch,  ///< fills the window, may distort
    Fill,     ///< fills the window, may crop two sides
};

/// Returns the area of the window for a screen of `picture` px; with Fill it may extend beyond the window.
Viewport viewportFor(WindowScale scale, Vec2 picture, PixelSize window);
/// Converts a position in the window, px, e.g. of the mouse, to screen px.
Vec2 screenFromWindow(const Viewport& viewport, Vec2 picture, Vec2 position);

}  // namespace plumb
