#pragma once

#include "math/curve.hpp"
#include "math/vec2.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Code without special support for curves treats a curve as a list of pairs (position, value).
template <>
struct ListTraits<Curve> : std::true_type {
    using Element = Vec2;
    static constexpr std::size_t kCapacity = Curve::kKeys;
};
static_assert(sizeof(CurveKey) == sizeof(Vec2));

/// True if a field is a curve; the field's range applies to the values. A curve is recognized by its size:
/// a list of pairs has a count of 4 bytes, a curve also has its shape, so no list has the same size.
inline bool isCurve(const FieldInfo& field) {
    static_assert(sizeof(Curve) == Curve::kKeys * sizeof(Vec2) + 8);
    return field.kind == FieldKind::List && field.element == FieldKind::Vec2 && field.size == sizeof(Curve);
}

}  // namespace plumb
