#pragma once

#include "editor/ui/fields/field_row.hpp"

namespace plumb::editor::ui {

// Fields whose values are chosen, not typed: one function for each kind.

void chooseBool(const FieldRow& row);
void chooseEnum(const FieldRow& row);
/// The layers of collisions, by the names that the project gives them.
void chooseLayers(const FieldRow& row);
/// The size of a grid of tiles; the tiles themselves are painted in the scene.
void chooseTiles(const FieldRow& row);
/// The color, which opens a picker. Each channel of all of them changes by itself.
void chooseColor(const FieldRow& row);
/// One entry more, or one less, at the end of a list.
void chooseLength(const FieldRow& row, std::uint32_t count);

}  // namespace plumb::editor::ui
