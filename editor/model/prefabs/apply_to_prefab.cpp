// applyToPrefab of prefab_edit.hpp: writes the overrides of an instance into the text of its prefab's file.

#include <algorithm>

#include "core/text.hpp"
#include "editor/model/commands/write_prefab.hpp"
#include "editor/model/prefabs/prefab_edit.hpp"
#include "reflect/component_json.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/files/world_field_context.hpp"

namespace plumb::editor {
namespace {

constexpr std::uint64_t kOutside = ~0ull;  // placeholder id of entities outside the prefab

/// The JSON of a prefab's file while overrides are merged into it.
class PrefabText {
public:
    PrefabText(Document& document, PrefabLibrary& prefabs, Json file)
        : document_{document}, prefabs_{prefabs}, file_(std::move(file)) {  // braces would create an array
        if (const std::uint64_t id = hexIdIn(root(), "id")) rootId_ = id;
    }

    /// Merges the overrides of one entity into the file. @return number of merged values
    std::size_t take(const InstancePart& part, const PrefabScope& scope) {
        std::size_t taken = 0;
        for (const TypeInfo& type : document_.types().all()) {
            if (!canOverride(type) || (scope.type != nullptr && scope.type != &type)) continue;
            taken += takeComponent(part, type, scope.field);
        }
        return taken;
    }
    [[nodiscard]] std::string text() const { return writeJson(file_); }

private:
    std::size_t takeComponent(const InstancePart& part, const TypeInfo& type, std::string_view only) {
        const bool here = document_.world.has(type, document_.find(part.id()));
        const bool there = part.prefabHas(type);
        if (!here && !there) return 0;
        const std::string name{type.name};
        if (!here) {
            if (!only.empty()) return 0;
            erase(placeOf(part), name);
            return 1;
        }
        Json fields = there ? part.differences(type) : ownFields(part, type);
        if (!only.empty()) {
            const auto found = fields.find(std::string{only});
            if (found == fields.end()) return 0;
            const Json value = *found;
            fields = Json::object();
            fields[std::string{only}] = value;
        }
        localize(part, type, fields);
        if (there && fields.empty()) return 0;
        merge(placeOf(part), type, fields);
        return std::max<std::size_t>(fields.size(), 1);
    }

    /// Returns the JSON of a component that the prefab does not have.
    [[nodiscard]] Json ownFields(const InstancePart& part, const TypeInfo& type) const {
        const void* object = std::as_const(document_.world).find(type, document_.find(part.id()));
        if (type.size == 0) return Json::object();
        const ComponentState fresh = defaultComponent(type);
        return componentToJson(type, object, fresh.bytes.data(), WorldFieldContext{document_.world});
    }

    /// Converts references to entities of the instance to part ids of the prefab; removes fields with
    /// references to other entities.
    void localize(const InstancePart& part, const TypeInfo& type, Json& fields) const {
        const auto partId = [&](std::uint64_t id) {
            for (const PrefabEntity& entity : part.prefab().entities) {
                if (combinedId(part.root().value, entity.part) != id) continue;
                return entity.part == Prefab::kRootPart ? rootId_ : entity.part;
            }
            return kOutside;
        };
        Json components = Json::object();
        components[std::string{type.name}] = std::move(fields);
        changeReferences(document_.types(), components, partId);
        fields = Json::object();
        for (const auto& [key, value] : components.begin()->items()) {
            if (compactText(value).find(hexText(kOutside)) == std::string::npos) fields[key] = value;
        }
    }

