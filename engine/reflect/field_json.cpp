#include "reflect/field_json.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "math/color.hpp"
#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "reflect/curve_field.hpp"
#include "reflect/curve_json.hpp"
#include "reflect/field_context.hpp"
#include "reflect/json.hpp"
#include "reflect/whole_number.hpp"

namespace plumb {
namespace {

// ---- texts for messages

std::string_view unitWords(Unit unit) {
    switch (unit) {
        case Unit::None: return "a number";
        case Unit::Pixels: return "pixels";
        case Unit::PixelsPerSecond: return "pixels per second";
        case Unit::PixelsPerSecondSquared: return "pixels per second squared";
        case Unit::Seconds: return "seconds";
        case Unit::Radians: return "radians";
        case Unit::RadiansPerSecond: return "radians per second";
        case Unit::Ratio: return "a ratio";
        case Unit::Kilograms: return "kilograms";
        case Unit::Tiles: return "tiles";
        case Unit::Ticks: return "ticks";
        case Unit::Degrees: return "degrees";
    }
    return "a number";
}

Error expected(const FieldInfo& field, std::string_view what, const Json& found, std::string remedy) {
    return {std::string{field.name}, format("expected {}, found {}", what, foundText(found)),
            std::move(remedy)};
}

std::string numberRemedy(const FieldInfo& field) {
    return format("write {}, e.g. 1.5", unitWords(field.unit));
}

// ---- numbers

template <class Number>
Number load(const void* value) {
    Number number{};
    std::memcpy(&number, value, sizeof number);
    return number;
}

template <class Number>
void store(void* value, Number number) {
    std::memcpy(value, &number, sizeof number);
}

void warnClamped(const FieldInfo& field, const Json& found, const std::string& used, FieldContext& context) {
    context.warn(
        {std::string{field.name},
         format("{} is outside {} to {}", foundText(found), shortestText(field.min), shortestText(field.max)),
         format("using {}; write a value inside the range", used)});
}

struct Span64 {
    std::int64_t low;
    std::int64_t high;
};

/// The range of an Int field, by its size and its limits. Not for unsigned 8-byte fields.
Span64 wholeRange(const FieldInfo& field) {
    constexpr double kEdge = 9.2e18;
    const int bits = static_cast<int>(field.size) * 8;
    Span64 span{std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()};
    if (!field.isSigned) {
        span = {0, (std::int64_t{1} << bits) - 1};
    } else if (bits < 64) {
        span = {-(std::int64_t{1} << (bits - 1)), (std::int64_t{1} << (bits - 1)) - 1};
    }
    if (field.min > -kEdge)
        span.low = std::max(span.low, static_cast<std::int64_t>(std::ceil(double{field.min})));
    if (field.max < kEdge)
        span.high = std::min(span.high, static_cast<std::int64_t>(std::floor(double{field.max})));
    return span;
}

Result<Done> readInt(const FieldInfo& field, void* value, const Json& json, FieldContext& context) {
    constexpr double kLargestWhole = 9007199254740992.0;  // 2^53: up to this, integers are exact as doubles
    std::int64_t number = 0;
    if (json.is_number_unsigned()) {
        const auto large = json.get<std::uint64_t>();
        if (!field.isSigned && field.size == 8) return storeWhole(value, field.size, large), Done{};
        number = static_cast<std::int64_t>(std::min<std::uint64_t>(
            large, static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())));
    } else if (json.is_number_integer()) {
        number = json.get<std::int64_t>();
    } else if (json.is_number_float() && std::floor(json.get<double>()) == json.get<double>() &&
               std::fabs(json.get<double>()) <= kLargestWhole) {
        number = static_cast<std::int64_t>(json.get<double>());
    } else {
        return expected(field, "a whole number", json, "write a number without a point, e.g. 3");
    }
    if (!field.isSigned && field.size == 8) {
        if (number < 0) return expected(field, "a number that is not negative", json, "write 0 or more");
        return storeWhole(value, field.size, static_cast<std::uint64_t>(number)), Done{};
    }
    const Span64 range = wholeRange(field);
    const std::int64_t kept = std::clamp(number, range.low, std::max(range.low, range.high));
    if (kept != number) {
        context.warn({std::string{field.name},
                      format("{} is outside {} to {}", number, range.low, range.high),
                      format("using {}; write a value inside the range", kept)});
    }
    storeWhole(value, field.size, static_cast<std::uint64_t>(kept));
    return Done{};
}

/// Returns a finite float, or an error.
Result<float> finiteFrom(const FieldInfo& field, const Json& json) {
    if (!json.is_number()) return expected(field, "a number", json, numberRemedy(field));
    const double wide = json.get<double>();
    if (!std::isfinite(wide) || std::fabs(wide) > double{std::numeric_limits<float>::max()}) {
        return expected(field, "a finite number", json, numberRemedy(field));
    }
    return static_cast<float>(wide);
}

Result<Done> readFloat(const FieldInfo& field, void* value, const Json& json, FieldContext& context) {
    const Result<float> number = finiteFrom(field, json);
    if (!number) return number.error();
    const float kept = std::clamp(*number, field.min, field.max);
    if (kept != *number) warnClamped(field, json, shortestText(kept), context);
    store(value, kept == *number ? *number : kept);
    return Done{};
}

/// Reads the numbers of a Vec2 or a Rect: all of them, or none and an error.
Result<Done> readFloats(const FieldInfo& field, void* value, const Json& json, std::size_t count) {
    const std::string_view form = count == 2 ? "[x, y]" : "[x, y, width, height]";
    if (!json.is_array() || json.size() != count) {
        return expected(field, form, json, format("write {} numbers in {}", count, unitWords(field.unit)));
    }
    float numbers[4] = {};
    for (std::size_t i = 0; i < count; ++i) {
        const Result<float> number = finiteFrom(field, json[i]);
        if (!number) {
            Error error = number.error();
            error.where = format("{}[{}]", field.name, i);
            return error;
        }
        numbers[i] = *number;
    }
    std::memcpy(value, numbers, count * sizeof(float));
    return Done{};
}

Json floatsToJson(const void* value, std::size_t count) {
    Json json = Json::array();
    for (std::size_t i = 0; i < count; ++i) {
        json.push_back(double{load<float>(static_cast<const char*>(value) + i * sizeof(float))});
    }
    return json;
}

// ---- values stored as strings

std::string colorText(Color color) {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t part : {color.r, color.g, color.b, color.a}) {
        text += kDigits[part >> 4];
        text += kDigits[part & 15];
    }
    return text;
}

