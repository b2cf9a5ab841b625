#pragma once

#include "editor/model/view/overlay.hpp"
#include "editor/model/view/particle_preview.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Advances the particle preview by the frame time; clears
/// it while a game runs, as the game has its own particles.
void advancePreview(const Ui& ui, ParticlePreview& preview);

/// Draws the area and the directions of each previewed emitter.
void drawEmitterShapes(const World& world, const ParticlePreview& preview, Overlay& overlay);

/// Draws the bar at the lower edge of the viewport: particle count, Restart and Burst.
/// @param from, size  rectangle of the viewport, px on screen
void drawParticleBar(Ui& ui, ParticlePreview& preview, ImVec2 from, ImVec2 size);

}  // namespace plumb::editor::ui
