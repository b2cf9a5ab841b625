#pragma once

#include <array>
#include <string_view>

#include "editor/model/view/overlay.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor::ui {

/// A range of values that an overlay draws in one color. Higher ranges have stronger colors and thicker
/// lines. Distinguishable with color blindness; source: M. Okabe, K. Ito, "Color Universal Design", 2008.
struct CostShade {
    float from;              ///< lower limit: error in px, or force / weight of the lighter body
    std::string_view label;  ///< text in the legend
    Color color;
    float thickness;  ///< line thickness, px on screen; also the radius of a force dot
};

inline constexpr std::array<CostShade, 4> kErrorShades{{
    {0.0f, "below half a pixel: invisible", {86, 180, 233, 200}, 1.5f},
    {0.5f, "half to one pixel", {240, 228, 66, 230}, 2.5f},
    {1.0f, "one to two pixels", {255, 176, 32, 255}, 3.5f},
    {2.0f, "more than two pixels: clearly visible", {255, 110, 60, 255}, 5.0f},
}};
inline constexpr std::array<CostShade, 4> kForceShades{{
    {0.0f, "up to twice the lighter body's weight", {86, 180, 233, 220}, 3.0f},
    {2.0f, "2 to 8 times that weight", {240, 228, 66, 235}, 4.5f},
    {8.0f, "8 to 32 times that weight", {255, 176, 32, 255}, 6.0f},
    {32.0f, "over 32 times: a large load on a light body is hard to solve", {255, 110, 60, 255}, 8.0f},
}};

/// Draws the outlines of bodies, colored by their largest overlap or joint error.
void drawBodyErrors(const Workspace& workspace, const World& world, Overlay& overlay);
/// Draws a dot per contact point, colored by its force relative to the weight of the lighter body.
void drawContactForces(const Workspace& workspace, const World& world, Overlay& overlay);

}  // namespace plumb::editor::ui
