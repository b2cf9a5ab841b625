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

/// Where the mouse is in the scene, and what is held with it.
struct Pointer {
    Vec2 position;                ///< px, world
    bool snap = false;            ///< to the grid
    Vec2 grid{16.0f, 16.0f};      ///< px
    float angle = 0.2617993878f;  ///< rad: of the steps in which things turn; 0: freely, though `snap` is set
    float reach = 3.0f;           ///< px, world: how far beside a thing still hits it
    float pixel = 1.0f;           ///< px of the world for one px on screen: handles keep their size
    bool secondary = false;       ///< the right button instead of the left one
    Modifiers modifiers{};
};

/// What a tool works with: it reads the document, writes with commands, and may select.
struct ToolContext {
    const Document& document;
    UndoStack& undo;
    Selection& selection;
    TilePaint& tiles;
};

/// What the mouse does in the scene. No window here: a test plays a drag in five lines.
class Tool {
public:
    virtual ~Tool() = default;
    virtual void press(const ToolContext& context, const Pointer& pointer) = 0;
    virtual void drag(const ToolContext& context, const Pointer& pointer) = 0;
    virtual void release(const ToolContext& context, const Pointer& pointer) = 0;
    /// Esc: takes back what is under way. @return false when nothing was
    virtual bool cancel(const ToolContext& context) = 0;
    virtual void draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const = 0;
    /// Whether a part of the thing in hand is chosen that can be taken out: Del means that then.
    [[nodiscard]] virtual bool hasChosen(const ToolContext&) const { return false; }
    virtual void removeChosen(const ToolContext&) {}
    /// The action of the tool that takes over after a release; empty: this one stays.
    [[nodiscard]] virtual std::string_view next() const { return {}; }
};

/// What is painted once a tool is chosen.
enum class Hand : unsigned char { Keeps, Stamp, Terrain };

/// One row of the table of all tools.
struct ToolRow {
    std::string_view name;
    std::string_view action;  ///< in the table of actions, which has its shortcut
    std::string_view hint;    ///< for the status bar
    bool forTiles = false;    ///< works on tiles; the others on entities
    Hand hand = Hand::Keeps;  ///< what a tile tool takes into the hand
    std::unique_ptr<Tool> (*make)() = nullptr;
};
const std::vector<ToolRow>& toolTable();

/// The next crossing of the grid.
Vec2 snapped(Vec2 point, Vec2 grid);

}  // namespace plumb::editor
