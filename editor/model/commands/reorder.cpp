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

/// Parts of prefabs have no place of their own in the file.
bool hasPlace(const Document& document, ObjectId id) {
    const EntityId entity = document.find(id);
    return entity && !document.world.has<PrefabPart>(entity);
}

/// An instance and its new place.
struct Moved {
    std::uint64_t instance;
    std::int32_t order;
};

/// The parts of an instance stand where it stands. @param moved  sorted by instance
void takeParts(Document& document, const std::vector<Moved>& moved) {
    document.world.each<const PrefabPart, SceneEntity>([&](const PrefabPart& part, SceneEntity& own) {
        const auto found =
            std::lower_bound(moved.begin(), moved.end(), part.instance,
                             [](const Moved& one, std::uint64_t id) { return one.instance < id; });
        if (found != moved.end() && found->instance == part.instance) own.order = found->order;
    });
}

bool anyShare(const Document& document, const std::vector<ObjectId>& line) {
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
    std::vector<std::int32_t> places;
    for (const ObjectId id : line) places.push_back(orderOf(document, id));
    std::sort(places.begin(), places.end());
    std::vector<Moved> moved;
    for (std::size_t i = 0; i < line.size(); ++i) {
        // Of two on one place neither would be the first.
        if (i > 0) places[i] = std::max(places[i], places[i - 1] + 1);
        if (orderOf(document, line[i]) == places[i]) continue;
        const EntityId entity = document.find(line[i]);
        document.world.get<SceneEntity>(entity).order = places[i];
        if (document.world.has<PrefabInstance>(entity)) moved.push_back({line[i].value, places[i]});
    }
    std::sort(moved.begin(), moved.end(),
              [](const Moved& a, const Moved& b) { return a.instance < b.instance; });
    if (!moved.empty()) takeParts(document, moved);
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
    // What stands before and behind all that moves stays on its place.
    if (!anyShare(document, before_)) keepWhatMoves();
    placeInOrder(document, after_);
}

void Reorder::keepWhatMoves() {
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