Result<Done> readColor(const FieldInfo& field, void* value, const Json& json) {
    const auto* text = json.get_ptr<const std::string*>();
    const bool formed = text != nullptr && (text->size() == 7 || text->size() == 9) && text->front() == '#';
    const std::optional<std::uint64_t> bits =
        formed ? parseHex(std::string_view{*text}.substr(1)) : std::nullopt;
    if (!bits)
        return expected(field, "a color", json, "write \"#rrggbb\" or \"#rrggbbaa\", e.g. \"#ff8000\"");
    const std::uint64_t all = text->size() == 7 ? *bits << 8 | 0xff : *bits;
    const auto part = [all](int shift) { return static_cast<std::uint8_t>(all >> shift); };
    store(value, Color{part(24), part(16), part(8), part(0)});
    return Done{};
}

Result<std::string_view> textFrom(const FieldInfo& field, const Json& json, std::string_view what) {
    const auto* text = json.get_ptr<const std::string*>();
    if (text == nullptr) return expected(field, what, json, "write it in double quotes");
    if (text->size() > limits::kTextBytes) {
        return Error{std::string{field.name},
                     format("a string of {} bytes, the limit is {}", text->size(), limits::kTextBytes),
                     "shorten it"};
    }
    if (!isUtf8(*text)) return Error{std::string{field.name}, "the string is not UTF-8", "write it as UTF-8"};
    return std::string_view{*text};
}

/// True for a path that leads out of the project, whatever files exist.
bool leavesProject(std::string_view path) {
    if (path.front() == '/' || path.find('\\') != std::string_view::npos) return true;
    if (path.size() > 1 && path[1] == ':') return true;
    for (const std::string_view part : split(path, '/')) {
        if (part == "..") return true;
    }
    return std::any_of(path.begin(), path.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; });
}

