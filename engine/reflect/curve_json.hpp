#pragma once

#include "core/result.hpp"
#include "math/curve.hpp"
#include "reflect/json_fwd.hpp"
#include "reflect/type_info.hpp"

namespace plumb {

class FieldContext;

/// A curve as stored in files, on one line: ["smooth", [0, 1], [0.5,
/// 0.8], [1, 0]]. Each pair is a position along 0..1 and the value there.
Json curveToJson(const Curve& curve);

/// Reads a curve. A value outside the field's range is clamped, with a warning to the context.
/// @error not a curve, an unknown word, no key, too many, out of order, outside 0..1; `value` is unchanged
Result<Done> readCurve(const FieldInfo& field, void* value, const Json& json, FieldContext& context);

}  // namespace plumb