    /// Returns the JSON object for an entity: the entity itself, or its overrides below a nested prefab
    /// instance.
    Json& placeOf(const InstancePart& part) {
        const std::uint64_t wanted = part.base().part;
        for (Json& entity : file_["entities"]) {
            if (!entity.is_object()) continue;
            const std::uint64_t id = &entity == &root() ? Prefab::kRootPart : hexIdIn(entity, "id");
            if (id == wanted) return entity;
            const std::string* inner = findText(entity, "prefab");
            if (inner == nullptr) continue;
            const Result<const Prefab*> nested = prefabs_.find(*inner);
            if (!nested) continue;
            for (const PrefabEntity& below : (*nested)->entities) {
                if (combinedId(id, below.part) == wanted)
                    return makeObject(makeObject(entity, "children"), hexText(below.part));
            }
        }
        return root();
    }

    /// Returns the first valid entity; the prefab reader skips array elements that are not objects, too.
    Json& root() {
        Json& entities = file_["entities"];
        return *std::find_if(entities.begin(), entities.end(),
                             [](const Json& one) { return one.is_object(); });
    }

    /// True if the entity belongs to this file alone; false for an instance of a nested prefab, or a part of
    /// one.
    [[nodiscard]] static bool isPlain(const Json& entity) {
        return entity.contains("id") && !entity.contains("prefab");
    }

    static void erase(Json& entity, const std::string& type) {
        if (Json* components = findObject(entity, "components")) components->erase(type);
        if (isPlain(entity)) return;
        Json& without = entity["without"];
        if (!without.is_array()) without = Json::array();
        without.push_back(type);
    }

    void merge(Json& entity, const TypeInfo& type, const Json& fields) const {
        Json& components = makeObject(entity, "components");
        const bool fresh = !components.contains(std::string{type.name});
        Json& there = makeObject(components, type.name);
        // Existing keys keep their order, so that the diff of the file stays small.
        const std::size_t before = there.size();
        for (const auto& [key, value] : fields.items()) {
            there[key] = value;
        }
        if (isPlain(entity)) dropDefaults(type, fields, there);
        if (there.size() > before) there = ordered(there, type);
        if (fresh) components = ordered(components);
        if (Json* without = findArray(entity, "without")) {
            for (std::size_t i = without->size(); i-- > 0;) {
                if ((*without)[i] == type.name) without->erase(i);
            }
            if (without->empty()) entity.erase("without");
        }
    }

    /// Removes applied values that equal the default. Valid only for entities without a nested prefab's
    /// values.
    void dropDefaults(const TypeInfo& type, const Json& applied, Json& fields) const {
        if (type.size == 0) return;
        const ComponentState fresh = defaultComponent(type);
        const WorldFieldContext context{document_.world};
        for (const FieldInfo& field : type.fields) {
            const auto found = applied.find(std::string{field.name});
            if (found != applied.end() && *found == fieldToJson(field, fresh.bytes.data(), context))
                fields.erase(std::string{field.name});
        }
    }

    /// Returns the fields in the order in which files are written; unknown keys at the end.
    static Json ordered(const Json& fields, const TypeInfo& type) {
        Json made = Json::object();
        for (const FieldInfo& field : type.fields) {
            if (const auto found = fields.find(std::string{field.name}); found != fields.end())
                made[std::string{field.name}] = *found;
        }
        for (const auto& [key, value] : fields.items()) {
            made[key] = value;
        }
        return made;
    }
    /// Returns the components in the order in which files are written; unknown keys at the end.
    [[nodiscard]] Json ordered(const Json& components) const {
        Json made = Json::object();
        for (const TypeInfo& type : document_.types().all()) {
            if (const auto found = components.find(std::string{type.name}); found != components.end())
                made[std::string{type.name}] = *found;
        }
        for (const auto& [key, value] : components.items()) {
            made[key] = value;
        }
        return made;
    }

