#include "reflect/json_members.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/text.hpp"
#include "reflect/json.hpp"

namespace plumb {

const Json* findMember(const Json& json, std::string_view key) {
    const auto* members = json.get_ptr<const Json::object_t*>();
    if (members == nullptr) return nullptr;
    for (const auto& [name, value] : *members) {
        if (name == key) return &value;
    }
    return nullptr;
}

Json* findMember(Json& json, std::string_view key) {
    return const_cast<Json*>(findMember(std::as_const(json), key));
}

const Json* findObject(const Json& json, std::string_view key) {
    const Json* member = findMember(json, key);
    return member != nullptr && member->is_object() ? member : nullptr;
}

Json* findObject(Json& json, std::string_view key) {
    return const_cast<Json*>(findObject(std::as_const(json), key));
}

const Json* findArray(const Json& json, std::string_view key) {
    const Json* member = findMember(json, key);
    return member != nullptr && member->is_array() ? member : nullptr;
}

Json* findArray(Json& json, std::string_view key) {
    return const_cast<Json*>(findArray(std::as_const(json), key));
}

const std::string* findText(const Json& json, std::string_view key) {
    const Json* member = findMember(json, key);
    return member == nullptr ? nullptr : jsonText(*member);
}

const std::string* jsonText(const Json& json) { return json.get_ptr<const std::string*>(); }

std::string stringOrEmpty(const Json& json) {
    const std::string* text = jsonText(json);
    return text == nullptr ? std::string{} : *text;
}

std::optional<float> floatOf(const Json& json) {
    if (!json.is_number()) return std::nullopt;
    const auto value = json.get<double>();
    if (!(std::abs(value) <= double{std::numeric_limits<float>::max()})) return std::nullopt;
    return static_cast<float>(value);
}

std::optional<int> intOf(const Json& json) {
    if (!json.is_number()) return std::nullopt;
    const auto value = json.get<double>();
    const bool inRange =
        value >= double{std::numeric_limits<int>::min()} && value <= double{std::numeric_limits<int>::max()};
    if (!inRange || value != std::floor(value)) return std::nullopt;
    return static_cast<int>(value);
}

std::uint64_t hexIdOf(const Json& json) {
    const std::string* text = jsonText(json);
    return text == nullptr ? 0 : parseHex(*text).value_or(0);
}

std::uint64_t hexIdIn(const Json& json, std::string_view key) {
    const Json* member = findMember(json, key);
    return member == nullptr ? 0 : hexIdOf(*member);
}

Json& makeObject(Json& json, std::string_view key) {
    if (!json.is_object()) json = Json::object();
    Json& member = json[std::string{key}];
    if (!member.is_object()) member = Json::object();
    return member;
}

std::string compactText(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace plumb
