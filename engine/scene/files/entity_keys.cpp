#include "scene/files/entity_keys.hpp"

#include <utility>
#include <vector>

#include "core/text.hpp"
#include "reflect/import_notes.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/name.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/scene_entity.hpp"

namespace plumb {

bool isEntityNote(std::string_view key) { return key == "properties" || isImportNote(key); }

const TypeInfo* componentOfFiles(const TypeRegistry& types, std::string_view name) {
    const TypeInfo* type = types.find(name);
    const bool ownKey =
        type != nullptr && (type->key == typeKey<SceneEntity>() || type->key == typeKey<Name>() ||
                            type->key == typeKey<PrefabInstance>() || type->key == typeKey<PrefabPart>());
    return ownKey ? nullptr : type;
}

Error unknownComponent(const TypeRegistry& types, std::string where, std::string_view name) {
    std::vector<std::string_view> names = types.names();
    std::erase_if(names, [&](std::string_view known) { return componentOfFiles(types, known) == nullptr; });
    const std::string_view near = closestName(name, names);
    return {std::move(where), format("there is no component \"{}\"", name),
            "it is kept unchanged; " +
                (near.empty() ? "check the spelling" : format("did you mean \"{}\"?", near))};
}

}  // namespace plumb
