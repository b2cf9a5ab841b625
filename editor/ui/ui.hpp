#pragma once

#include <deque>
#include <string>
#include <string_view>

#include "core/log.hpp"
#include "editor/model/workspace.hpp"
#include "editor/ui/theme.hpp"
#include "editor/ui/widget_map.hpp"

namespace plumb::editor::ui {

class ScenePicture;

/// What every panel draws with.
struct Ui {
    Workspace& workspace;
    WidgetMap& widgets;
    Fonts fonts;
    float scale = 1.0f;               ///< of the whole interface
    ScenePicture* picture = nullptr;  ///< null: headless, the viewport stays empty
    std::deque<LogLine> log;
    float playAlpha = 1.0f;  ///< between the last two ticks of the game that plays
    Vec2 mouseInScene;       ///< px, world
    bool mouseOverScene = false;
    bool panHeld = false;    ///< Space is held over the scene
    bool viewReady = false;  ///< the viewport has had its size once

    [[nodiscard]] float px(float size) const { return size * scale; }
};

/// A pane of the window. Registered in panel_list.cpp.
class Panel {
public:
    virtual ~Panel() = default;
    virtual void draw(Ui& ui) = 0;
};

enum class Dock : unsigned char { Left, Center, Right, Bottom };

struct PanelRow {
    const char* title;
    Dock dock;
    std::unique_ptr<Panel> (*make)();
};
std::span<const PanelRow> panelTable();

/// Shows text when the mouse rests on the last item.
void tooltip(std::string_view text);

}  // namespace plumb::editor::ui
