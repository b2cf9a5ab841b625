#include "editor/model/arrange.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/document/bounds.hpp"
#include "editor/model/document/entity_state.hpp"
#include "editor/model/document/prefab_root.hpp"
#include "editor/model/document/visibility.hpp"
#include "editor/model/tools/transform_drag.hpp"

namespace plumb::editor {
namespace {

constexpr float kMinMove = 1e-3f;  // px; shorter moves are skipped

/// Displacement of one entity.
struct Displacement {
    ObjectId object;
    Vec2 by;  ///< px, in world space
};

bool move(Document& document, UndoStack& undo, const std::string& verb,
          const std::vector<Displacement>& moves) {
    const TypeInfo& type = document.types().of<Transform>();
    std::vector<ChangeComponents::Change> changes;
    for (const Displacement& one : moves) {
        if (std::abs(one.by.x) < kMinMove && std::abs(one.by.y) < kMinMove) continue;
        const EntityId entity = document.find(one.object);
        const EntityId parent = parentOf(std::as_const(document.world), entity);
        Transform next = std::as_const(document.world).get<Transform>(entity);
        next.position += inParent(one.by, parent ? worldPose(document.world, parent) : Pose{});
        changes.push_back({one.object, ComponentState{&type, FieldValue::of(next).bytes}});
    }
    if (changes.empty()) return false;
    undo.push(std::make_unique<ChangeComponents>(format("{} of {} entities", verb, moves.size()), type,
                                                 std::move(changes)));
    undo.endGesture();
    return true;
}

struct AlignmentRow {
    const char* verb;
    bool across;  ///< true: moves along x, false: along y
    float part;   ///< aligned position in the box: 0 left or top edge, 0.5 center, 1 right or bottom edge
};
constexpr AlignmentRow kAlignments[] = {
    {"align left edges", true, 0.0f}, {"align centers", true, 0.5f},  {"align right edges", true, 1.0f},
    {"align top edges", false, 0.0f}, {"align middles", false, 0.5f}, {"align bottom edges", false, 1.0f}};

}  // namespace

std::vector<ObjectId> arrangeable(const Document& document, const std::vector<ObjectId>& objects) {
    std::vector<ObjectId> ids = objects;
    std::erase(ids, prefabRootOf(document));  // it must not move
    ids = outermost(document, ids);
    std::erase_if(ids, [&](ObjectId id) {
        return !hasTransform(document.world, document.find(id)) || isLocked(document, id);
    });
    return ids;
}

bool alignEntities(Document& document, UndoStack& undo, const std::vector<ObjectId>& objects, Alignment to) {
    const std::vector<ObjectId> ids = arrangeable(document, objects);
    const std::optional<AABB> whole = boundsOf(document, ids);
    if (!whole || ids.size() < 2) return false;
    const AlignmentRow& row = kAlignments[static_cast<std::size_t>(to)];
    std::vector<Displacement> moves;
    for (const ObjectId id : ids) {
        const AABB box = boundsOf(document.world, document.find(id));
        const Vec2 by = lerp(whole->min, whole->max, row.part) - lerp(box.min, box.max, row.part);
        moves.push_back({id, row.across ? Vec2{by.x, 0.0f} : Vec2{0.0f, by.y}});
    }
    return move(document, undo, row.verb, moves);
}

bool spreadEntities(Document& document, UndoStack& undo, const std::vector<ObjectId>& objects,
                    bool downwards) {
    struct Item {
        ObjectId id;
        float from;
        float to;
    };
    std::vector<Item> items;
    for (const ObjectId id : arrangeable(document, objects)) {
        const AABB box = boundsOf(document.world, document.find(id));
        items.push_back({id, downwards ? box.min.y : box.min.x, downwards ? box.max.y : box.max.x});
    }
    if (items.size() < 3) return false;
    std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
        const float middleA = a.from + a.to;
        const float middleB = b.from + b.to;
        return middleA != middleB ? middleA < middleB : a.id < b.id;
    });
    float room = items.back().from - items.front().to;
    for (std::size_t i = 1; i + 1 < items.size(); ++i) room -= items[i].to - items[i].from;
    const float gap = room / static_cast<float>(items.size() - 1);
    std::vector<Displacement> moves{{items.front().id, {}}, {items.back().id, {}}};
    float next = items.front().to + gap;
    const auto middle = [](const Item& item) { return (item.from + item.to) * 0.5f; };
    const float step = (middle(items.back()) - middle(items.front())) / static_cast<float>(items.size() - 1);
    for (std::size_t i = 1; i + 1 < items.size(); ++i) {
        // Boxes that do not fit side by side get equal distances between their centers, which keeps the
        // order.
        const float by = room < 0.0f ? middle(items.front()) + step * static_cast<float>(i) - middle(items[i])
                                     : next - items[i].from;
        moves.push_back({items[i].id, downwards ? Vec2{0.0f, by} : Vec2{by, 0.0f}});
        next += items[i].to - items[i].from + gap;
    }
    return move(document, undo, downwards ? "equalize vertical gaps" : "equalize horizontal gaps", moves);
}

}  // namespace plumb::editor