Result<Done> readAsset(const FieldInfo& field, void* value, const Json& json, FieldContext& context) {
    const Result<std::string_view> path = textFrom(field, json, "the path of a file");
    if (!path) return path.error();
    if (!path->empty() && leavesProject(*path)) {
        return Error{std::string{field.name}, format("the path {} leaves the project", foundText(json)),
                     "write a path below the project's folder with /, e.g. \"assets/player.png\""};
    }
    store(value, context.keepText(*path));
    return Done{};
}

Result<Done> readEntity(const FieldInfo& field, void* value, const Json& json, const FieldContext& context) {
    if (json.is_null()) return store(value, EntityId{}), Done{};
    const auto* text = json.get_ptr<const std::string*>();
    const std::optional<std::uint64_t> id = text != nullptr ? parseHex(*text) : std::nullopt;
    if (!id || *id == 0) {
        return expected(field, "the id of an entity", json,
                        "write its 16 hex digits in quotes, or null for no entity");
    }
    const EntityId entity = context.entity(*id);
    if (!entity) {
        return Error{std::string{field.name}, format("no entity has the id {}", foundText(json)),
                     "write the id of an entity of this file, or null for no entity"};
    }
    store(value, entity);
    return Done{};
}

Json entityToJson(const void* value, const FieldContext& context) {
    const std::uint64_t id = context.stableId(load<EntityId>(value));
    return id == 0 ? Json() : Json(hexText(id));
}

int loadEnum(const FieldInfo& field, const void* value) {
    return static_cast<int>(loadWhole(value, field.size, field.size != 1));
}

Json enumToJson(const FieldInfo& field, const void* value) {
    const int number = loadEnum(field, value);
    for (const EnumName& name : field.names) {
        if (name.value == number) return std::string{name.name};
    }
    return number;
}

Result<Done> readEnum(const FieldInfo& field, void* value, const Json& json) {
    std::vector<std::string_view> names;
    std::string list;
    const auto* text = json.get_ptr<const std::string*>();
    for (const EnumName& name : field.names) {
        if (text != nullptr && name.name == *text) {
            storeWhole(value, field.size, static_cast<std::uint64_t>(name.value));
            return Done{};
        }
        names.push_back(name.name);
        list += (list.empty() ? "" : ", ") + std::string{name.name};
    }
    const std::string_view near = text != nullptr ? closestName(*text, names) : std::string_view{};
    return expected(
        field, "one of " + list, json,
        near.empty() ? "write one of these names in quotes" : format("did you mean \"{}\"?", near));
}

// ---- lists

FieldInfo elementOf(const FieldInfo& field) {
    FieldInfo element = field;
    element.kind = field.element;
    element.size = field.elementSize;
    return element;
}

Json listToJson(const FieldInfo& field, const void* list, const FieldContext& context) {
    const FieldInfo element = elementOf(field);
    const std::size_t count = std::min<std::size_t>(field.countOf(list), field.capacity);
    Json json = Json::array();
    for (std::size_t i = 0; i < count; ++i) {
        json.push_back(valueToJson(element, static_cast<const char*>(list) + i * field.elementSize, context));
    }
    return json;
}

Result<Done> readList(const FieldInfo& field, void* list, const Json& json, FieldContext& context) {
    if (!json.is_array()) return expected(field, "a list", json, "write [] for an empty one");
    const FieldInfo element = elementOf(field);
    const std::size_t count = std::min(json.size(), field.capacity);
    std::vector<char> items(field.capacity * field.elementSize);
    for (std::size_t i = 0; i < count; ++i) {
        auto read = valueFromJson(element, items.data() + i * field.elementSize, json[i], context);
        if (!read) {
            Error error = read.error();
            error.where = format("{}[{}]", field.name, i);
            return error;
        }
    }
    if (count < json.size()) {
        context.warn({std::string{field.name},
                      format("{} items, the limit is {}", json.size(), field.capacity),
                      "the first ones are used; remove the others"});
    }
    std::memcpy(list, items.data(), items.size());
    field.countOf(list) = static_cast<std::uint32_t>(count);
    return Done{};
}

}  // namespace

