#pragma once

#include <span>

#include "editor/model/view/overlay.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor::ui {

/// Drawn over the scene when its name is switched on. One row of overlay_list.cpp.
struct OverlayRow {
    std::string_view name;
    std::string_view label;
    /// @param world  the document's, or the one that plays
    void (*draw)(const Workspace& workspace, const World& world, Overlay& overlay);
    bool ofEntities = false;  ///< can be shown of what is selected alone
};

std::span<const OverlayRow> overlayTable();

}  // namespace plumb::editor::ui
