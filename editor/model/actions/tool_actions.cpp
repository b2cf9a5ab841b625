#include <array>

#include "editor/model/actions/action_rows.hpp"

namespace plumb::editor {
namespace {

/// An action that activates the tool of this id.
constexpr Action tool(std::string_view id, std::string_view label, Key key, During during = During::Always) {
    return {id, "Tool", label, {key}, editable, nullptr, nullptr, {}, during};
}

const std::array kRows{
    tool("tool.select", "Select", Key::Q),
    tool("tool.move", "Move", Key::W),
    tool("tool.rotate", "Rotate", Key::E, During::Entities),
    tool("tool.scale", "Scale", Key::R),
    tool("tool.shape", "Shape", Key::C),
    line("Tool"),
    tool("tool.brush", "Brush", Key::B),
    tool("tool.terrain", "Terrain", Key::T),
    tool("tool.line", "Line", Key::L),
    tool("tool.rectangle", "Rectangle", Key::U),
    Action{"tool.ellipse", "Tool", "Ellipse", shifted(Key::U), editable},
    tool("tool.fill", "Fill", Key::G),
    tool("tool.erase", "Eraser", Key::E, During::Tiles),
    tool("tool.pick", "Pick tiles", Key::I),
    tool("tool.moveTiles", "Select and move tiles", Key::M),
    tool("tool.same", "Select same tiles", Key::S, During::Tiles),
};

}  // namespace

std::span<const Action> toolActions() { return kRows; }

}  // namespace plumb::editor
