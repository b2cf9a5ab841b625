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

/// Returns the rows of the legend of the physics view: colours and their meaning.
std::span<const PhysicsColor> physicsColors();

/// Draws the physics debug view of a world, in the state after its last tick. Does not change the world.
/// Keeps its memory, so drawing does not allocate in steady state.
class PhysicsDrawing {
public:
    /// @param behind  s from the drawn moment to the end of the last tick
    /// @param pixel   size of a screen px in px of the list's image, for lines of constant screen width
    void draw(const World& world, const PhysicsShown& shown, float behind, float pixel, DrawList& list);

private:
    void markSelected(const PhysicsState& state, std::span<const EntityId> selected);

    std::vector<Vec2> corners_;
    std::vector<SpriteInstance> dots_;          ///< shapes too small to show an outline
    std::vector<std::uint64_t> selectedUsers_;  ///< userOf() of the selected entities, sorted
    std::vector<std::uint8_t> selectedBodies_;  ///< by body index: 1 if selected
    std::vector<std::uint8_t> selectedFields_;  ///< by field index: 1 if selected
    std::vector<std::uint8_t> selectedSoft_;    ///< by soft body index: 1 if selected
};

/// Draws the legend of the shown layers, and the tables of times and counts if these layers are shown.
/// @param list  draw list in screen px: its view has the size of the target
void drawPhysicsPanel(const World& world, const PhysicsShown& shown, LabelDrawing& labels, DrawList& list);

/// Creates the bodies of a world that is not simulated from its components, so that they can be drawn.
void previewPhysics(World& world);

}  // namespace plumb
