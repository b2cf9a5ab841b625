#include "reflect/json_fields.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/text.hpp"
#include "reflect/import_notes.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"

namespace plumb {
namespace {

const Json& emptyObject() {
    static const Json empty = Json::object();
    return empty;
}

}  // namespace

std::string briefText(const Json& json) {
    if (json.is_array()) return json.empty() ? "[]" : "[...]";
    if (json.is_object()) return json.empty() ? "{}" : "{...}";
    std::string text = writeJson(json);
    text.pop_back();  // the newline
    return text.size() <= 40 ? text : text.substr(0, 40) + "...";
}

JsonFields::JsonFields(const Json& object, std::string where, std::vector<Error>& problems)
    : object_{&object}, where_{std::move(where)}, problems_{&problems} {
    if (!object.is_object()) {
        problems.push_back({where_, "expected an object, found " + briefText(object), "write { ... }"});
        object_ = &emptyObject();
    }
}

const Json* JsonFields::find(std::string_view key) {
    asked_.push_back(key);
    return findMember(*object_, key);
}

std::string JsonFields::text(std::string_view key, std::string_view fallback) {
    const Json* json = find(key);
    if (json == nullptr) return std::string{fallback};
    if (const std::string* found = jsonText(*json)) return *found;
    warn(key, "expected a string, found " + briefText(*json), "put it in double quotes");
    return std::string{fallback};
}

bool JsonFields::flag(std::string_view key, bool fallback) {
    const Json* json = find(key);
    if (json == nullptr) return fallback;
    if (json->is_boolean()) return json->get<bool>();
    warn(key, "expected true or false, found " + briefText(*json), "write true or false");
    return fallback;
}

int JsonFields::whole(std::string_view key, int fallback, int min, int max) {
    const Json* json = find(key);
    if (json == nullptr) return fallback;
    const double value = json->is_number() ? json->get<double>() : std::nan("");
    if (value >= min && value <= max && value == std::floor(value)) return static_cast<int>(value);
    warn(key, format("expected a whole number from {} to {}, found {}", min, max, briefText(*json)),
         "correct it");
    return fallback;
}

float JsonFields::number(std::string_view key, float fallback, float min, float max) {
    const Json* json = find(key);
    if (json == nullptr) return fallback;
    if (const std::optional<float> value = floatOf(*json); value && *value >= min && *value <= max)
        return *value;
    warn(key, format("expected a number from {} to {}, found {}", min, max, briefText(*json)), "correct it");
    return fallback;
}

Vec2 JsonFields::vec2(std::string_view key, Vec2 fallback) {
    const Json* json = find(key);
    if (json == nullptr) return fallback;
    if (json->is_array() && json->size() == 2) {
        const std::optional<float> x = floatOf((*json)[0]);
        const std::optional<float> y = floatOf((*json)[1]);
        if (x && y) return {*x, *y};
    }
    warn(key, "expected two numbers, found " + briefText(*json), "write [x, y]");
    return fallback;
}

std::size_t JsonFields::choice(std::string_view key, std::size_t fallback,
                               std::span<const std::string_view> names) {
    const Json* json = find(key);
    if (json == nullptr) return fallback;
    const std::string word = stringOrEmpty(*json);
    if (const auto at = std::find(names.begin(), names.end(), word); at != names.end()) {
        return static_cast<std::size_t>(at - names.begin());
    }
    std::string known;
    for (const std::string_view name : names) known += (known.empty() ? "" : ", ") + std::string{name};
    warn(key, "unknown value " + briefText(*json), "write one of: " + known);
    return fallback;
}

const Json* JsonFields::array(std::string_view key) {
    const Json* json = find(key);
    if (json == nullptr || json->is_array()) return json;
    warn(key, "expected an array, found " + briefText(*json), "write [ ... ]");
    return nullptr;
}

std::vector<JsonFields> JsonFields::objects(std::string_view key, std::size_t limit) {
    std::vector<JsonFields> items;
    const Json* json = array(key);
    if (json == nullptr) return items;
    if (json->size() > limit)
        warn(key, format("{} items, the limit is {}", json->size(), limit), "remove some");
    for (const Json& item : *json) {
        if (items.size() == limit) break;
        items.emplace_back(item, format("{}.{}[{}]", where_, key, items.size()), *problems_);
    }
    return items;
}

bool JsonFields::acceptFormat(int newest) {
    const int stated = whole("format", newest, 1, 1'000'000);
    if (stated <= newest) return true;
    warn("format", format("the file has format {}, this program reads up to {}", stated, newest),
         "update the program");
    return false;
}

void JsonFields::warn(std::string_view key, std::string what, std::string remedy) {
    problems_->push_back({format("{}.{}", where_, key), std::move(what), std::move(remedy)});
}

std::vector<KeptProperty> JsonFields::keepUnknown() {
    std::vector<KeptProperty> unknown;
    for (const auto& [name, value] : *object_->get_ptr<const Json::object_t*>()) {
        if (std::find(asked_.begin(), asked_.end(), name) != asked_.end()) continue;
        const std::string_view meant = closestName(name, asked_);
        if (!isImportNote(name)) {
            warn(std::string_view{name}.substr(0, 80), "unknown property",
                 meant.empty() ? "remove it" : format("did you mean \"{}\"?", meant));
        }
        unknown.push_back({name, compactText(value)});
    }
    return unknown;
}

std::vector<KeptProperty> JsonFields::kept(std::string_view key) {
    std::vector<KeptProperty> properties;
    const Json* json = find(key);
    if (json == nullptr) return properties;
    if (!json->is_object()) {
        warn(key, "expected an object, found " + briefText(*json), "write { \"name\": value }");
        return properties;
    }
    for (const auto& [name, value] : *json->get_ptr<const Json::object_t*>()) {
        properties.push_back({name, compactText(value)});
    }
    return properties;
}

void writeKept(Json& object, const std::vector<KeptProperty>& properties) {
    for (const KeptProperty& property : properties) {
        const Result<Json> value = parseJson(property.json, property.name);
        object[property.name] = value ? *value : Json{};
    }
}

}  // namespace plumb
