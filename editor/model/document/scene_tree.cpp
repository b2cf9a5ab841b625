#include "editor/model/document/scene_tree.hpp"

#include <algorithm>
#include <utility>

#include "ecs/hierarchy.hpp"
#include "editor/model/document/name_filter.hpp"

namespace plumb::editor {

void SceneTree::follow(const Document& document, std::string_view words) {
    const bool same = tree_ == document.treeRevision && words_ == words && !stale_;
    if (same) return;
    tree_ = document.treeRevision;
    words_ = words;
    stale_ = false;
    rows_.clear();
    const NameFilter filter{words_, document.types()};
    filters_ = !filter.empty();
    if (!filters_) return makeTree(document);
    for (const ObjectId id : document.objects()) {
        if (filter.matches(document, id)) rows_.push_back({id, 0, false});
    }
}

void SceneTree::makeTree(const Document& document) {
    children_.clear();
    for (const ObjectId id : document.objects()) {
        children_.push_back({parentOf(document.world, document.find(id)), id});
    }
    std::stable_sort(children_.begin(), children_.end(),
                     [](const Child& a, const Child& b) { return a.parent < b.parent; });
    addRows(document, {}, 0);
}

void SceneTree::addRows(const Document& document, EntityId parent, int depth) {
    const auto before = [](const Child& child, EntityId wanted) { return child.parent < wanted; };
    auto at = std::lower_bound(children_.begin(), children_.end(), parent, before);
    for (; at != children_.end() && at->parent == parent; ++at) {
        const EntityId entity = document.find(at->id);
        const bool isParent = document.world.has<Children>(entity);
        rows_.push_back({at->id, depth, isParent});
        if (isParent && !isClosed(at->id)) addRows(document, entity, depth + 1);
    }
}

void SceneTree::setClosed(ObjectId id, bool closed) {
    if (closed ? closed_.insert(id.value).second : closed_.erase(id.value) > 0) stale_ = true;
}

void SceneTree::openTo(const Document& document, ObjectId id) {
    for (EntityId at = parentOf(document.world, document.find(id)); at; at = parentOf(document.world, at)) {
        setClosed(document.idOf(at), false);
    }
}

std::size_t SceneTree::rowOf(ObjectId id) const {
    const auto row = std::find_if(rows_.begin(), rows_.end(), [&](const Row& item) { return item.id == id; });
    return static_cast<std::size_t>(row - rows_.begin());
}

std::vector<ObjectId> SceneTree::range(ObjectId from, ObjectId to) const {
    std::size_t first = rowOf(from);
    const std::size_t last = rowOf(to);
    if (last == rows_.size()) return {};
    if (first == rows_.size()) first = last;
    std::vector<ObjectId> ids;
    for (std::size_t i = first; i != last; first < last ? ++i : --i) ids.push_back(rows_[i].id);
    ids.push_back(to);
    return ids;
}

}  // namespace plumb::editor
