#include "editor/model/prefabs/instance_changes.hpp"

#include <algorithm>

#include "editor/model/prefabs/override_list.hpp"
#include "editor/model/prefabs/prefab_group.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor {
namespace {

/// The cached result with the state it was computed for. A resource of the document's world.
struct KnownChanges {
    std::uint64_t revision = ~0ull;
    std::uint64_t selection = ~0ull;
    std::string path;
    bool differ = false;
};

bool findOut(Workspace& workspace) {
    const std::vector<ObjectId>& selected = workspace.document.selection.all();
    if (selected.size() > PrefabGroup::kMost) return true;
    const PrefabEdit edit = workspace.prefabs();
    std::vector<ObjectId> seen;
    for (const ObjectId id : selected) {
        const auto part = InstancePart::of(workspace.document, edit.prefabs, id);
        if (!part || std::find(seen.begin(), seen.end(), part->root()) != seen.end()) continue;
        seen.push_back(part->root());
        if (!overrideList(edit, part->root()).empty()) return true;
    }
    return false;
}

}  // namespace

bool instancesDiffer(const Workspace& constant) {
    auto& workspace = const_cast<Workspace&>(constant);  // only the cache is changed
    const Document& document = workspace.document;
    const KnownChanges* known = document.world.findResource<KnownChanges>();
    if (known == nullptr || known->revision != document.sceneRevision ||
        known->selection != document.selection.revision() || known->path != document.scenePath) {
        const bool differ = findOut(workspace);
        auto& now = workspace.document.world.resource<KnownChanges>();
        now = {document.sceneRevision, document.selection.revision(), document.scenePath, differ};
        return differ;
    }
    return known->differ;
}

}  // namespace plumb::editor
