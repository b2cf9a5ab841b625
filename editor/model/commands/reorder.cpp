#include "editor/model/commands/reorder.hpp"

#include <algorithm>

#include "editor/model/document/document.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/scene_entity.hpp"

namespace plumb::editor {
namespace {

std::int32_t orderOf(const Document& document, ObjectId id) {
    return document.world.get<SceneEntity>(document.find(id)).order;
}

/// True if the entity has its own position in the file order. Parts of prefab instances have none.
bool hasPlace(const Document& document, ObjectId id) {
    const EntityId entity = document.find(id);
    return entity && !document.world.has<PrefabPart>(entity);
}

/// A prefab instance and its new order number.
struct Moved {
    std::uint64_t instance;
    std::int32_t order;
};

/// Gives the parts of moved instances the order number of their instance. @param moved  sorted by instance
void moveParts(Document& document, const std::vector<Moved>& moved) {
    document.world.each<const PrefabPart, SceneEntity>([&](const PrefabPart& part, SceneEntity& own) {
        const auto found =
            std::lower_bound(moved.begin(), moved.end(), part.instance,
                             [](const Moved& one, std::uint64_t id) { return one.instance < id; });
        if (found != moved.end() && found->instance == part.instance) own.order = found->order;
    });
}

bool anyShareOrder(const Document& document, const std::vector<ObjectId>& line) {
    for (std::size_t i = 1; i < line.size(); ++i) {
        if (orderOf(document, line[i]) == orderOf(document, line[i - 1])) return true;
    }
    return false;
}

}  // namespace

std::vector<ObjectId> fileOrder(const Document& document) {
    std::vector<ObjectId> line = document.objects();
    std::erase_if(line, [&](ObjectId id) { return !hasPlace(document, id); });
    return line;
}

void placeInOrder(Document& document, const std::vector<ObjectId>& line) {
    std::vector<std::int32_t> orders;
    for (const ObjectId id : line) orders.push_back(orderOf(document, id));
    std::sort(orders.begin(), orders.end());
    std::vector<Moved> moved;
    for (std::size_t i = 0; i < line.size(); ++i) {
        // Order numbers must be unique, else the order of two entities would be undefined.
        if (i > 0) orders[i] = std::max(orders[i], orders[i - 1] + 1);
        if (orderOf(document, line[i]) == orders[i]) continue;
        const EntityId entity = document.find(line[i]);
        document.world.get<SceneEntity>(entity).order = orders[i];
        if (document.world.has<PrefabInstance>(entity)) moved.push_back({line[i].value, orders[i]});
    }
    std::sort(moved.begin(), moved.end(),
              [](const Moved& a, const Moved& b) { return a.instance < b.instance; });
    if (!moved.empty()) moveParts(document, moved);
    document.reordered();
}

void Reorder::apply(Document& document) {
    before_.clear();
    after_.clear();
    if (!hasPlace(document, beside_)) return;
    std::vector<ObjectId> moved = objects_;
    std::erase_if(moved, [&](ObjectId id) { return id == beside_ || !hasPlace(document, id); });
    std::vector<ObjectId> sorted = moved;
    std::sort(sorted.begin(), sorted.end());
    before_ = fileOrder(document);
    for (const ObjectId id : before_) {
        if (std::binary_search(sorted.begin(), sorted.end(), id)) continue;
        if (id != beside_ || behind_) after_.push_back(id);
        if (id == beside_) after_.insert(after_.end(), moved.begin(), moved.end());
        if (id == beside_ && !behind_) after_.push_back(id);
    }
    if (before_ == after_) {
        before_.clear();
        return after_.clear();
    }
    // Entities before and after the affected range keep their numbers.
    if (!anyShareOrder(document, before_)) keepMovedRange();
    placeInOrder(document, after_);
}

void Reorder::keepMovedRange() {
    std::size_t from = 0;
    std::size_t to = before_.size();
    while (before_[from] == after_[from]) ++from;
    while (before_[to - 1] == after_[to - 1]) --to;
    for (std::vector<ObjectId>* line : {&before_, &after_}) {
        line->erase(line->begin() + static_cast<std::ptrdiff_t>(to), line->end());
        line->erase(line->begin(), line->begin() + static_cast<std::ptrdiff_t>(from));
    }
}

void Reorder::revert(Document& document) {
    if (!before_.empty()) placeInOrder(document, before_);
}

}  // namespace plumb::editor
