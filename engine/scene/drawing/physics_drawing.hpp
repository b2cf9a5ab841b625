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
    /// @param pixel   size of a screen px in px of the game image, for lines of constant screen width
    void draw(const World& world, const PhysicsShown& shown, float behind, float pixel, DrawList& list);

private:
    void markSelected(const PhysicsState& state, std::span<const EntityId> selected);

    std::vector<Vec2> corners_;
    std::vector<SpriteInstance> dots_;          ///< shapes too small to show an outline
    std::vector<std::uint64_t> selectedUsers_;  ///< userOf() of the selected entities, sorted
    std::vector<std::uint8_t> selectedBodies_;  ///< indexed by body: 1 if selected
    std::vector<std::uint8_t> selectedFields_;  ///< indexed by field: 1 if selected
    std::vector<std::uint8_t> selectedSoft_;    ///< indexed by soft body: 1 if selected
};

/// Draws the legend of the shown layers, and the tables of times and counts if these layers are shown.
/// @param list  draw list in screen px: its view has the size of the target
void drawPhysicsPanel(const World& world, const PhysicsShown& shown, LabelDrawing& labels, DrawList& list);

/// For a world that is not simulated: creates its bodies from its components, so that they can be drawn.
void previewPhysics(World& world);

}  // namespace plumb
