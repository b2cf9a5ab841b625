#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "math/color.hpp"
#include "math/vec2.hpp"
#include "reflect/json.hpp"

namespace plumb {

/// Reads the members of one JSON object of an LDtk file. Returns the fallback for a member that is missing or
/// null, and also for one of the wrong type, which is reported. Unknown keys are reported by
/// `reportUnknownKeys`.
class LdtkFields {
public:
    LdtkFields(const Json& object, std::string where, std::vector<Error>& problems)
        : object_{&object}, where_{std::move(where)}, problems_{&problems} {}

    /// Returns a member; a null pointer if it is missing or JSON null.
    [[nodiscard]] const Json* find(std::string_view key) const;
    [[nodiscard]] std::string text(std::string_view key, std::string_view fallback = {}) const;
    [[nodiscard]] int whole(std::string_view key, int fallback) const;
    [[nodiscard]] double real(std::string_view key, double fallback) const;
    [[nodiscard]] bool flag(std::string_view key, bool fallback) const;
    [[nodiscard]] Color color(std::string_view key, Color fallback) const;
    /// Reads an array of two numbers.
    [[nodiscard]] Vec2 pair(std::string_view key, Vec2 fallback) const;
    /// Returns readers for the objects in an array.
    [[nodiscard]] std::vector<LdtkFields> objects(std::string_view key) const;

    [[nodiscard]] const std::string& where() const { return where_; }
    [[nodiscard]] const Json& json() const { return *object_; }
    void warn(std::string_view key, std::string what, std::string remedy) const;

private:
    const Json* object_;
    std::string where_;
    std::vector<Error>* problems_;
};

}  // namespace plumb
