#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ecs/world.hpp"
#include "render/draw_list.hpp"
#include "scene/drawing/label_drawing.hpp"
#include "scene/drawing/physics_view.hpp"

namespace plumb {

struct PhysicsState;

/// What the colours stand for, in the order of the legend.
std::span<const PhysicsColor> physicsColors();

/// Draws the physics of a world over everything else, as its last tick left it. Changes nothing; keeps its
/// memory, so a steady frame allocates nothing.
class PhysicsDrawing {
public:
    /// @param behind  s: how long before the end of the last tick
    /// @param pixel   px of the list's picture that a px of the screen is: lines are equally thin everywhere
    void draw(const World& world, const PhysicsShown& shown, float behind, float pixel, DrawList& list);

private:
    void choose(const PhysicsState& state, std::span<const EntityId> selected);

    std::vector<Vec2> corners_;
    std::vector<SpriteInstance> dots_;        ///< of what is too small to have an outline
    std::vector<std::uint64_t> users_;        ///< of the selected ones, rising
    std::vector<std::uint8_t> chosenBodies_;  ///< by body
    std::vector<std::uint8_t> chosenFields_;  ///< by field
    std::vector<std::uint8_t> chosenSoft_;    ///< by soft body
};

/// Says what the colours of those layers stand for, and the times and counts that are among them.
/// @param list  looks at the screen: its picture is as large as what it is drawn to
void drawPhysicsPanel(const World& world, const PhysicsShown& shown, LabelDrawing& labels, DrawList& list);

/// Gives a world that is not stepped the bodies of its components, so that they can be drawn.
void previewPhysics(World& world);

}  // namespace plumb
