#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "editor/model/document/document.hpp"
#include "editor/model/document/tile_paint.hpp"
#include "editor/model/document/undo_stack.hpp"
#include "editor/model/view/overlay.hpp"
#include "platform/events.hpp"

namespace plumb::editor {

/// The mouse pointer in the scene, with the snapping settings and modifier keys that apply.
struct Pointer {
    Vec2 position;                ///< px, world: position of the mouse
    bool snap = false;            ///< snap to the grid and to angle steps
    Vec2 grid{16.0f, 16.0f};      ///< px: cell size of the grid
    float angle = 0.2617993878f;  ///< rad: step of snapped rotations; 0: no steps, even if `snap` is true
    float reach = 3.0f;           ///< px, world: maximum distance at which an entity is still hit
    float pixel = 1.0f;           ///< size of a screen pixel in world px, to draw handles of constant size
    bool secondary = false;       ///< true: the right button; false: the left one
    Modifiers modifiers{};
};

/// The objects that a tool uses: it reads the document, changes it by commands, and changes the selection.
struct ToolContext {
    const Document& document;
    UndoStack& undo;
    Selection& selection;
    TilePaint& tiles;
};

/// A mouse tool of the scene view. It does not depend on a window, so that tests can simulate drags.
class Tool {
public:
    virtual ~Tool() = default;
    virtual void press(const ToolContext& context, const Pointer& pointer) = 0;
    virtual void drag(const ToolContext& context, const Pointer& pointer) = 0;
    virtual void release(const ToolContext& context, const Pointer& pointer) = 0;
    /// Cancels the present drag, on Esc. @return false if there was nothing to cancel
    virtual bool cancel(const ToolContext& context) = 0;
    virtual void draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const = 0;
    /// True if a removable part of the active entity is selected, such as a corner; Del removes it then.
    [[nodiscard]] virtual bool hasSelectedPart(const ToolContext&) const { return false; }
    /// Removes the part that `hasSelectedPart` reports.
    virtual void removeChosen(const ToolContext&) {}
    /// Id of the action that selects the next tool after a release; empty: this tool stays.
    [[nodiscard]] virtual std::string_view next() const { return {}; }
};

/// What the tile tools paint after a tool is selected: the stamp (the chosen tiles), the chosen terrain, or
/// (Unchanged) what they painted before.
enum class PaintChoice : unsigned char { Unchanged, Stamp, Terrain };

/// One tool in the table of all tools.
struct ToolRow {
    std::string_view name;
    std::string_view action;  ///< id of the action that selects the tool, which has its shortcut
    std::string_view hint;    ///< text shown in the status bar
    bool forTiles = false;    ///< true: edits tiles; false: edits entities
    PaintChoice paintChoice = PaintChoice::Unchanged;  ///< applied when the tool is selected
    std::unique_ptr<Tool> (*make)() = nullptr;
};
const std::vector<ToolRow>& toolTable();

/// Returns the grid point nearest to `point`.
Vec2 snapped(Vec2 point, Vec2 grid);

}  // namespace plumb::editor
