#pragma once

#include <memory>

#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

std::unique_ptr<Panel> makeScenePanel();
std::unique_ptr<Panel> makeViewportPanel();
std::unique_ptr<Panel> makeInspectorPanel();
std::unique_ptr<Panel> makeConsolePanel();
std::unique_ptr<Panel> makeTilesPanel();
std::unique_ptr<Panel> makeTilesetPanel();
std::unique_ptr<Panel> makeHistoryPanel();
std::unique_ptr<Panel> makeAssetsPanel();
std::unique_ptr<Panel> makeProfilerPanel();
std::unique_ptr<Panel> makeEffectsPanel();
std::unique_ptr<Panel> makeCostPanel();
std::unique_ptr<Panel> makeInputPanel();
std::unique_ptr<Panel> makeAnimationPanel();
std::unique_ptr<Panel> makeScriptsPanel();

}  // namespace plumb::editor::ui
