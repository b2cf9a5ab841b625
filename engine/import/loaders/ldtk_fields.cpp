#include "import/loaders/ldtk_fields.hpp"

#include <cmath>

#include "core/text.hpp"
#include "reflect/json_fields.hpp"
#include "reflect/json_members.hpp"

namespace plumb {
namespace {

constexpr double kLargest = 1e9;

bool isUsable(const Json& json) { return json.is_number() && std::abs(json.get<double>()) <= kLargest; }

}  // namespace

const Json* LdtkFields::find(std::string_view key) const {
    const Json* found = findMember(*object_, key);
    return found == nullptr || found->is_null() ? nullptr : found;
}

std::string LdtkFields::text(std::string_view key, std::string_view fallback) const {
    const Json* json = find(key);
    if (json == nullptr) return std::string{fallback};
    if (const std::string* found = jsonText(*json)) return *found;
    warn(key, "expected a string, found " + briefText(*json), "save the project again in LDtk");
    return std::string{fallback};
}

int LdtkFields::whole(std::string_view key, int fallback) const {
    return static_cast<int>(std::lround(real(key, fallback)));
}

double LdtkFields::real(std::string_view key, double fallback) const {
    const Json* json = find(key);
    if (json == nullptr) return fallback;
    if (isUsable(*json)) return json->get<double>();
    warn(key, "expected a number between -1e9 and 1e9, found " + briefText(*json),
         "save the project again in LDtk");
    return fallback;
}

bool LdtkFields::flag(std::string_view key, bool fallback) const {
    const Json* json = find(key);
    if (json == nullptr) return fallback;
    if (json->is_boolean()) return json->get<bool>();
    warn(key, "expected true or false, found " + briefText(*json), "save the project again in LDtk");
    return fallback;
}

Color LdtkFields::color(std::string_view key, Color fallback) const {
    const std::string text = this->text(key);
    if (text.empty()) return fallback;
    const auto bits = startsWith(text, "#") ? parseHex(std::string_view{text}.substr(1)) : std::nullopt;
    if (!bits || text.size() != 7) {
        warn(key, format("expected a color, found \"{}\"", text.substr(0, 20)), "write it as #rrggbb");
        return fallback;
    }
    const auto part = [&](int shift) { return static_cast<std::uint8_t>(*bits >> shift & 255); };
    return {part(16), part(8), part(0), 255};
}

Vec2 LdtkFields::pair(std::string_view key, Vec2 fallback) const {
    const Json* json = find(key);
    if (json == nullptr) return fallback;
    if (json->is_array() && json->size() == 2 && isUsable((*json)[0]) && isUsable((*json)[1]))
        return {(*json)[0].get<float>(), (*json)[1].get<float>()};
    warn(key, "expected two numbers, found " + briefText(*json), "save the project again in LDtk");
    return fallback;
}

std::vector<LdtkFields> LdtkFields::objects(std::string_view key) const {
    std::vector<LdtkFields> items;
    const Json* json = find(key);
    if (json == nullptr) return items;
    if (!json->is_array()) {
        warn(key, "expected an array, found " + briefText(*json), "save the project again in LDtk");
        return items;
    }
    items.reserve(json->size());
    for (const Json& item : *json)
        items.emplace_back(item, format("{}.{}[{}]", where_, key, items.size()), *problems_);
    return items;
}

void LdtkFields::warn(std::string_view key, std::string what, std::string remedy) const {
    problems_->push_back({format("{}.{}", where_, key), std::move(what), std::move(remedy)});
}

}  // namespace plumb
