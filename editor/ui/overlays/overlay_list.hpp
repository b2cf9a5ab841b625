#pragma once

#include <span>

#include "editor/model/view/overlay.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor::ui {

/// An overlay of the viewport that can be switched on by name. The table is in overlay_list.cpp.
struct OverlayRow {
    std::string_view name;   ///< id in the settings, e.g. "reach"
    std::string_view label;  ///< name shown to the user
    /// @param world  the world of the edited scene, or of the running game
    void (*draw)(const Workspace& workspace, const World& world, Overlay& overlay);
    bool ofEntities = false;  ///< true: can be drawn for the selected entities only
};

std::span<const OverlayRow> overlayTable();

}  // namespace plumb::editor::ui
