#pragma once

#include <string>
#include <vector>

#include "editor/ui/fields/field_row.hpp"
#include "editor/ui/fields/typing.hpp"

namespace plumb::editor::ui {

/// Number widgets that are changed by dragging or typing. One object per panel.
class NumberEdit {
public:
    explicit NumberEdit(Typing& typing) : typing_{typing} {}

    /// Draws one number of a field. Dragging changes the numbers of all entities by the same amount; a typed
    /// expression is evaluated for each entity.
    /// @param path   widget path of this number, for tests
    /// @param at     offset of this number from the start of the field's value, bytes
    /// @param width  px; negative: up to the right edge, as in ImGui
    void draw(const FieldRow& row, const std::string& path, std::size_t at, float width);
    /// Must be called after all fields were drawn.
    void endFrame(Ui& ui);

private:
    void drag(const FieldRow& row, const std::string& path, std::size_t at);
    void change(const FieldRow& row, std::size_t at);

    Typing& typing_;
    std::string path_;            // widget path of the dragged number; empty: none
    double dragged_ = 0.0;        // present value of the dragged number, in the shown unit
    double start_ = 0.0;          // value of the dragged number at the start of the drag
    std::vector<ObjectId> ids_;   // entities to change
    std::vector<double> starts_;  // values before the drag, of those `ids_` that have the component
    bool drawn_ = false;          // the dragged number was drawn in this frame
};

}  // namespace plumb::editor::ui
