#pragma once

#include "editor/model/tools/tool.hpp"
#include "scene/world_transform.hpp"

namespace plumb::editor {

/// What one can take hold of at the thing in hand: an axis, or the square between the two.
enum class Handle : unsigned char { None, X, Y, Both };

/// Two arms from an origin, x to the right and y down, of the same size on screen at any zoom.
struct AxisHandles {
    Vec2 origin;            ///< px, world
    float rotation = 0.0f;  ///< rad: of the axes
    float pixel = 1.0f;     ///< px of the world for one px on screen

    static constexpr float kArm = 58.0f;        ///< px on screen
    static constexpr float kSquareFrom = 9.0f;  ///< px on screen, from the origin on both axes
    static constexpr float kSquareTo = 23.0f;   ///< px on screen
    static constexpr float kTolerance = 4.5f;   ///< px on screen, to both sides of an arm
    static constexpr float kOverhang = 8.0f;    ///< px on screen, past the end of an arm

    [[nodiscard]] Handle at(Vec2 point) const;
    /// The middle of a handle (px, world): where a hand would take it.
    [[nodiscard]] Vec2 middleOf(Handle handle) const;
    /// @param boxes  ends of the arms: boxes (scale) or arrows (move)
    void draw(Overlay& overlay, Handle hot, bool boxes) const;

private:
    [[nodiscard]] Vec2 point(float x, float y) const;  // px on screen along the axes, as a place in the world
};

namespace handle_colors {
inline constexpr Color kX{240, 98, 98, 255};
inline constexpr Color kY{126, 211, 98, 255};
inline constexpr Color kBoth{77, 163, 255, 255};
inline constexpr Color kHot{255, 221, 87, 255};
inline constexpr Color kShade{0, 0, 0, 110};
}  // namespace handle_colors

}  // namespace plumb::editor
