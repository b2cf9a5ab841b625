#pragma once

#include "editor/model/view/overlay.hpp"
#include "editor/model/view/particle_preview.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Goes on with the preview; while a game plays, which has particles of its own, there is none.
void advancePreview(const Ui& ui, ParticlePreview& preview);

/// Where each previewed emitter sends from, and in which directions.
void drawEmitterShapes(const World& world, const ParticlePreview& preview, Overlay& overlay);

/// The bar at the lower edge of the scene: how many particles there are, begin anew, burst.
/// @param from, size  of the scene on the screen (px)
void drawParticleBar(Ui& ui, ParticlePreview& preview, ImVec2 from, ImVec2 size);

}  // namespace plumb::editor::ui
