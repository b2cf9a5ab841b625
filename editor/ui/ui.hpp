#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "editor/model/view/log_book.hpp"
#include "editor/model/workspace.hpp"
#include "editor/ui/theme.hpp"
#include "editor/ui/widget_map.hpp"

namespace plumb::editor::ui {

class SceneTexture;

/// The objects and state shared by all panels of a window.
struct Ui {
    Workspace& workspace;
    WidgetMap& widgets;
    LogBook& log;
    Fonts fonts{};
    float scale = 1.0f;               ///< scale of the user interface
    SceneTexture* picture = nullptr;  ///< renderer of the scene; null: headless, the viewport stays empty
    float playAlpha = 1.0f;           ///< interpolation factor between the last two ticks of the running game
    Vec2 mouseInScene;                ///< px, world: position of the mouse
    bool mouseOverScene = false;
    bool panHeld = false;      ///< Space is held to pan the scene view
    bool viewReady = false;    ///< false: the viewport moves to the start view of the scene in the next frame
    bool takesEscape = false;  ///< a drag in a panel is active: Esc restores its value and does nothing else
    /// Handler that receives each event before all other code; null: none. Set while a panel handles keys
    /// itself. @return true if it used the event
    std::function<bool(const Event&)> takeEvent;

    [[nodiscard]] float px(float size) const { return size * scale; }
};

/// A pane of the window. Registered in panel_list.cpp.
class Panel {
public:
    virtual ~Panel() = default;
    virtual void draw(Ui& ui) = 0;
};

struct PanelRow {
    const char* title;
    Dock dock;  ///< default position
    std::unique_ptr<Panel> (*make)();
    bool tall = false;  ///< needs more height than other panels if docked at the bottom
};
std::span<const PanelRow> panelTable();
/// Title and default dock of each panel in panelTable(), for PaneLayout.
std::span<const PanelHome> panelHomes();

/// Draws the numbers of errors and warnings in the log after the last item of the status bar; a click shows
/// the Console panel.
void drawLogCounts(Ui& ui);

/// Shows a tooltip while the mouse hovers over the last drawn ImGui item, even if the item is disabled.
void tooltip(std::string_view text);

/// Draws a menu item for an action, with its shortcut; disabled while the action is not possible.
/// @param path  prefix of the widget path, for tests
void actionItem(Ui& ui, std::string_view action, const std::string& path);

/// Draws the items of the context menu for the selected entities.
void selectionMenu(Ui& ui, const std::string& path);

}  // namespace plumb::editor::ui
