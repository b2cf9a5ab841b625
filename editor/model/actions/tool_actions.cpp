#include <array>

#include "editor/model/actions/action_rows.hpp"

namespace plumb::editor {
namespace {

bool painting(const Workspace& w) { return editable(w) && w.paintsTiles(); }

/// Takes the tool of this id into the hand.
constexpr Action tool(std::string_view id, std::string_view label, Key key, During during = During::Always) {
    return {id, "Tool", label, {key}, editable, nullptr, nullptr, {}, during};
}

const std::array kRows{
    tool("tool.select", "Select", Key::Q),
    tool("tool.move", "Move", Key::W),
    tool("tool.rotate", "Rotate", Key::E, During::Entities),
    tool("tool.scale", "Scale", Key::R),
    line("Tool"),
    tool("tool.brush", "Brush", Key::B),
    tool("tool.erase", "Eraser", Key::E, During::Tiles),
    tool("tool.rectangle", "Rectangle", Key::U),
    tool("tool.fill", "Fill", Key::G),
    tool("tool.pick", "Pick tiles", Key::I),
    line("Tool"),
    Action{"tiles.flipX",
           "Tool",
           "Flip tiles left to right",
           {Key::X},
           painting,
           [](Workspace& w) { w.tiles.stamp = flippedX(w.tiles.stamp); }},
    Action{"tiles.flipY",
           "Tool",
           "Flip tiles upside down",
           {Key::Y},
           painting,
           [](Workspace& w) { w.tiles.stamp = flippedY(w.tiles.stamp); }},
    Action{"tiles.turn",
           "Tool",
           "Turn tiles",
           {Key::Z},
           painting,
           [](Workspace& w) { w.tiles.stamp = turned(w.tiles.stamp); }},
};

}  // namespace

std::span<const Action> toolActions() { return kRows; }

}  // namespace plumb::editor
