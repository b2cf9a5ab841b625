#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "codec/xml.hpp"
#include "core/result.hpp"
#include "math/color.hpp"
#include "reflect/json.hpp"

namespace plumb {

/// Reads the attributes of one element of a Tiled file. One that is missing gives its fallback; one that is
/// wrong gives its fallback too and tells the problem.
class TmxFields {
public:
    TmxFields(const XmlElement& element, std::string_view file, std::vector<Error>& problems)
        : element_{&element}, file_{file}, problems_{&problems} {}

    [[nodiscard]] bool has(std::string_view name) const;
    [[nodiscard]] std::string text(std::string_view name, std::string_view fallback = {}) const;
    [[nodiscard]] int whole(std::string_view name, int fallback, int min, int max) const;
    [[nodiscard]] double real(std::string_view name, double fallback) const;
    [[nodiscard]] bool flag(std::string_view name, bool fallback) const;
    /// "#aarrggbb", "#rrggbb" or without '#'.
    [[nodiscard]] std::optional<Color> color(std::string_view name) const;

    /// "file.tmx:12: object", the place of this element.
    [[nodiscard]] std::string where() const;
    void warn(std::string what, std::string remedy) const;

private:
    /// The attribute's value when it is there and not empty.
    [[nodiscard]] const std::string* value(std::string_view name) const;

    const XmlElement* element_;
    std::string_view file_;
    std::vector<Error>* problems_;
};

/// The `<properties>` inside an element as one JSON object: numbers, flags and texts by their type, classes
/// as objects, lists as arrays. Types that JSON does not show are kept as {"type", "value"}.
Json tmxProperties(const XmlElement& element, std::string_view file, std::vector<Error>& problems);

}  // namespace plumb
