#include "import/loaders/tiled_classes.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "reflect/json_fields.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"

namespace plumb {
namespace {

constexpr int kFoldersAround = 4;
constexpr int kClassDepth = 8;  // maximum depth of classes that are members of classes
constexpr std::size_t kMaxTypes = 4096;
constexpr std::size_t kMaxFilled = std::size_t{1} << 18;  // added to a map, as weightOf() counts

/// Converts a class member to the form of map properties.
Json memberValue(JsonFields& member) {
    const std::string type = member.text("type", "string");
    const std::string named = member.text("propertyType");
    const Json* found = member.find("value");
    Json value = found == nullptr ? Json{} : *found;
    const bool plain = type == "string" || type == "bool" || type == "int" || type == "float";
    if (plain && named.empty()) return value;
    Json typed = Json::object();
    typed["type"] = type;
    if (!named.empty()) typed["class"] = named;
    typed["value"] = std::move(value);
    return typed;
}

/// Returns the approximate size of a value, in numbers.
std::size_t weightOf(const Json& value) {
    std::size_t weight = 1;
    if (const std::string* text = jsonText(value)) weight += text->size() / 16;
    if (!value.is_structured()) return weight;
    for (const Json& inner : value) weight += weightOf(inner);
    return weight;
}

/// Adds missing properties. Limits the nesting depth, since classes can contain themselves, and the total
/// size of the added values.
class ClassFiller {
public:
    explicit ClassFiller(const TiledClasses& classes) : classes_{classes} {}

    void fill(Json& properties, std::string_view name, int depth = 0) {
        if (depth > kClassDepth || !properties.is_object()) return;
        if (const auto known = classes_.find(name); known != classes_.end()) {
            for (const auto& [key, value] : known->second.items()) add(properties, key, value);
        }
        for (Json& property : properties) {
            const std::string* type = findText(property, "type");
            const std::string* inner = findText(property, "class");
            if (type == nullptr || inner == nullptr || *type != "class" || room_ == 0) continue;
            fill(makeObject(property, "value"), std::string{*inner}, depth + 1);
        }
    }

private:
    void add(Json& properties, const std::string& key, const Json& value) {
        if (room_ == 0 || properties.contains(key)) return;
        room_ -= std::min(room_, weightOf(value));
        properties[key] = value;
    }

    const TiledClasses& classes_;
    std::size_t room_ = kMaxFilled;
};

}  // namespace

TiledClasses readTiledClasses(std::string_view text, std::string_view where, std::vector<Error>& warnings) {
    TiledClasses classes;
    const Result<Json> json = parseJson(text, where, &warnings);
    if (!json) {
        warnings.push_back(json.error());
        return classes;
    }
    JsonFields fields{*json, std::string{where}, warnings};
    for (JsonFields& item : fields.objects("propertyTypes", kMaxTypes)) {
        if (item.text("type") != "class") continue;  // enums have no default values
        Json members = Json::object();
        for (JsonFields& member : item.objects("members", kMaxTypes)) {
            const std::string name = member.text("name");
            if (!name.empty()) members[name] = memberValue(member);
        }
        classes[item.text("name")] = std::move(members);
    }
    return classes;
}

TiledClasses tiledClassesAround(const Path& map, std::vector<Error>& warnings) {
    std::error_code failed;
    Path folder = std::filesystem::absolute(map, failed).parent_path();
    for (int i = 0; i < kFoldersAround; ++i, folder = folder.parent_path()) {
        std::vector<Path> found;
        std::filesystem::directory_iterator at{folder, failed};
        for (; !failed && at != std::filesystem::directory_iterator{}; at.increment(failed)) {
            if (at->path().extension() == ".tiled-project") found.push_back(at->path());
        }
        if (found.empty()) continue;
        const Path& file = *std::min_element(found.begin(), found.end());
        const Result<std::string> text = readFile(file);
        if (text) return readTiledClasses(*text, file.filename().string(), warnings);
        warnings.push_back(text.error());
        break;
    }
    return {};
}

void applyClasses(tiled::Map& map, const TiledClasses& classes) {
    ClassFiller filler{classes};
    const auto fill = [&filler](Json& properties, const std::string& type) { filler.fill(properties, type); };
    fill(map.properties, map.type);
    for (tiled::Group& group : map.groups) fill(group.properties, group.type);
    for (tiled::Layer& layer : map.layers) {
        fill(layer.properties, layer.type);
        for (tiled::Object& object : layer.objects) fill(object.properties, object.type);
    }
    for (tiled::Tileset& tileset : map.tilesets) {
        fill(tileset.properties, tileset.type);
        for (tiled::Tile& tile : tileset.tiles) {
            fill(tile.properties, tile.type);
            for (tiled::Object& object : tile.collision) fill(object.properties, object.type);
        }
    }
}

}  // namespace plumb
