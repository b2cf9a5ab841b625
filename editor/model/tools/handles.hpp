#pragma once

#include "editor/model/tools/tool.hpp"
#include "scene/world_transform.hpp"

namespace plumb::editor {

/// A handle that can be dragged: that of one axis, or the square for both.
enum class Handle : unsigned char { None, X, Y, Both };

/// Handles drawn as two arms from an origin, x to the right and y down. Their size on screen does not depend
/// on the zoom.
struct AxisHandles {
    Vec2 origin;            ///< px, world: common start of both arms
    float rotation = 0.0f;  ///< rad: rotation of the axes
    float pixel = 1.0f;     ///< size of a screen pixel in world px

    static constexpr float kArm = 58.0f;        ///< px on screen: length of an arm
    static constexpr float kSquareFrom = 9.0f;  ///< px on screen: near edges of the square, from the origin
    static constexpr float kSquareTo = 23.0f;   ///< px on screen: far edges of the square, from the origin
    static constexpr float kTolerance = 4.5f;   ///< px on screen: hit distance on both sides of an arm
    static constexpr float kOverhang = 8.0f;    ///< px on screen: hit distance past the end of an arm

    /// Returns the handle at a point (px, world).
    [[nodiscard]] Handle at(Vec2 point) const;
    /// Returns a point on the handle (px, world) where it can be grabbed.
    [[nodiscard]] Vec2 middleOf(Handle handle) const;
    /// @param hot    the highlighted handle
    /// @param boxes  draw the ends of the arms as boxes (scale) instead of arrows (move)
    void draw(Overlay& overlay, Handle hot, bool boxes) const;

private:
    [[nodiscard]] Vec2 point(float x, float y) const;  // converts px on screen along the axes to px, world
};

namespace handle_colors {
inline constexpr Color kX{240, 98, 98, 255};
inline constexpr Color kY{126, 211, 98, 255};
inline constexpr Color kBoth{77, 163, 255, 255};
inline constexpr Color kHot{255, 221, 87, 255};
inline constexpr Color kShade{0, 0, 0, 110};
}  // namespace handle_colors

}  // namespace plumb::editor
