#pragma once

#include <optional>
#include <string>

#include "editor/model/field_value.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// Draws the widget of a field by its kind, range and unit; angles are shown in degrees.
/// @param path       how tests call it, e.g. "Inspector/Transform/position"
/// @param component  the component that is shown; not changed
/// @return           the value that the person made of it in this frame
std::optional<FieldValue> editField(Ui& ui, const std::string& path, const FieldInfo& field,
                                    const void* component);

/// "px", "deg/s", "s": what a number of the unit is shown in.
const char* shownUnit(Unit unit);

/// The parts of `to` that differ from `from` put into `into`: one number of a pair, one channel of a color.
FieldValue withChangedParts(const FieldInfo& field, FieldValue into, const FieldValue& from,
                            const FieldValue& to);

}  // namespace plumb::editor::ui