std::string foundText(const Json& json) {
    constexpr std::size_t kShown = 40;  // bytes of a text
    switch (json.type()) {
        case Json::value_t::null: return "null";
        case Json::value_t::boolean: return json.get<bool>() ? "true" : "false";
        case Json::value_t::number_integer:
            return format("{}", static_cast<long long>(json.get<std::int64_t>()));
        case Json::value_t::number_unsigned:
            return format("{}", static_cast<unsigned long long>(json.get<std::uint64_t>()));
        case Json::value_t::number_float: return shortestText(json.get<double>());
        case Json::value_t::string: {
            const std::string& text = *json.get_ptr<const std::string*>();
            if (text.size() <= kShown) return format("\"{}\"", text);
            std::size_t end = kShown;
            while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
            return format("\"{}...\"", text.substr(0, end));
        }
        case Json::value_t::array: return format("a list of {}", json.size());
        case Json::value_t::object: return "an object";
        case Json::value_t::binary:
        case Json::value_t::discarded: break;
    }
    return "raw bytes";
}

Json valueToJson(const FieldInfo& field, const void* value, const FieldContext& context) {
    switch (field.kind) {
        case FieldKind::Bool: return *static_cast<const bool*>(value);
        case FieldKind::Int:
            return field.isSigned ? Json(loadWhole(value, field.size, true))
                                  : Json(static_cast<std::uint64_t>(loadWhole(value, field.size, false)));
        case FieldKind::Float: return double{load<float>(value)};
        case FieldKind::Vec2: return floatsToJson(value, 2);
        case FieldKind::Rect: return floatsToJson(value, 4);
        case FieldKind::Color: return colorText(load<Color>(value));
        case FieldKind::Text:
        case FieldKind::Asset: return std::string{context.text(load<TextId>(value))};
        case FieldKind::Enum: return enumToJson(field, value);
        case FieldKind::Entity: return entityToJson(value, context);
        case FieldKind::Tiles: return context.tilesToJson(load<TilesId>(value));
        case FieldKind::List:
            return isCurve(field) ? curveToJson(load<Curve>(value)) : listToJson(field, value, context);
    }
    return {};
}

Result<Done> valueFromJson(const FieldInfo& field, void* value, const Json& json, FieldContext& context) {
    switch (field.kind) {
        case FieldKind::Bool:
            if (!json.is_boolean())
                return expected(field, "true or false", json, "write true or false without quotes");
            *static_cast<bool*>(value) = json.get<bool>();
            return Done{};
        case FieldKind::Int: return readInt(field, value, json, context);
        case FieldKind::Float: return readFloat(field, value, json, context);
        case FieldKind::Vec2: return readFloats(field, value, json, 2);
        case FieldKind::Rect: return readFloats(field, value, json, 4);
        case FieldKind::Color: return readColor(field, value, json);
        case FieldKind::Text: {
            const Result<std::string_view> text = textFrom(field, json, "a string");
            if (!text) return text.error();
            store(value, context.keepText(*text));
            return Done{};
        }
        case FieldKind::Enum: return readEnum(field, value, json);
        case FieldKind::Entity: return readEntity(field, value, json, context);
        case FieldKind::Asset: return readAsset(field, value, json, context);
        case FieldKind::Tiles: {
            const Result<TilesId> tiles = context.tilesFromJson(field, json);
            if (!tiles) return tiles.error();
            store(value, *tiles);
            return Done{};
        }
        case FieldKind::List:
            return isCurve(field) ? readCurve(field, value, json, context)
                                  : readList(field, value, json, context);
    }
    return Done{};
}

Json fieldToJson(const FieldInfo& field, const void* object, const FieldContext& context) {
    return valueToJson(field, field.in(object), context);
}

Result<Done> fieldFromJson(const FieldInfo& field, void* object, const Json& json, FieldContext& context) {
    return valueFromJson(field, field.in(object), json, context);
}

}  // namespace plumb
