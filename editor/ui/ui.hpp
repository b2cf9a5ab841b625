#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "editor/model/view/log_book.hpp"
#include "editor/model/workspace.hpp"
#include "editor/ui/theme.hpp"
#include "editor/ui/widget_map.hpp"

namespace plumb::editor::ui {

class ScenePicture;

/// What every panel draws with.
struct Ui {
    Workspace& workspace;
    WidgetMap& widgets;
    LogBook& log;
    Fonts fonts{};
    float scale = 1.0f;               ///< of the whole interface
    ScenePicture* picture = nullptr;  ///< null: headless, the viewport stays empty
    float playAlpha = 1.0f;           ///< between the last two ticks of the game that plays
    Vec2 mouseInScene;                ///< px, world
    bool mouseOverScene = false;
    bool panHeld = false;      ///< Space is held over the scene
    bool viewReady = false;    ///< the viewport has had its size once
    bool takesEscape = false;  ///< Esc belongs to what is dragged in a panel: it gives the value back
    /// What waits for a key or a button gets each event first. @return whether it was meant for them
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
    Dock dock;  ///< where it stands until the user moves it
    std::unique_ptr<Panel> (*make)();
    bool tall = false;  ///< at the bottom it needs more height than others
};
std::span<const PanelRow> panelTable();
/// The same as the layouts know them.
std::span<const PanelHome> panelHomes();

/// How many errors and warnings the log has, behind the last item of the status bar; a click shows them.
void drawLogCounts(Ui& ui);

/// Shows text when the mouse rests on the last item.
void tooltip(std::string_view text);

/// A menu item for an action, with its shortcut; greyed while it is not possible.
/// @param path  how tests call it
void actionItem(Ui& ui, std::string_view action, const std::string& path);

/// What one can do with the selection, for the menus of the right mouse button.
void selectionMenu(Ui& ui, const std::string& path);

}  // namespace plumb::editor::ui
