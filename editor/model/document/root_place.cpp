#include "editor/model/document/root_place.hpp"

#include "editor/model/document/prefab_instance.hpp"
#include "editor/model/document/prefab_root.hpp"

namespace plumb::editor {

bool onlyRootSelected(const Document& document) {
    const std::vector<ObjectId>& selected = document.selection.all();
    return selected.size() == 1 && selected.front() == prefabRootOf(document);
}

bool isPlaceOfRoot(const Document& document, ObjectId id, const TypeInfo& type, std::string_view field) {
    return id == prefabRootOf(document) && isInstancePose(type, field);
}

}  // namespace plumb::editor
