#include "scene/files/prefab_check.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "core/text.hpp"
#include "reflect/component_json.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/type_registry.hpp"
#include "scene/files/entity_keys.hpp"
#include "scene/files/prefab.hpp"
#include "scene/files/world_field_context.hpp"

namespace plumb {
namespace {

enum class EntityKind : std::uint8_t {
    Entity,
    Instance,  ///< of a nested prefab
    Part       ///< overrides of a part of an instance
};

std::vector<std::string_view> keysOf(EntityKind kind) {
    switch (kind) {
        case EntityKind::Entity: return {"id", "parent", "name", "prefab", "components"};
        case EntityKind::Instance:
            return {"id", "parent", "name", "prefab", "without", "components", "children"};
        case EntityKind::Part: return {"name", "without", "components", "removed"};
    }
    return {};
}

/// Accepts references to the entities of a prefab; its world only holds the texts and tiles that are read.
class PartNames final : public WorldFieldContext {
public:
    PartNames(World& world, const Prefab& prefab, std::uint64_t rootId)
        : WorldFieldContext{world}, prefab_{prefab}, rootId_{rootId}, part_{world.createEntity().id()} {}

    [[nodiscard]] EntityId entity(std::uint64_t id) const override {
        return id == rootId_ || prefab_.find(id) != nullptr ? part_ : EntityId{};
    }
    /// The entity that stands for all parts.
    [[nodiscard]] EntityId part() const { return part_; }

private:
    const Prefab& prefab_;
    std::uint64_t rootId_;
    EntityId part_;
};

class PrefabCheck {
public:
    PrefabCheck(const TypeRegistry& types, const Prefab& prefab, std::uint64_t rootId)
        : types_{types}, prefab_{prefab}, world_{types}, fields_{world_, prefab, rootId} {}

    std::vector<Error> problems;

    /// @param where  place in the file: "entities[2]"
    /// @param nested  the prefab of which it is an instance, or null
    void entity(const Json& json, const std::string& where, const Prefab* nested, bool isRoot) {
        keys(json, where, nested == nullptr ? EntityKind::Entity : EntityKind::Instance);
        if (const Json* path = findMember(json, "prefab"); path != nullptr && nested == nullptr)
            expected(where + ".prefab", "the path of a prefab", *path,
                     "write e.g. \"prefabs/coin.prefab.json\"");
        const Json* parent = findMember(json, "parent");
        if (parent != nullptr && !isRoot && hexIdOf(*parent) == 0)
            expected(where + ".parent", "16 hex digits", *parent,
                     "write the id of an earlier entity of this file; its parent is the root now");
        const Json* children = nested == nullptr ? nullptr : findObject(json, "children");
        if (children == nullptr) return;
        for (const auto& [key, overrides] : children->items())
            part(overrides, key, format("{}.children.{}", where, key), *nested);
    }

    void unknownKeys(const Json& json, std::string_view prefix, std::string_view of,
                     const std::vector<std::string_view>& known) {
        for (const auto& [key, value] : *json.get_ptr<const Json::object_t*>()) {
            if (std::find(known.begin(), known.end(), key) != known.end() || isEntityNote(key)) continue;
            const std::string_view near = closestName(key, known);
            report(format("{}{}", prefix, key), format("{} has no such key", of),
                   near.empty() ? "it is kept unchanged; check the spelling or remove it"
                                : format("it is kept unchanged; did you mean \"{}\"?", near));
        }
    }

private:
    void report(std::string_view where, std::string what, std::string remedy) {
        problems.push_back({format("{}: {}", prefab_.path, where), std::move(what), std::move(remedy)});
    }
    void expected(std::string_view where, std::string_view what, const Json& found, std::string remedy) {
        report(where, format("expected {}, found {}", what, foundText(found)), std::move(remedy));
    }

    void part(const Json& overrides, const std::string& key, const std::string& where, const Prefab& nested) {
        const std::uint64_t id = parseHex(key).value_or(0);
        if (id <= Prefab::kRootPart || nested.find(id) == nullptr)
            return report(where, "the prefab has no such part", "it is kept unchanged; remove it");
        if (key != hexText(id))
            return report(where, "the id of a part has 16 digits", format("write \"{}\"", hexText(id)));
        if (overrides.is_object()) keys(overrides, where, EntityKind::Part);
    }

    void keys(const Json& json, const std::string& where, EntityKind kind) {
        unknownKeys(json, where + ".", kind == EntityKind::Part ? "an override" : "an entity", keysOf(kind));
        if (const Json* name = findMember(json, "name"); name != nullptr && !name->is_string())
            expected(where + ".name", "a string", *name, "write it in double quotes");
        if (const Json* list = findMember(json, "without"); list != nullptr && kind != EntityKind::Entity)
            without(*list, where + ".without");
        const Json* components = findMember(json, "components");
        if (components == nullptr) return;
        if (!components->is_object())
            return expected(where + ".components", "an object", *components, "write {} for none");
        for (const auto& [name, fields] : *components->get_ptr<const Json::object_t*>())
            component(name, fields, where + ".");
    }

    void without(const Json& list, const std::string& where) {
        if (!list.is_array()) return expected(where, "a list", list, "write e.g. [\"Sprite\"]");
        for (const Json& item : list) {
            const std::string* name = jsonText(item);
            if (name == nullptr || types_.find(*name) == nullptr)
                report(where, format("{} is not a component", foundText(item)), "remove it from the list");
        }
    }

    void component(const std::string& name, const Json& json, const std::string& where) {
        const TypeInfo* type = componentOfFiles(types_, name);
        if (type == nullptr) {
            Error error = unknownComponent(types_, where + name, name);
            return report(error.where, std::move(error.what), std::move(error.remedy));
        }
        std::vector<FieldProblem> found;
        componentFromJson(*type, world_.add(*type, fields_.part()), json, fields_, found);
        for (FieldProblem& problem : found) {
            Error& error = problem.error;
            report(where + error.where, std::move(error.what), std::move(error.remedy));
        }
        for (Error& warning : fields_.warnings)
            report(format("{}{}.{}", where, type->name, warning.where), std::move(warning.what),
                   std::move(warning.remedy));
        fields_.warnings.clear();
    }

    const TypeRegistry& types_;
    const Prefab& prefab_;
    World world_;
    PartNames fields_;
};

}  // namespace

std::vector<Error> checkPrefab(const TypeRegistry& types, const Prefab& prefab, const Json& file,
                               const std::vector<const Prefab*>& nested, std::uint64_t rootId) {
    PrefabCheck check{types, prefab, rootId};
    // The editor shows a prefab as a scene, whose keys it keeps in the file.
    check.unknownKeys(file, "", "a prefab", {"format", "entities", "effects", "layers", "background"});
    const Json* entities = findArray(file, "entities");
    for (std::size_t i = 0; entities != nullptr && i < entities->size(); ++i) {
        const Json& entity = (*entities)[i];
        if (entity.is_object()) check.entity(entity, format("entities[{}]", i), nested[i], i == 0);
    }
    return std::move(check.problems);
}

}  // namespace plumb
