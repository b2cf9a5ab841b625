#pragma once

#include "editor/model/document/field_value.hpp"

namespace plumb::editor {

// Numbers in the value of a field: a scalar, a component of a vector or rect, an element of a list. They are
// in the units of the inspector: angles in degrees, and 0.1f as the double 0.1, not as 0.100000001.

/// True if the field consists of numbers that can be edited one by one.
bool hasNumbers(const FieldInfo& field);
/// Returns the size of one number of the field, bytes.
std::size_t numberSize(const FieldInfo& field);
/// Returns a number of the value. @param at  byte offset of the number in the value
double numberAt(const FieldInfo& field, const FieldValue& value, std::size_t at = 0);
/// Sets a number of the value, clamped to the field's range, and rounded if the field is an integer.
void setNumberAt(const FieldInfo& field, FieldValue& value, double number, std::size_t at = 0);

/// Range of a field's numbers, in the units of the inspector: the field's limits, else those of its type.
struct NumberRange {
    double min = 0.0;
    double max = 0.0;
    bool limited = false;  ///< the field has limits of its own
};
NumberRange numberRange(const FieldInfo& field);

/// Returns the change of a number per pixel of a drag, in the units of the inspector.
double numberStep(const FieldInfo& field);

/// Returns a short text for display and editing: "12", "0.25", "1e+20".
std::string numberText(double number);

}  // namespace plumb::editor
