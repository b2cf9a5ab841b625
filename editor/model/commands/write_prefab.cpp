#include "editor/model/commands/write_prefab.hpp"

#include <utility>

#include "core/log.hpp"

namespace plumb::editor {

void WritePrefab::swap(Document& document) {
    Result<std::string> before = readFile(file_);
    const Result<Done> written = before ? writeFile(file_, text_) : Result<Done>{before.error()};
    if (written) {
        text_ = *std::move(before);
    } else {
        logError("Editor", written.error());
    }
    prefabs_.forget();
    ++document.treeRevision;
    for (Change& change : changes_) {
        const EntityId entity = document.find(change.object);
        std::optional<ComponentState> now;
        if (document.world.has(*change.type, entity)) now = readComponent(document, *change.type, entity);
        const std::optional<ComponentState> next = std::exchange(change.state, std::move(now));
        if (next) {
            writeComponent(document, entity, *next);
        } else {
            document.world.remove(*change.type, entity);
        }
    }
}

}  // namespace plumb::editor
