#pragma once

#include "editor/ui/fields/field_row.hpp"

namespace plumb::editor::ui {

// Widgets for fields whose values are selected instead of typed, one function for each kind.

void chooseBool(const FieldRow& row);
void chooseEnum(const FieldRow& row);
/// Edits a set of collision layers, by their names in the project.
void chooseLayers(const FieldRow& row);
/// Edits the size of a tile grid; the tiles are painted in the scene view.
void chooseTiles(const FieldRow& row);
/// Draws a color that opens a picker. Only the edited channels change; entities may differ in the others.
void chooseColor(const FieldRow& row);
/// Draws the buttons that add or remove the last entry of a list. @param count  present number of entries
void chooseLength(const FieldRow& row, std::uint32_t count);

}  // namespace plumb::editor::ui
