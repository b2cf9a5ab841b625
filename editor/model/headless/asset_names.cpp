#include "editor/model/headless/asset_names.hpp"

#include "core/text.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"

namespace plumb::editor {
namespace {

std::string textIn(const Json& object, std::string_view key) {
    const std::string* text = findText(object, key);
    return text == nullptr ? std::string{} : *text;
}

/// Returns a member that is an object; an empty object if there is none.
const Json& objectIn(const Json& object, std::string_view key) {
    static const Json kNone = Json::object();
    const Json* found = findObject(object, key);
    return found == nullptr ? kNone : *found;
}

/// Returns the name and id of an entity: "crate (0000000000000004)".
std::string wordsFor(const Json& entity) {
    const std::string name = textIn(entity, "name");
    const std::string id = textIn(entity, "id");
    return name.empty() ? id.empty() ? std::string{"an entity"} : id : format("{} ({})", name, id);
}

}  // namespace

void AssetNames::read(const std::string& file, std::string_view text) {
    std::vector<Error> repeated;  // not used: opening the file reports them
    const Result<Json> json = parseJson(text, file, &repeated);
    const Json* entities = json ? findArray(*json, "entities") : nullptr;
    if (entities == nullptr) return;
    for (const Json& entity : *entities) {
        if (entity.is_object()) readEntity(file, entity, wordsFor(entity));
    }
}

/// Collects the references of an entity, including an instance's overrides of its prefab's parts.
void AssetNames::readEntity(const std::string& file, const Json& entity, const std::string& user) {
    for (const auto& [name, fields] : objectIn(entity, "components").items()) {
        const TypeInfo* type = types_.find(name);
        if (type == nullptr || !fields.is_object()) continue;
        for (const auto& [key, value] : fields.items()) {
            if (const FieldInfo* field = type->find(key))
                add(*field, value, format("{}: {}, {}.{}", file, user, name, key));
        }
    }
    for (const auto& [part, own] : objectIn(entity, "children").items()) {
        if (own.is_object()) readEntity(file, own, format("{}, its part {}", user, part));
    }
}

void AssetNames::add(const FieldInfo& field, const Json& value, const std::string& user) {
    if (field.kind == FieldKind::List && field.element == FieldKind::Asset && value.is_array()) {
        FieldInfo item = field;
        item.kind = FieldKind::Asset;
        for (const Json& one : value) add(item, one, user);
    }
    const std::string* path = jsonText(value);
    if (field.kind != FieldKind::Asset || path == nullptr || path->empty()) return;
    Named& named = named_[*path];
    named.kind = field.asset;
    named.by.push_back(user);
}

std::string AssetNames::usersOf(std::string_view path) const {
    const auto found = named_.find(path);
    if (found == named_.end()) return {};
    const std::vector<std::string>& by = found->second.by;
    return by.size() == 1 ? by.front() : format("{} and {} more", by.front(), by.size() - 1);
}

}  // namespace plumb::editor
