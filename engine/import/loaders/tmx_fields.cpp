#include "import/loaders/tmx_fields.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/text.hpp"

namespace plumb {
namespace {

std::optional<double> parseReal(std::string_view text) {
    text = trimmed(text);
    double value = 0.0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = problem == std::errc{} && end == text.data() + text.size();
    return whole && std::isfinite(value) ? std::optional{value} : std::nullopt;
}

std::optional<bool> parseFlag(std::string_view text) {
    if (text == "1" || text == "true") return true;
    if (text == "0" || text == "false") return false;
    return {};
}

/// Converts a property's text to a value of its type. Text that is not valid for the type is reported and
/// kept as a string.
Json plainValue(const std::string& type, const std::string& text, const TmxFields& fields) {
    if (type == "bool") {
        if (const std::optional<bool> value = parseFlag(text)) return Json(*value);
    } else if (type == "int" || type == "object") {
        if (const std::optional<std::int64_t> value = parseInt(trimmed(text))) return Json(*value);
    } else if (type == "float") {
        if (const std::optional<double> value = parseReal(text)) return Json(*value);
    } else {
        return Json(text);
    }
    fields.warn(format("the property {} has the type {} and the value \"{}\"", fields.text("name"), type,
                       text.substr(0, 40)),
                "enter a value of this type in Tiled; it was imported as a string");
    return Json(text);
}

Json propertyValue(const XmlElement& property, std::string_view file, std::vector<Error>& problems) {
    const TmxFields fields{property, file, problems};
    const std::string type = fields.text("type", "string");
    Json value;
    if (type == "class" || property.child("properties")) {
        value = tmxProperties(property, file, problems);
    } else if (type == "list") {
        value = Json::array();
        for (const XmlElement& item : property.children) {
            if (item.name == "item") value.push_back(propertyValue(item, file, problems));
        }
    } else {
        // Text of several lines is the element's content instead of an attribute.
        value = plainValue(type, fields.has("value") ? *property.find("value") : property.text, fields);
    }
    const bool plain =
        type == "string" || type == "bool" || type == "int" || type == "float" || type == "list";
    const std::string name = fields.text("propertytype");
    if (plain && name.empty()) return value;
    if (type == "class" && name.empty()) return value;
    Json typed = Json::object();
    typed["type"] = type;
    if (!name.empty()) typed["class"] = name;
    typed["value"] = std::move(value);
    return typed;
}

}  // namespace

const std::string* TmxFields::value(std::string_view name) const {
    const std::string* found = element_->find(name);
    return found && !found->empty() ? found : nullptr;
}

bool TmxFields::has(std::string_view name) const { return element_->find(name) != nullptr; }

std::string TmxFields::text(std::string_view name, std::string_view fallback) const {
    const std::string* found = value(name);
    return found ? *found : std::string{fallback};
}

std::string TmxFields::path(std::string_view name) const {
    std::string found = text(name);
    std::replace(found.begin(), found.end(), '\\', '/');
    return found;
}

int TmxFields::whole(std::string_view name, int fallback, int min, int max) const {
    const std::string* found = value(name);
    if (!found) return fallback;
    // Some versions of Tiled write integers with a fraction: 16.0.
    const std::optional<double> number = parseReal(*found);
    if (number && *number >= min && *number <= max) return static_cast<int>(*number);
    warn(format("{} is \"{}\"", name, *found), format("it must be an integer from {} to {}", min, max));
    return fallback;
}

double TmxFields::real(std::string_view name, double fallback) const {
    const std::string* found = value(name);
    if (!found) return fallback;
    const std::optional<double> number = parseReal(*found);
    if (number && std::abs(*number) <= 1e9) return *number;
    warn(format("{} is \"{}\"", name, *found), "it must be a number between -1e9 and 1e9");
    return fallback;
}

bool TmxFields::flag(std::string_view name, bool fallback) const {
    const std::string* found = value(name);
    if (!found) return fallback;
    if (const std::optional<bool> flag = parseFlag(*found)) return *flag;
    warn(format("{} is \"{}\"", name, found->substr(0, 40)), "it must be 0 or 1");
    return fallback;
}

std::optional<Color> TmxFields::color(std::string_view name) const {
    const std::string* found = value(name);
    if (!found) return {};
    std::string_view digits = *found;
    if (startsWith(digits, "#")) digits.remove_prefix(1);
    const std::optional<std::uint64_t> bits = parseHex(digits);
    if (!bits || (digits.size() != 6 && digits.size() != 8)) {
        warn(format("{} is \"{}\"", name, *found), "it must be a color as #rrggbb or #aarrggbb");
        return {};
    }
    const auto part = [&](int shift) { return static_cast<std::uint8_t>(*bits >> shift & 255); };
    return Color{part(16), part(8), part(0), digits.size() == 8 ? part(24) : std::uint8_t{255}};
}

std::string TmxFields::where() const {
    if (element_->line == 0) return format("{}: {}", file_, element_->name);
    return format("{}:{}: {}", file_, element_->line, element_->name);
}

void TmxFields::warn(std::string what, std::string remedy) const {
    problems_->push_back({where(), std::move(what), std::move(remedy)});
}

Json tmxProperties(const XmlElement& element, std::string_view file, std::vector<Error>& problems) {
    Json properties = Json::object();
    const XmlElement* list = element.child("properties");
    if (!list) return properties;
    for (const XmlElement& property : list->children) {
        const std::string* name = property.find("name");
        if (property.name != "property" || !name || name->empty()) {
            TmxFields{property, file, problems}.warn("a property has no name", "give it a name in Tiled");
            continue;
        }
        if (properties.contains(*name)) {
            TmxFields{property, file, problems}.warn(format("there are two properties named {}", *name),
                                                     "rename one of them; the last one was imported");
        }
        properties[*name] = propertyValue(property, file, problems);
    }
    return properties;
}

}  // namespace plumb
