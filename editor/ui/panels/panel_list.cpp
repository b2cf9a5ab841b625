#include <array>

#include "editor/ui/panels/panels.hpp"

namespace plumb::editor::ui {

std::span<const PanelRow> panelTable() {
    static constexpr std::array kPanels{
        PanelRow{"Scene", Dock::Left, &makeScenePanel},
        PanelRow{"Viewport", Dock::Center, &makeViewportPanel},
        PanelRow{"Inspector", Dock::Right, &makeInspectorPanel},
        PanelRow{"Tiles", Dock::Bottom, &makeTilesPanel},
        PanelRow{"Console", Dock::Bottom, &makeConsolePanel},
        PanelRow{"History", Dock::Bottom, &makeHistoryPanel},
        PanelRow{"Tileset", Dock::Bottom, &makeTilesetPanel},
        PanelRow{"Assets", Dock::Bottom, &makeAssetsPanel},
        PanelRow{"Animation", Dock::Bottom, &makeAnimationPanel},
        PanelRow{"Profiler", Dock::Bottom, &makeProfilerPanel},
        PanelRow{"Input", Dock::Bottom, &makeInputPanel},
    };
    return kPanels;
}

}  // namespace plumb::editor::ui
