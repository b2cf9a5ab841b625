#pragma once

#include <optional>
#include <string_view>

#include "reflect/type_registry.hpp"

namespace plumb {

/// A number of a component, found by its name: a number, a switch (0 or 1), a choice, or a part of a vector.
class NumberField {
public:
    /// @param path  "mass", "gravity.y"
    /// @return nothing where there is no such component, field or part, or where it is no number
    static std::optional<NumberField> find(const TypeRegistry& types, std::string_view component,
                                           std::string_view path);

    [[nodiscard]] float read(const void* component) const;
    /// Brought into the field's range; rounded where it is a whole number.
    void write(void* component, float value) const;

    [[nodiscard]] const TypeInfo& type() const { return *type_; }
    [[nodiscard]] const FieldInfo& field() const { return *field_; }

private:
    NumberField(const TypeInfo& type, const FieldInfo& field, int part)
        : type_{&type}, field_{&field}, part_{part} {}

    const TypeInfo* type_;
    const FieldInfo* field_;
    int part_;  // of a vector
};

}  // namespace plumb
