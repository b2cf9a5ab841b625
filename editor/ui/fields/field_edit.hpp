#pragma once

#include "editor/ui/fields/curve_edit.hpp"
#include "editor/ui/fields/field_row.hpp"
#include "editor/ui/fields/number_edit.hpp"
#include "editor/ui/fields/pickers.hpp"
#include "editor/ui/fields/typing.hpp"

namespace plumb::editor::ui {

/// Draws the widgets of a panel's fields by their kind, range and unit, and stores the state of the active
/// one.
class FieldEdit {
public:
    /// Draws the widget of a field, which changes all entities of the target. Different values are shown as a
    /// dash.
    void draw(const FieldRow& row);
    /// Must be called after all fields were drawn.
    void endFrame(Ui& ui) { typing_.endFrame(ui), numbers_.endFrame(ui), curves_.endFrame(ui); }

private:
    /// @param at  offset of the first number from the start of the value, bytes
    void drawNumbers(const FieldRow& row, const char* letters, std::size_t at);
    void drawList(const FieldRow& row);
    void drawText(const FieldRow& row);
    void drawColor(const FieldRow& row);
    /// Draws a text that a click turns into an input field. @param take  converts the typed text to a value
    void drawWord(const FieldRow& row, const std::string& path, const std::string& text,
                  Result<FieldValue> (*take)(Workspace& workspace, std::string_view text));

    Typing typing_;
    NumberEdit numbers_{typing_};
    CurveEdit curves_;
    EntityPicker entities_;
    AssetPicker assets_;
};

}  // namespace plumb::editor::ui
