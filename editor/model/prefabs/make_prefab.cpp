#include "editor/model/prefabs/make_prefab.hpp"

#include <algorithm>
#include <map>

#include "core/hash.hpp"
#include "core/text.hpp"
#include "editor/model/commands/become_instance.hpp"
#include "editor/model/commands/write_asset.hpp"
#include "editor/model/document/prefab_root.hpp"
#include "editor/model/tree_edit.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/files/scene_file.hpp"

namespace plumb::editor {
namespace {

constexpr std::uint64_t kOutside = ~0ull;  // placeholder id of entities outside the prefab

/// Converts an entity of a scene, with its descendants, to the text of a prefab file.
class PrefabMaker {
public:
    PrefabMaker(PrefabEdit edit, ObjectId root) : edit_{std::move(edit)}, root_{root} {
        for (const ObjectId id : withDescendants(edit.document, {root})) {
            if (id != root) parts_[id] = partOf(id);
        }
    }

    [[nodiscard]] const std::map<ObjectId, std::uint64_t>& parts() const { return parts_; }

    /// @error the text of the scene is not valid JSON
    [[nodiscard]] Result<std::string> text() const {
        const Document& document = edit_.document;
        const SceneContext context{document.types(), edit_.prefabs, edit_.root};
        const Result<Json> scene = parseJson(sceneToJson(document.world, context, document.scene), "scene");
        if (!scene) return scene.error();
        std::map<std::uint64_t, const Json*> known;
        if (const Json* all = findArray(*scene, "entities")) {
            for (const Json& entity : *all) known[hexIdIn(entity, "id")] = &entity;
        }
        Json entities = Json::array();
        for (const ObjectId id : withDescendants(document, {root_})) {
            if (const auto found = known.find(id.value); found != known.end())
                entities.push_back(entity(*found->second, id));
        }
        Json whole = Json::object();
        whole["format"] = Prefab::kFormat;
        whole["entities"] = std::move(entities);
        return writeJson(whole);
    }

private:
    /// Returns the part id of an entity in the prefab. Parts of nested instances keep their scene ids.
    [[nodiscard]] std::uint64_t partOf(ObjectId id) const {
        const PrefabPart* part = edit_.document.world.find<PrefabPart>(edit_.document.find(id));
        if (part != nullptr && part->instance == root_.value) return part->part;
        return id.value == Prefab::kRootPart ? mixBits(root_.value) | 2u : id.value;
    }

    [[nodiscard]] std::uint64_t idInPrefab(std::uint64_t id) const {
        if (id == root_.value) return Prefab::kRootPart;
        const auto part = parts_.find({id});
        return part == parts_.end() ? kOutside : part->second;
    }

    [[nodiscard]] Json entity(Json json, ObjectId id) const {
        json["id"] = hexText(idInPrefab(id.value));
        if (id == root_) {
            json.erase("parent");
        } else if (findText(json, "parent") != nullptr) {
            json["parent"] = hexText(idInPrefab(hexIdIn(json, "parent")));
        }
        localize(json);
        if (Json* children = findObject(json, "children")) {
            for (auto& [part, overrides] : children->items()) localize(overrides);
        }
        // Position and rotation of the root belong to each instance, not to the prefab.
        Json* components = findObject(json, "components");
        Json* transform = components == nullptr ? nullptr : findObject(*components, "Transform");
        if (id != root_ || transform == nullptr) return json;
        transform->erase("position");
        transform->erase("rotation");
        if (transform->empty() && json.contains("prefab")) components->erase("Transform");
        return json;
    }

    /// Removes fields with references to entities outside the prefab.
    void localize(Json& entity) const {
        Json* components = findObject(entity, "components");
        if (components == nullptr) return;
        changeReferences(edit_.document.types(), *components,
                         [this](std::uint64_t id) { return idInPrefab(id); });
        const std::string outside = hexText(kOutside);
        for (auto& [type, fields] : components->items()) {
            if (!fields.is_object()) continue;
            Json kept = Json::object();
            for (const auto& [key, value] : fields.items()) {
                if (compactText(value).find(outside) == std::string::npos) kept[key] = value;
            }
            fields = std::move(kept);
        }
    }

    PrefabEdit edit_;
    ObjectId root_;
    std::map<ObjectId, std::uint64_t> parts_;
};

Result<Done> canMake(Workspace& workspace, const std::vector<ObjectId>& objects, const std::string& path) {
    const Document& document = workspace.document;
    if (workspace.prefabs().prefabs == nullptr)
        return Error{path, "prefabs need a project, and none is open", "open a project"};
    const Result<Path> file = pathInside(workspace.project.root, path);
    if (!file) return file.error();
    std::error_code failed;
    if (path == prefabPath("")) return Error{path, "a prefab needs a name", "write a word, e.g. \"door\""};
    if (std::filesystem::exists(*file, failed))
        return Error{path, "a prefab of this name already exists", "choose another name"};
    if (objects.empty()) return Error{path, "nothing is selected", "select the entities of the new prefab"};
    for (const ObjectId id : outermost(document, objects)) {
        if (id == prefabRootOf(document))
            return Error{document.nameOf(id), "this is the root of the prefab being edited",
                         "select entities below it"};
        if (document.world.has<PrefabPart>(document.find(id)))
            return Error{document.nameOf(id), "this entity is part of another prefab's instance",
                         "select the whole instance"};
    }
    return Done{};
}

/// Makes the prefab. On error, the transaction undoes all changes.
Result<ObjectId> make(Workspace& workspace, const std::vector<ObjectId>& members, const std::string& path) {
    Document& document = workspace.document;
    Transaction transaction{workspace.undo, format("make {}", path)};
    const ObjectId root =
        members.size() == 1 ? members.front() : groupEntities(document, workspace.undo, members);
    const PrefabMaker made{workspace.prefabs(), root};
    const Result<std::string> text = made.text();
    if (!text) return text.error();
    PrefabLibrary tried{document.types(), workspace.project.root};
    tried.add(path, *text);
    const Result<const Prefab*> read = tried.find(path);
    if (!read) return read.error();
    if (!(*read)->problems.empty()) return (*read)->problems.front();
    const Path file = workspace.project.root / path;
    std::error_code failed;
    std::filesystem::create_directories(file.parent_path(), failed);
    workspace.undo.push(std::make_unique<WriteAsset>(format("write {}", path), workspace.project.root,
                                                     workspace.assets, path, *text));
    if (!std::filesystem::exists(file, failed))
        return Error{path, "the file could not be written", "see the console for the reason"};
    workspace.undo.push(
        std::make_unique<BecomeInstance>(root, made.parts(), path, *workspace.prefabs().prefabs));
    transaction.commit();
    return root;
}

}  // namespace

std::string prefabPath(std::string_view name) { return format("prefabs/{}.prefab.json", name); }

Result<ObjectId> makePrefab(Workspace& workspace, const std::vector<ObjectId>& objects,
                            const std::string& path) {
    Document& document = workspace.document;
    const Result<Done> possible = canMake(workspace, objects, path);
    if (!possible) return possible.error();
    const std::vector<ObjectId> selected = document.selection.all();
    Result<ObjectId> made = make(workspace, outermost(document, objects), path);
    if (!made) document.selection.set(selected);
    return made;
}

}  // namespace plumb::editor
