#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "math/color.hpp"
#include "math/vec2.hpp"
#include "reflect/json.hpp"

namespace plumb {

/// Reads the members of one object of LDtk's files. One that is missing or null gives its fallback; one that
/// is wrong gives its fallback too and tells the problem. A key that no reader knows is reported by
/// `tellUnknownKeys`.
class LdtkFields {
public:
    LdtkFields(const Json& object, std::string where, std::vector<Error>& problems)
        : object_{&object}, where_{std::move(where)}, problems_{&problems} {}

    /// Null when it is missing or null.
    [[nodiscard]] const Json* find(std::string_view key) const;
    [[nodiscard]] std::string text(std::string_view key, std::string_view fallback = {}) const;
    [[nodiscard]] int whole(std::string_view key, int fallback) const;
    [[nodiscard]] double real(std::string_view key, double fallback) const;
    [[nodiscard]] bool flag(std::string_view key, bool fallback) const;
    [[nodiscard]] Color color(std::string_view key, Color fallback) const;
    /// Of two numbers in a list.
    [[nodiscard]] Vec2 pair(std::string_view key, Vec2 fallback) const;
    /// The objects of a list.
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
