#pragma once

#include "editor/ui/fields/curve_edit.hpp"
#include "editor/ui/fields/field_row.hpp"
#include "editor/ui/fields/number_edit.hpp"
#include "editor/ui/fields/pickers.hpp"
#include "editor/ui/fields/typing.hpp"

namespace plumb::editor::ui {

/// The widgets of a panel's fields, by their kind, range and unit, and what of them is under the hands now.
class FieldEdit {
public:
    /// Draws the widget of a field and lets it change all of the target; a dash stands where they differ.
    void draw(const FieldRow& row);
    /// After all were drawn.
    void endFrame(Ui& ui) { typing_.endFrame(ui), numbers_.endFrame(ui), curves_.endFrame(ui); }

private:
    /// @param at  bytes from the start of the value
    void drawNumbers(const FieldRow& row, const char* letters, std::size_t at);
    void drawList(const FieldRow& row);
    void drawText(const FieldRow& row);
    void drawColor(const FieldRow& row);
    /// A text that a click makes one to type over. @param take  makes a value of what was typed
    void drawWord(const FieldRow& row, const std::string& path, const std::string& text,
                  Result<FieldValue> (*take)(Workspace& workspace, std::string_view text));

    Typing typing_;
    NumberEdit numbers_{typing_};
    CurveEdit curves_;
    EntityPicker entities_;
    AssetPicker assets_;
};

}  // namespace plumb::editor::ui
