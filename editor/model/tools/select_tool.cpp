#include "editor/model/tools/select_tool.hpp"

#include <algorithm>

#include "editor/model/bounds.hpp"

namespace plumb::editor {
namespace {

constexpr Color kBoxLine{77, 163, 255, 220};
constexpr Color kBoxFill{77, 163, 255, 36};

ObjectId hitOf(const ToolContext& context, const Pointer& pointer) {
    if (!pointer.modifiers.alt) return pickFirst(context.document, pointer.position, pointer.reach);
    const std::vector<ObjectId> hits = pickAll(context.document, pointer.position, pointer.reach);
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
    const ObjectId hit = hit_ = hitOf(context, pointer);
    onThing_ =
        hit && (context.selection.has(hit) || !isGround(context.document.world, context.document.find(hit)));
    if (!hit) {
        if (!pointer.modifiers.shift && !pointer.modifiers.control) context.selection.clear();
    } else if (pointer.modifiers.control) {
        context.selection.toggle(hit);
    } else if (pointer.modifiers.shift) {
        context.selection.add(hit);
    } else if (!context.selection.has(hit) || pointer.modifiers.alt) {
        context.selection.set({hit});
    }
}

void SelectTool::drag(const ToolContext& context, const Pointer& pointer) {
    end_ = pointer.position;
    if (mode_ == Mode::Pressed && distance(start_, end_) > pointer.reach) {
        mode_ = onThing_ ? Mode::Moving : Mode::Boxing;
        if (mode_ == Mode::Moving) move_.grab(context);
    }
    if (mode_ == Mode::Moving) move_.move(context, dragOffset(start_, move_.pivot().position, pointer));
}

void SelectTool::release(const ToolContext& context, const Pointer& pointer) {
    if (mode_ == Mode::Moving) move_.finish(context);
    // One of several that are selected, clicked and not dragged: that one alone.
    if (mode_ == Mode::Pressed && hit_ && pointer.modifiers == Modifiers{}) context.selection.set({hit_});
    if (mode_ == Mode::Boxing) {
        std::vector<ObjectId> found = pickInside(context.document, {min(start_, end_), max(start_, end_)});
        if (pointer.modifiers.shift || pointer.modifiers.control) {
            for (const ObjectId id : found) {
                pointer.modifiers.control ? context.selection.toggle(id) : context.selection.add(id);
            }
        } else {
            context.selection.set(std::move(found));
        }
    }
    mode_ = Mode::Idle;
}

bool SelectTool::cancel(const ToolContext& context) {
    if (mode_ == Mode::Moving) move_.cancel(context);
    return std::exchange(mode_, Mode::Idle) != Mode::Idle;
}

void SelectTool::draw(const ToolContext&, const Pointer&, Overlay& overlay) const {
    if (mode_ != Mode::Boxing) return;
    const AABB box{min(start_, end_), max(start_, end_)};
    overlay.filledBox(box, kBoxFill);
    overlay.box(box, kBoxLine);
}

}  // namespace plumb::editor
