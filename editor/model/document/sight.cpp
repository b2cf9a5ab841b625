#include "editor/model/document/sight.hpp"

#include <algorithm>

#include "ecs/hierarchy.hpp"
#include "editor/model/document/tile_layers.hpp"

namespace plumb::editor {
namespace {

/// Whether the entity, or one that it is below, is of a kind.
template <class Is>
bool isBelow(const Document& document, ObjectId id, Is&& is) {
    if (is(id)) return true;
    for (EntityId at = parentOf(document.world, document.find(id)); at; at = parentOf(document.world, at)) {
        if (is(document.idOf(at))) return true;
    }
    return false;
}

}  // namespace

bool isOutOfSight(const Document& document, ObjectId id) {
    const EntityView& view = document.view;
    return !view.hidden().empty() &&
           isBelow(document, id, [&](ObjectId above) { return view.isHidden(above); });
}

bool isLocked(const Document& document, ObjectId id) {
    const EntityView& view = document.view;
    return !view.locked().empty() && isBelow(document, id, [&](ObjectId above) { return view.locks(above); });
}

bool isOutOfHand(const Document& document, ObjectId id) {
    return !document.view.showsAll() && (isOutOfSight(document, id) || isLocked(document, id));
}

std::vector<EntityId> outOfSight(const Document& document) {
    std::vector<EntityId> hidden;
    const EntityView& view = document.view;
    if (!view.hidden().empty()) {
        for (const ObjectId id : document.objects()) {
            if (isOutOfSight(document, id)) hidden.push_back(document.find(id));
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
