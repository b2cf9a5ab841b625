#include "editor/model/tools/select_tool.hpp"

#include <algorithm>

#include "editor/model/commands/copy_entities.hpp"
#include "editor/model/document/bounds.hpp"

namespace plumb::editor {
namespace {

constexpr Color kBoxLine{77, 163, 255, 220};
constexpr Color kBoxFill{77, 163, 255, 36};

/// Returns the entity at the point below the selected one, without selecting whole prefab instances. After
/// the lowest it starts again at the top.
ObjectId nextBelow(const ToolContext& context, Vec2 point, float reach) {
    const std::vector<ObjectId> hits = pickAll(context.document, point, reach);
    if (hits.empty()) return {};
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (context.selection.has(hits[i])) return hits[(i + 1) % hits.size()];
    }
    return hits.front();
}

}  // namespace

void SelectTool::press(const ToolContext& context, const Pointer& pointer) {
    start_ = end_ = pointer.position;
    mode_ = Mode::Pressed;
    held_ = pointer.modifiers;
    reach_ = pointer.reach;
    hit_ = pickFirst(context.document, pointer.position, pointer.reach);
    wasSelected_ = context.selection.has(hit_);
    onThing_ = hit_ && (wasSelected_ || !isBackground(context.document, context.document.find(hit_)));
    select(context);
}

/// Updates the selection on a press. Cases that depend on whether a drag follows are decided on release: a
/// press with Alt, with Ctrl on a selected entity, or on the ground, where a box may start.
void SelectTool::select(const ToolContext& context) const {
    if (!hit_) {
        if (!held_.shift && !held_.control) context.selection.clear();
    } else if (held_.control || held_.shift) {
        if (onThing_) context.selection.add(hit_);
    } else if (!wasSelected_ && !held_.alt) {
        context.selection.set({hit_});
    }
}

void SelectTool::drag(const ToolContext& context, const Pointer& pointer) {
    end_ = pointer.position;
    if (mode_ == Mode::Pressed && distance(start_, end_) > pointer.reach) beginDrag(context);
    if (mode_ == Mode::Moving)
        move_.move(context, dragOffset(start_, move_.snapPoint(pointer.grid), pointer));
}

void SelectTool::beginDrag(const ToolContext& context) {
    mode_ = onThing_ ? Mode::Moving : Mode::Boxing;
    copied_.clear();
    if (mode_ != Mode::Moving) return;
    if (held_.alt) {
        if (!context.selection.has(hit_)) context.selection.set({hit_});
        copied_ = context.selection.all();
        context.undo.push(std::make_unique<CopyEntities>(copied_));
    }
    move_.grab(context);
}

void SelectTool::release(const ToolContext& context, const Pointer& pointer) {
    if (mode_ == Mode::Moving) {
        move_.finish(context);
    } else if (mode_ == Mode::Boxing) {
        finishBox(context, pointer);
    } else if (mode_ == Mode::Pressed && hit_) {
        finishClick(context, pointer);
    }
    mode_ = Mode::Idle;
}

void SelectTool::finishClick(const ToolContext& context, const Pointer& pointer) const {
    if (held_.alt) {
        context.selection.set({nextBelow(context, start_, reach_)});
    } else if (held_.control && wasSelected_) {
        context.selection.remove(hit_);
    } else if (held_.control || held_.shift) {
        context.selection.add(hit_);
    } else if (held_ == Modifiers{} && pointer.modifiers == Modifiers{}) {
        context.selection.set({hit_});  // a plain click on one of several selected entities selects it alone
    }
}

void SelectTool::finishBox(const ToolContext& context, const Pointer& pointer) const {
    std::vector<ObjectId> found = pickInside(context.document, {min(start_, end_), max(start_, end_)});
    if (!pointer.modifiers.shift && !pointer.modifiers.control)
        return context.selection.set(std::move(found));
    for (const ObjectId id : found) {
        pointer.modifiers.control ? context.selection.toggle(id) : context.selection.add(id);
    }
}

bool SelectTool::cancel(const ToolContext& context) {
    if (mode_ == Mode::Moving) {
        if (!copied_.empty() && context.undo.inGesture()) {
            context.undo.cancelGesture();
            context.selection.set(copied_);
        }
        move_.cancel(context);
    }
    return std::exchange(mode_, Mode::Idle) != Mode::Idle;
}

void SelectTool::draw(const ToolContext&, const Pointer&, Overlay& overlay) const {
    if (mode_ != Mode::Boxing) return;
    const AABB box{min(start_, end_), max(start_, end_)};
    overlay.filledBox(box, kBoxFill);
    overlay.box(box, kBoxLine);
}

}  // namespace plumb::editor
