#pragma once

#include "editor/ui/fields/curve_edit.hpp"
#include "editor/ui/fields/field_row.hpp"
#include "editor/ui/fields/number_edit.hpp"
#include "editor/ui/fields/pickers.hpp"
#include "editor/ui/fields/typing.hpp"

namespace plumb::editor::ui {

/// Draws the widget of each field of a panel, as the field's kind, range and unit require. Stores the state
/// of the widget that is being edited.
class FieldEdit {
public:
    /// Draws the widget of a field. An edit changes all entities in row.target; if their values differ, the
    /// widget shows a dash.
    void draw(const FieldRow& row);
    /// Must be called after all fields were drawn.
    void endFrame(Ui& ui) { typing_.endFrame(ui), numbers_.endFrame(ui), curves_.endFrame(ui); }

private:
    /// @param letters  label of each number: "xy"   @param at  byte offset of the first number in the value
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
