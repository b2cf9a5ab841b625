#include "editor/model/document/visibility.hpp"

#include <algorithm>

#include "ecs/hierarchy.hpp"
#include "editor/model/document/tile_layers.hpp"

namespace plumb::editor {
namespace {

/// True if `is` holds for the entity or one of its ancestors.
template <class Is>
bool selfOrAncestor(const Document& document, ObjectId id, Is&& is) {
    if (is(id)) return true;
    for (EntityId at = parentOf(document.world, document.find(id)); at; at = parentOf(document.world, at)) {
        if (is(document.idOf(at))) return true;
    }
    return false;
}

}  // namespace

bool isHiddenInTree(const Document& document, ObjectId id) {
    const EntityView& view = document.view;
    return !view.hidden().empty() &&
           selfOrAncestor(document, id, [&](ObjectId above) { return view.isHidden(above); });
}

bool isLocked(const Document& document, ObjectId id) {
    const EntityView& view = document.view;
    return !view.locked().empty() &&
           selfOrAncestor(document, id, [&](ObjectId above) { return view.locks(above); });
}

bool isHiddenOrLocked(const Document& document, ObjectId id) {
    return !document.view.showsAll() && (isHiddenInTree(document, id) || isLocked(document, id));
}

std::vector<EntityId> hiddenEntities(const Document& document) {
    std::vector<EntityId> hidden;
    const EntityView& view = document.view;
    if (!view.hidden().empty()) {
        for (const ObjectId id : document.objects()) {
            if (isHiddenInTree(document, id)) hidden.push_back(document.find(id));
        }
    }
    if (view.solo()) {
        for (const ObjectId layer : tileLayers(document)) {
            if (view.hides(layer)) hidden.push_back(document.find(layer));
        }
    }
    std::sort(hidden.begin(), hidden.end());
    return hidden;
}

}  // namespace plumb::editor
