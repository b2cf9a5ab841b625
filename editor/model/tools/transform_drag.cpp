#include "editor/model/tools/transform_drag.hpp"

#include <cmath>

#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/document/entity_state.hpp"
#include "editor/model/document/prefab_root.hpp"
#include "editor/model/document/visibility.hpp"
#include "math/angle.hpp"
#include "scene/components/drawing/sprite.hpp"

namespace plumb::editor {
Vec2 inParent(Vec2 offset, const Pose& parent) {
    const Vec2 turned = rotated(offset, -parent.rotation);
    return {parent.scale.x == 0.0f ? 0.0f : turned.x / parent.scale.x,
            parent.scale.y == 0.0f ? 0.0f : turned.y / parent.scale.y};
}

Vec2 snapped(Vec2 point, Vec2 grid) {
    return {std::round(point.x / grid.x) * grid.x, std::round(point.y / grid.y) * grid.y};
}

namespace {

EntityId entityInHand(const Document& document) {
    const std::vector<ObjectId>& all = document.selection.all();
    for (auto id = all.rbegin(); id != all.rend(); ++id) {
        const EntityId entity = document.find(*id);
        if (document.world.has<Transform>(entity)) return entity;
    }
    return {};
}

}  // namespace

std::optional<Pose> activePose(const Document& document) {
    const EntityId entity = entityInHand(document);
    return entity ? std::optional{worldPose(document.world, entity)} : std::nullopt;
}

Vec2 snapOffset(Vec2 size, Vec2 pivot, Vec2 grid) {
    const auto along = [](float length, float part, float step) {
        return length > 0.0f && std::fmod(length, step) == 0.0f ? part * length : 0.0f;
    };
    return {along(size.x, pivot.x, grid.x), along(size.y, pivot.y, grid.y)};
}

Vec2 dragOffset(Vec2 grabPoint, Vec2 snapPoint, const Pointer& pointer) {
    Vec2 offset = pointer.position - grabPoint;
    if (pointer.modifiers.shift) (std::abs(offset.x) > std::abs(offset.y) ? offset.y : offset.x) = 0.0f;
    if (!pointer.snap) return {std::round(offset.x), std::round(offset.y)};
    // Only the axes that move snap: a drag along x does not change a y that is off the grid.
    const Vec2 way = snapped(snapPoint + offset, pointer.grid) - snapPoint;
    return {offset.x == 0.0f ? 0.0f : way.x, offset.y == 0.0f ? 0.0f : way.y};
}

void TransformDrag::grab(const ToolContext& context) {
    const Document& document = context.document;
    grabbed_.clear();
    // The root entity of an edited prefab does not move, but selected entities below it do.
    std::vector<ObjectId> ids = context.selection.all();
    const bool root = std::erase(ids, prefabRootOf(document)) > 0;
    ids = outermost(document, ids);
    if (root) ids.push_back(prefabRootOf(document));
    for (const ObjectId id : ids) {
        const EntityId entity = document.find(id);
        const Transform* transform = document.world.find<Transform>(entity);
        if (transform == nullptr || isLocked(document, id)) continue;
        const EntityId parent = parentOf(document.world, entity);
        grabbed_.push_back({id, *transform, worldPose(document.world, entity),
                            parent ? worldPose(document.world, parent) : Pose{}});
    }
    pivot_ = activePose(document).value_or(Pose{});
    size_ = {};
    const Sprite* sprite = document.world.find<Sprite>(entityInHand(document));
    if (sprite == nullptr || pivot_.rotation != 0.0f || pivot_.scale != Vec2{1.0f, 1.0f}) return;
    size_ = {static_cast<float>(sprite->width), static_cast<float>(sprite->height)};
    anchor_ = sprite->pivot;
}

Vec2 TransformDrag::snapPoint(Vec2 grid) const { return pivot_.position - snapOffset(size_, anchor_, grid); }

void TransformDrag::move(const ToolContext& context, Vec2 offset) {
    std::vector<Transform> targets;
    for (const Grabbed& item : grabbed_) {
        Transform target = item.start;
        target.position += inParent(offset, item.parent);
        targets.push_back(target);
    }
    push(context, "move", std::move(targets));
}

void TransformDrag::turn(const ToolContext& context, float angle) {
    std::vector<Transform> targets;
    for (const Grabbed& item : grabbed_) {
        Transform target = item.start;
        target.rotation = wrapAngle(target.rotation + angle);
        const Vec2 arm = item.world.position - pivot_.position;
        target.position += inParent(rotated(arm, angle) - arm, item.parent);
        targets.push_back(target);
    }
    push(context, "rotate", std::move(targets));
}

void TransformDrag::scale(const ToolContext& context, Vec2 factors) {
    std::vector<Transform> targets;
    for (const Grabbed& item : grabbed_) {
        Transform target = item.start;
        target.scale = scaled(target.scale, factors);
        const Vec2 arm = rotated(item.world.position - pivot_.position, -pivot_.rotation);
        const Vec2 longer = rotated(scaled(arm, factors), pivot_.rotation);
        target.position += inParent(longer - rotated(arm, pivot_.rotation), item.parent);
        targets.push_back(target);
    }
    push(context, "scale", std::move(targets));
}

void TransformDrag::push(const ToolContext& context, std::string_view verb,
                         std::vector<Transform> targets) const {
    const TypeInfo& type = context.document.types().of<Transform>();
    const ObjectId root = prefabRootOf(context.document);
    const bool scales = verb == "scale";
    const bool scalesRoot = scales && !grabbed_.empty() && grabbed_.back().object == root;
    std::vector<ChangeComponents::Change> changes;
    for (std::size_t i = 0; i < grabbed_.size(); ++i) {
        // If the root is scaled, its descendants scale with it.
        const bool isRoot = grabbed_[i].object == root;
        if (isRoot ? !scales : scalesRoot) continue;
        if (isRoot) targets[i].position = grabbed_[i].start.position;
        changes.push_back({grabbed_[i].object, ComponentState{&type, FieldValue::of(targets[i]).bytes}});
    }
    if (changes.empty()) return;
    const std::string what = changes.size() == 1 ? context.document.nameOf(changes.front().object)
                                                 : format("{} entities", changes.size());
    context.undo.push(
        std::make_unique<ChangeComponents>(format("{} {}", verb, what), type, std::move(changes)));
}

void TransformDrag::finish(const ToolContext& context) {
    context.undo.endGesture();
    grabbed_.clear();
}

bool TransformDrag::cancel(const ToolContext& context) {
    if (grabbed_.empty()) return false;
    if (context.undo.inGesture()) context.undo.cancelGesture();
    grabbed_.clear();
    return true;
}

void nudge(const ToolContext& context, Vec2 offset) {
    TransformDrag drag;
    drag.grab(context);
    drag.move(context, offset);
}

}  // namespace plumb::editor
