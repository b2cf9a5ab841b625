#pragma once

#include <optional>
#include <string_view>

#include "reflect/type_registry.hpp"

namespace plumb {

/// Access to a field of a component as a float, found by name: a
/// number, a bool (0 or 1), an enum, or a component of a vector.
class NumberField {
public:
    /// @param path  name of the field, e.g. "mass" or "gravity.y"
    /// @return nullopt if there is no such component or field, or if it is not a number
    static std::optional<NumberField> find(const TypeRegistry& types, std::string_view component,
                                           std::string_view path);

    [[nodiscard]] float read(const void* component) const;
    /// Writes the value, clamped to the field's range, and rounded for integer fields.
    void write(void* component, float value) const;

    [[nodiscard]] const TypeInfo& type() const { return *type_; }
    [[nodiscard]] const FieldInfo& field() const { return *field_; }

private:
    NumberField(const TypeInfo& type, const FieldInfo& field, int part)
        : type_{&type}, field_{&field}, part_{part} {}

    const TypeInfo* type_;
    const FieldInfo* field_;
    int part_;  // 0: x, 1: y of a vector; -1: not a vector
};

}  // namespace plumb
