#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "import/loaders/xml.hpp"
#include "math/color.hpp"
#include "reflect/json.hpp"

namespace plumb {

/// Reads the attributes of one element of a Tiled file. Returns the fallback for an attribute that is missing
/// or invalid, and reports invalid ones.
class TmxFields {
public:
    TmxFields(const XmlElement& element, std::string_view file, std::vector<Error>& problems)
        : element_{&element}, file_{file}, problems_{&problems} {}

    [[nodiscard]] bool has(std::string_view name) const;
    [[nodiscard]] std::string text(std::string_view name, std::string_view fallback = {}) const;
    /// Reads the path of a file. Windows programs may write it with '\\', which becomes '/'.
    [[nodiscard]] std::string path(std::string_view name) const;
    [[nodiscard]] int whole(std::string_view name, int fallback, int min, int max) const;
    [[nodiscard]] double real(std::string_view name, double fallback) const;
    [[nodiscard]] bool flag(std::string_view name, bool fallback) const;
    /// Reads a color: "#aarrggbb" or "#rrggbb", with or without '#'.
    [[nodiscard]] std::optional<Color> color(std::string_view name) const;

    /// Returns the location of this element for messages: "file.tmx:12: object".
    [[nodiscard]] std::string where() const;
    void warn(std::string what, std::string remedy) const;

private:
    /// Returns the attribute's value; null if it is missing or empty.
    [[nodiscard]] const std::string* value(std::string_view name) const;

    const XmlElement* element_;
    std::string_view file_;
    std::vector<Error>* problems_;
};

/// Converts the `<properties>` of an element to one JSON object: numbers, booleans, strings, classes as
/// objects, lists as arrays. Other types (color, file, object) are stored as {"type", "value"}.
Json tmxProperties(const XmlElement& element, std::string_view file, std::vector<Error>& problems);

}  // namespace plumb
