#include <array>
#include <vector>

#include "editor/ui/panels/panels.hpp"

namespace plumb::editor::ui {

std::span<const PanelRow> panelTable() {
    static constexpr std::array kPanels{
        PanelRow{"Scene", Dock::Left, &makeScenePanel},
        PanelRow{"Viewport", Dock::Center, &makeViewportPanel},
        PanelRow{"Inspector", Dock::Right, &makeInspectorPanel},
        PanelRow{"Tiles", Dock::Bottom, &makeTilesPanel, true},
        PanelRow{"Console", Dock::Bottom, &makeConsolePanel},
        PanelRow{"History", Dock::Bottom, &makeHistoryPanel},
        PanelRow{"Tileset", Dock::Bottom, &makeTilesetPanel, true},
        PanelRow{"Assets", Dock::Bottom, &makeAssetsPanel, true},
        PanelRow{"Animation", Dock::Bottom, &makeAnimationPanel, true},
        PanelRow{"Profiler", Dock::Bottom, &makeProfilerPanel, true},
        PanelRow{"Effects", Dock::Bottom, &makeEffectsPanel, true},
        PanelRow{"Cost", Dock::Bottom, &makeCostPanel, true},
        PanelRow{"Input", Dock::Bottom, &makeInputPanel, true},
        PanelRow{"Scripts", Dock::Bottom, &makeScriptsPanel, true},
    };
    return kPanels;
}

std::span<const PanelHome> panelHomes() {
    static const std::vector<PanelHome> homes = [] {
        std::vector<PanelHome> all;
        for (const PanelRow& row : panelTable()) all.push_back({row.title, row.dock, row.tall});
        return all;
    }();
    return homes;
}

}  // namespace plumb::editor::ui
