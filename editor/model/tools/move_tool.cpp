#include "editor/model/tools/move_tool.hpp"

#include <cmath>

#include "ecs/hierarchy.hpp"
#include "editor/model/bounds.hpp"
#include "editor/model/commands/set_field.hpp"
#include "math/angle.hpp"
#include "scene/components/transform.hpp"
#include "scene/world_transform.hpp"

namespace plumb::editor {
namespace {

constexpr Color kGuide{77, 163, 255, 160};

/// An offset in the world as one in a parent that is turned and scaled.
Vec2 inParent(Vec2 offset, float angle, Vec2 scale) {
    const Vec2 turned = rotated(offset, -angle);
    return {scale.x == 0.0f ? 0.0f : turned.x / scale.x, scale.y == 0.0f ? 0.0f : turned.y / scale.y};
}

bool movesWithAnother(const Document& document, ObjectId id) {
    for (const ObjectId other : document.selection.all()) {
        if (other != id && isAncestor(document.world, document.find(other), document.find(id))) return true;
    }
    return false;
}

void pushPositions(const ToolContext& context, std::vector<SetField::Change> changes) {
    if (changes.empty()) return;
    const TypeInfo& type = context.document.types().of<Transform>();
    context.undo.push(std::make_unique<SetField>(type, *type.find("position"), std::move(changes)));
}

}  // namespace

Vec2 snapped(Vec2 point, Vec2 grid) {
    return {std::round(point.x / grid.x) * grid.x, std::round(point.y / grid.y) * grid.y};
}

void MoveTool::press(const ToolContext& context, const Pointer& pointer) {
    const Document& document = context.document;
    const std::vector<ObjectId> hits = pickAll(document, pointer.position, pointer.reach);
    if (!hits.empty() && !context.selection.has(hits.front())) context.selection.set({hits.front()});

    grabPoint_ = pointer.position;
    offset_ = {};
    grabbed_.clear();
    for (const ObjectId id : context.selection.all()) {
        const EntityId entity = document.find(id);
        const Transform* transform = document.world.find<Transform>(entity);
        if (transform == nullptr || movesWithAnother(document, id)) continue;
        const EntityId parent = parentOf(document.world, entity);
        const Pose outer = parent ? worldPose(document.world, parent) : Pose{};
        if (grabbed_.empty()) origin_ = worldPose(document.world, entity).position;
        grabbed_.push_back({id, transform->position, outer.rotation, outer.scale});
    }
}

void MoveTool::drag(const ToolContext& context, const Pointer& pointer) {
    offset_ = pointer.position - grabPoint_;
    if (pointer.modifiers.shift) (std::abs(offset_.x) > std::abs(offset_.y) ? offset_.y : offset_.x) = 0.0f;
    if (pointer.snap) {
        // Only what moves snaps: a drag along x leaves a y off the grid alone.
        const Vec2 target = snapped(origin_ + offset_, pointer.grid);
        offset_ = {offset_.x == 0.0f ? 0.0f : target.x - origin_.x,
                   offset_.y == 0.0f ? 0.0f : target.y - origin_.y};
    } else {
        offset_ = {std::round(offset_.x), std::round(offset_.y)};
    }
    std::vector<SetField::Change> changes;
    for (const Grabbed& item : grabbed_) {
        const Vec2 target = item.start + inParent(offset_, item.parentAngle, item.parentScale);
        changes.push_back({item.object, FieldValue::of(target)});
    }
    pushPositions(context, std::move(changes));
}

void MoveTool::release(const ToolContext& context, const Pointer&) {
    context.undo.endGesture();
    grabbed_.clear();
}

bool MoveTool::cancel(const ToolContext& context) {
    if (grabbed_.empty()) return false;
    if (context.undo.inGesture()) context.undo.cancelGesture();
    grabbed_.clear();
    return true;
}

void MoveTool::draw(const Document&, const Pointer&, Overlay& overlay) const {
    if (!grabbed_.empty() && offset_ != Vec2{}) overlay.line(origin_, origin_ + offset_, kGuide);
}

void nudge(const ToolContext& context, Vec2 offset) {
    std::vector<SetField::Change> changes;
    for (const ObjectId id : context.selection.all()) {
        const EntityId entity = context.document.find(id);
        const Transform* transform = context.document.world.find<Transform>(entity);
        if (transform == nullptr || movesWithAnother(context.document, id)) continue;
        const EntityId parent = parentOf(context.document.world, entity);
        const Pose outer = parent ? worldPose(context.document.world, parent) : Pose{};
        const Vec2 target = transform->position + inParent(offset, outer.rotation, outer.scale);
        changes.push_back({id, FieldValue::of(target)});
    }
    pushPositions(context, std::move(changes));
}

}  // namespace plumb::editor
