#pragma once

#include "editor/model/document/field_value.hpp"

namespace plumb::editor {

// A number inside the value of a field: the number itself, the y of a pair, one of a list. It is seen as the
// inspector shows it: angles in degrees, and 0.1 as 0.1, not as the float that is nearest to it.

/// Whether a field is made of numbers that are edited one by one.
bool hasNumbers(const FieldInfo& field);
/// Bytes of one of them.
std::size_t numberSize(const FieldInfo& field);
/// @param at  bytes from the start of the value
double numberAt(const FieldInfo& field, const FieldValue& value, std::size_t at = 0);
/// Sets it to the nearest that the field can hold: within its range, whole where it is whole.
void setNumberAt(const FieldInfo& field, FieldValue& value, double number, std::size_t at = 0);

/// What a number of the field may be, as shown. Without limits of its own, what its bytes hold.
struct NumberRange {
    double min = 0.0;
    double max = 0.0;
    bool limited = false;  ///< the field's description says so
};
NumberRange numberRange(const FieldInfo& field);

/// By how much one pixel of a drag changes it, as shown.
double numberStep(const FieldInfo& field);

/// Short, for people and to be typed over: "12", "0.25", "1e+20".
std::string numberText(double number);

}  // namespace plumb::editor