    Document& document_;
    PrefabLibrary& prefabs_;
    Json file_;
    std::uint64_t rootId_ = Prefab::kRootPart;
};

/// Computes the change of one component of an instance when its prefab changes: overridden values stay, all
/// others follow the prefab. @return nothing if the component does not change
std::optional<WritePrefab::Change> followed(Document& document, const InstancePart& before,
                                            const InstancePart& after, const TypeInfo& type) {
    const EntityId entity = document.find(before.id());
    const bool here = document.world.has(type, entity);
    if (!before.prefabHas(type)) {
        if (here || !after.prefabHas(type)) return std::nullopt;
        return WritePrefab::Change{before.id(), &type, after.baseOf(type)};
    }
    if (!here) return std::nullopt;
    const Json own = before.differences(type);
    if (!after.prefabHas(type)) {
        if (!own.empty()) return std::nullopt;
        return WritePrefab::Change{before.id(), &type, std::nullopt};
    }
    if (before.base().components[std::string{type.name}] == after.base().components[std::string{type.name}])
        return std::nullopt;
    const ComponentState base = after.baseOf(type);
    ComponentState state = readComponent(document, type, entity);
    for (const FieldInfo& field : type.fields) {
        const bool keeps = field.transient || own.contains(std::string{field.name}) ||
                           (before.isRoot() && isInstancePose(type, field.name));
        if (keeps) continue;
        std::memcpy(field.in(static_cast<void*>(state.bytes.data())),
                    field.in(static_cast<const void*>(base.bytes.data())), field.size);
    }
    return WritePrefab::Change{before.id(), &type, std::move(state)};
}

/// Computes the changes of all instances in the document when the prefabs of `now` are replaced by those of
/// `next`.
std::vector<WritePrefab::Change> changesOf(Document& document, PrefabLibrary& now, PrefabLibrary& next) {
    std::vector<WritePrefab::Change> changes;
    for (const ObjectId id : document.objects()) {
        const auto before = InstancePart::of(document, &now, id);
        if (!before) continue;
        const Result<const Prefab*> prefab = next.find(before->prefab().path);
        const auto after = prefab ? before->besides(**prefab) : std::nullopt;
        if (!after) continue;
        for (const TypeInfo& type : document.types().all()) {
            if (!canOverride(type)) continue;
            if (auto change = followed(document, *before, *after, type))
                changes.push_back(std::move(*change));
        }
    }
    return changes;
}

}  // namespace

Result<Done> applyToPrefab(const PrefabEdit& edit, ObjectId id, const PrefabScope& scope) {
    const auto part = InstancePart::of(edit.document, edit.prefabs, id);
    if (!part) return Error{"apply", "this entity is not part of a prefab instance", "select one that is"};
    const std::string path = part->prefab().path;
    const Result<Path> file = pathInside(edit.root, path);
    if (!file) return file.error();
    const Result<std::string> text = readFile(*file);
    if (!text) return text.error();
    Result<Json> json = parseJson(*text, path);
    if (!json) return json.error();
    const Json* entities = findArray(*json, "entities");
    if (entities == nullptr || std::none_of(entities->begin(), entities->end(),
                                            [](const Json& entity) { return entity.is_object(); }))
        return Error{path, "the file contains no entities, so it is not a prefab", "restore the file"};

    PrefabText made{edit.document, *edit.prefabs, *std::move(json)};
    std::size_t taken = 0;
    for (const ObjectId member : scope.type == nullptr ? part->all() : std::vector{id}) {
        if (const auto inner = InstancePart::of(edit.document, edit.prefabs, member))
            taken += made.take(*inner, scope);
    }
    if (taken == 0)
        return Error{path, "the instance does not differ from its prefab", "change the instance first"};

    PrefabLibrary next{edit.document.types(), edit.root};
    next.add(path, made.text());
    if (const Result<const Prefab*> read = next.find(path); !read) return read.error();
    std::vector<WritePrefab::Change> changes = changesOf(edit.document, *edit.prefabs, next);
    if (const Result<Done> tried = writeFile(*file, *text); !tried) return tried.error();
    edit.undo.push(std::make_unique<WritePrefab>(format("apply to {}", path), *edit.prefabs, *file,
                                                 made.text(), std::move(changes)));
    edit.undo.endGesture();
    return Done{};
}

}  // namespace plumb::editor
