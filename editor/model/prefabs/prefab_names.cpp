#include "editor/model/prefabs/prefab_names.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "editor/model/prefabs/make_prefab.hpp"
#include "scene/components/prefab_instance.hpp"

namespace plumb::editor {

std::string freePrefabName(const Workspace& workspace, std::string_view wanted) {
    const auto isTaken = [&](const std::string& name) {
        std::error_code failed;
        return std::filesystem::exists(workspace.project.root / prefabPath(name), failed);
    };
    std::string name{wanted};
    if (!isTaken(name)) return name;
    // "door2" is followed by "door3".
    const std::size_t end = wanted.find_last_not_of("0123456789") + 1;
    const auto number = parseInt(wanted.substr(end));
    const std::string_view stem = number && *number < 1'000'000 ? wanted.substr(0, end) : wanted;
    for (std::int64_t next = number ? *number + 1 : 2; isTaken(name); ++next)
        name = format("{}{}", stem, next);
    return name;
}

std::string prefabNote(const Document& document, const std::vector<ObjectId>& objects) {
    const World& world = document.world;
    const std::vector<ObjectId> roots = outermost(document, objects);
    if (roots.size() == 1) {
        if (const auto* instance = world.find<PrefabInstance>(document.find(roots.front())))
            return format("A variant of {}: its file stores only the differences.",
                          world.texts().find(instance->prefab.path));
    }
    const std::vector<ObjectId> all = withDescendants(document, roots);
    const auto inside = std::count_if(
        all.begin(), all.end(), [&](ObjectId id) { return world.has<PrefabInstance>(document.find(id)); });
    std::string words = roots.size() > 1 ? "The entities are put below a new one." : "";
    if (inside == 0) return words;
    if (!words.empty()) words += ' ';
    return words + (inside == 1 ? std::string{"The instance inside stays an instance."}
                                : format("The {} instances inside stay instances.", inside));
}

}  // namespace plumb::editor
