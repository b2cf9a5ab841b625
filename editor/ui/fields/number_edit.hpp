#pragma once

#include <string>
#include <vector>

#include "editor/ui/fields/field_row.hpp"
#include "editor/ui/fields/typing.hpp"

namespace plumb::editor::ui {

/// Numbers that are dragged or typed over. One for a panel.
class NumberEdit {
public:
    explicit NumberEdit(Typing& typing) : typing_{typing} {}

    /// One number of a field. Dragging changes all of the target by as much; typing gives an expression to
    /// each.
    /// @param path   how tests call this number
    /// @param at     bytes from the start of the value
    /// @param width  px
    void draw(const FieldRow& row, const std::string& path, std::size_t at, float width);
    /// After all were drawn.
    void endFrame(Ui& ui);

private:
    void drag(const FieldRow& row, const std::string& path, std::size_t at);
    void change(const FieldRow& row, std::size_t at);

    Typing& typing_;
    std::string path_;            // what is dragged; empty: nothing
    double dragged_ = 0.0;        // what ImGui drags, as shown
    double start_ = 0.0;          // where it began
    std::vector<ObjectId> ids_;   // what is changed
    std::vector<double> starts_;  // of each of them that has the component
    bool drawn_ = false;          // in this frame
};

}  // namespace plumb::editor::ui
