#include "editor/model/safety/scene_differences.hpp"

#include <map>

#include "core/text.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"

namespace plumb::editor {
namespace {

constexpr std::size_t kLongestValue = 48;  // bytes: longer values are cut
constexpr std::size_t kIdEnd = 4;          // characters of an id shown to distinguish two instances

std::string shortText(const Json& value) {
    std::string text = compactText(value);
    if (text.size() <= kLongestValue) return text;
    text.resize(kLongestValue);
    while (!text.empty() && !isUtf8(text)) text.pop_back();
    return text + "...";
}

class Comparison {
public:
    std::vector<std::string> lines;

    void compare(const std::string& where, const Json& before, const Json& after) {
        if (before == after) return;
        if (!before.is_object() || !after.is_object()) {
            lines.push_back(format("{} was {}, is {}", where, shortText(before), shortText(after)));
            return;
        }
        for (const auto& [key, value] : before.items()) {
            const auto other = after.find(key);
            if (other != after.end()) {
                compare(join(where, key), value, *other);
            } else {
                lines.push_back(format("{} was {}, was removed", join(where, key), shortText(value)));
            }
        }
        for (const auto& [key, value] : after.items()) {
            if (!before.contains(key))
                lines.push_back(format("{} was added: {}", join(where, key), shortText(value)));
        }
    }

private:
    /// Appends a key to the path of a value, e.g. "crate: Transform.position": the entity's name, then the
    /// keys. The key "components" is omitted.
    static std::string join(const std::string& where, const std::string& key) {
        if (key == "components") return where;
        return where + (where.find(": ") == std::string::npos ? ": " : ".") + key;
    }
};

std::string nameOf(const Json& entity, const std::string& id) {
    if (const std::string* name = findText(entity, "name")) return *name;
    const std::string* prefab = findText(entity, "prefab");
    if (prefab == nullptr) return id;
    // An unnamed instance is shown with its prefab's name and the end of its id, as there may be several.
    const std::string file = prefab->substr(prefab->rfind('/') + 1);
    const std::string end = id.size() > kIdEnd ? id.substr(id.size() - kIdEnd) : id;
    return format("{} ({})", file.substr(0, file.find('.')), end);
}

std::map<std::string, Json> entitiesOf(Json& scene) {
    std::map<std::string, Json> found;
    Json* list = findArray(scene, "entities");
    if (list == nullptr) return found;
    for (Json& entity : *list) {
        const std::string* id = findText(entity, "id");
        if (id == nullptr) continue;
        std::string key = *id;
        found.emplace(std::move(key), std::move(entity));
    }
    scene.erase("entities");
    return found;
}

}  // namespace

std::vector<std::string> sceneDifferences(std::string_view before, std::string_view after, std::size_t most) {
    Result<Json> old = parseJson(before, "before");
    Result<Json> now = parseJson(after, "after");
    if (!old || !now || !old->is_object() || !now->is_object())
        return {"one of the two files is not a valid scene"};
    std::map<std::string, Json> oldEntities = entitiesOf(*old);
    std::map<std::string, Json> entities = entitiesOf(*now);
    Comparison comparison;
    for (const auto& [id, entity] : oldEntities) {
        if (!entities.contains(id)) comparison.lines.push_back(format("{} was removed", nameOf(entity, id)));
    }
    for (const auto& [id, entity] : entities) {
        const auto other = oldEntities.find(id);
        if (other == oldEntities.end()) {
            comparison.lines.push_back(format("{} was added", nameOf(entity, id)));
        } else {
            comparison.compare(nameOf(entity, id), other->second, entity);
        }
    }
    comparison.compare("scene", *old, *now);
    std::vector<std::string>& lines = comparison.lines;
    if (lines.empty()) lines.push_back("no differences, except perhaps the order of the entities");
    if (lines.size() > most) {
        const std::size_t more = lines.size() - most;
        lines.resize(most);
        lines.push_back(format("and {} more", more));
    }
    return lines;
}

}  // namespace plumb::editor
