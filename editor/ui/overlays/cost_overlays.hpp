#pragma once

#include <array>
#include <string_view>

#include "editor/model/view/overlay.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor::ui {

/// One class of a legend. The colors go from calm to loud and from thin to thick, and can be distinguished by
/// people that see no red, green or blue. Source: M. Okabe, K. Ito, "Color Universal Design", 2008.
struct CostShade {
    float from;  ///< of what is shown: px of error, or times the weight
    std::string_view label;
    Color color;
    float thickness;  ///< px on screen, of a line; half of it more is the radius of a dot
};

inline constexpr std::array<CostShade, 4> kErrorShades{{
    {0.0f, "below half a pixel: cannot be seen", {86, 180, 233, 200}, 1.5f},
    {0.5f, "half to one pixel", {240, 228, 66, 230}, 2.5f},
    {1.0f, "one to two pixels", {255, 176, 32, 255}, 3.5f},
    {2.0f, "more than two pixels: plainly seen", {255, 110, 60, 255}, 5.0f},
}};
inline constexpr std::array<CostShade, 4> kForceShades{{
    {0.0f, "up to twice the lighter body's weight", {86, 180, 233, 220}, 3.0f},
    {2.0f, "up to 8 times", {240, 228, 66, 235}, 4.5f},
    {8.0f, "up to 32 times", {255, 176, 32, 255}, 6.0f},
    {32.0f, "more: a great load on a light body is hard to solve", {255, 110, 60, 255}, 8.0f},
}};

/// The outlines of bodies, by how far they are inside of others or off their joints.
void drawBodyErrors(const Workspace& workspace, const World& world, Overlay& overlay);
/// A dot where two shapes push each other, by how hard.
void drawContactForces(const Workspace& workspace, const World& world, Overlay& overlay);

}  // namespace plumb::editor::ui
