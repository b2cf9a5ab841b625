#include "editor/model/tools/shape_tool.hpp"

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "editor/model/document/visibility.hpp"
#include "editor/model/tools/handles.hpp"

namespace plumb::editor {
namespace {

constexpr float kReach = 7.0f;      // px on screen: hit distance of a spot
constexpr float kEdgeReach = 5.0f;  // px on screen: hit distance of an edge
constexpr float kHalf = 4.0f;       // px on screen: half the side length of a drawn spot
constexpr Color kOutline{120, 230, 160, 230};
constexpr Color kSpot{255, 255, 255, 255};
constexpr Color kAnchor{240, 185, 74, 255};

/// Returns the entity whose spots are shown: the last selected one, unless it is locked or hidden.
ObjectId inHand(const ToolContext& context) {
    if (context.selection.empty()) return {};
    const ObjectId id = context.selection.all().back();
    return isHiddenOrLocked(context.document, id) ? ObjectId{} : id;
}

float distanceTo(const ShapeEdge& edge, Vec2 point) {
    const Vec2 way = edge.to - edge.from;
    const float square = lengthSquared(way);
    const float part = square > 0.0f ? std::clamp(dot(point - edge.from, way) / square, 0.0f, 1.0f) : 0.0f;
    return distance(edge.from + way * part, point);
}

/// Returns the nearest spot (handle) in reach. Of several at the same distance, the first in the list is
/// returned; the pivot is the last in the list.
std::optional<ShapeHandle> spotAt(const std::vector<ShapeHandle>& spots, const Pointer& pointer) {
    std::optional<ShapeHandle> found;
    float nearest = kReach * pointer.pixel;
    for (const ShapeHandle& spot : spots) {
        const float away = distance(spot.at, pointer.position);
        if (found ? away >= nearest : away > nearest) continue;
        nearest = away;
        found = spot;
    }
    return found;
}

std::optional<ShapeEdge> edgeAt(const std::vector<ShapeEdge>& edges, const Pointer& pointer) {
    std::optional<ShapeEdge> found;
    float nearest = kEdgeReach * pointer.pixel;
    for (const ShapeEdge& edge : edges) {
        const float away = distanceTo(edge, pointer.position);
        if (!edge.takesCorner || away > nearest) continue;
        nearest = away;
        found = edge;
    }
    return found;
}

bool isSame(const ShapeHandle& a, const ShapeHandle& b) {
    return a.type == b.type && a.part == b.part && a.kind == b.kind;
}

void drawSpot(Overlay& overlay, const ShapeHandle& spot, float pixel, bool hot, bool chosen) {
    const Color own = spot.kind == ShapeHandleKind::Anchor || spot.kind == ShapeHandleKind::Way ? kAnchor
                      : spot.kind == ShapeHandleKind::Pivot ? handle_colors::kBoth
                                                            : kSpot;
    const Color color = hot || chosen ? handle_colors::kHot : own;
    const float half = kHalf * pixel * (hot ? 1.25f : 1.0f);
    const AABB box{spot.at - Vec2{half, half}, spot.at + Vec2{half, half}};
    switch (spot.kind) {
        case ShapeHandleKind::Corner:
            overlay.filledBox(grown(box, 1.5f * pixel), handle_colors::kShade);
            overlay.filledBox(box, color);
            break;
        case ShapeHandleKind::Side:
            overlay.filledBox(grown(box, 0.5f * pixel), handle_colors::kShade);
            overlay.filledBox(grown(box, -1.0f * pixel), color);
            break;
        case ShapeHandleKind::Middle:
        case ShapeHandleKind::Anchor:
        case ShapeHandleKind::Way:
            overlay.circle(spot.at, half + 1.0f * pixel, handle_colors::kShade, 4.0f);
            overlay.circle(spot.at, half + 1.0f * pixel, color, 2.0f);
            if (spot.kind != ShapeHandleKind::Middle) overlay.circle(spot.at, 1.0f * pixel, color, 2.0f);
            break;
        case ShapeHandleKind::Pivot: {
            const float arm = half * 2.2f;
            for (const auto& [line, width] :
                 {std::pair{handle_colors::kShade, 4.0f}, std::pair{color, 2.0f}}) {
                overlay.line(spot.at - Vec2{arm, 0.0f}, spot.at + Vec2{arm, 0.0f}, line, width);
                overlay.line(spot.at - Vec2{0.0f, arm}, spot.at + Vec2{0.0f, arm}, line, width);
            }
            break;
        }
    }
}

}  // namespace

void ShapeTool::press(const ToolContext& context, const Pointer& pointer) {
    const ObjectId id = inHand(context);
    held_.reset();
    moved_ = false;
    if (id) {
        if (const auto spot = spotAt(spotsOf(context.document, id), pointer))
            return object_ = id, hold(context, *spot, pointer);
        const auto edge = edgeAt(edgesOf(context.document, id), pointer);
        if (edge && !pointer.modifiers.control && !pointer.modifiers.shift) {
            object_ = id;
            if (auto state = withCorner(context.document, id, *edge, pointer.position)) {
                const ShapeHandle corner{pointer.position, edge->type, edge->part, ShapeHandleKind::Corner};
                std::vector<ChangeStates::Change> changes;
                changes.push_back({id, std::move(*state)});
                push(context, std::move(changes));
                moved_ = true;
                return hold(context, corner, pointer);
            }
        }
    }
    chosen_.reset();
    select_.press(context, pointer);
}

void ShapeTool::hold(const ToolContext& context, const ShapeHandle& spot, const Pointer& pointer) {
    held_ = chosen_ = spot;
    grabPoint_ = pointer.position;
    start_ = statesBehind(context.document, object_, spot);
}

void ShapeTool::drag(const ToolContext& context, const Pointer& pointer) {
    if (!held_) return select_.drag(context, pointer);
    moved_ = true;
    const Vec2 to = held_->at + dragOffset(grabPoint_, held_->at, pointer);
    push(context, draggedTo(context.document, object_, *held_, start_, to));
}

void ShapeTool::push(const ToolContext& context, std::vector<ChangeStates::Change> changes) const {
    const TypeInfo& type = *changes.front().state.type;
    const std::string label = format("shape {} of {}", type.name, context.document.nameOf(object_));
    context.undo.push(std::make_unique<ChangeStates>(label, std::move(changes)));
}

void ShapeTool::release(const ToolContext& context, const Pointer& pointer) {
    if (!held_) return select_.release(context, pointer);
    held_.reset();
    start_.clear();
    if (!moved_ && pointer.modifiers.control) removeChosen(context);
    context.undo.endGesture();
}

bool ShapeTool::cancel(const ToolContext& context) {
    if (!std::exchange(held_, std::nullopt)) {
        const bool was = chosen_.has_value();
        chosen_.reset();
        return select_.cancel(context) || was;
    }
    if (moved_ && context.undo.inGesture()) context.undo.cancelGesture();
    chosen_.reset();
    start_.clear();
    return true;
}

std::optional<ShapeHandle> ShapeTool::chosen(const ToolContext& context) const {
    if (!chosen_ || object_ != inHand(context)) return std::nullopt;
    for (const ShapeHandle& spot : spotsOf(context.document, object_)) {
        if (isSame(spot, *chosen_)) return spot;
    }
    return std::nullopt;
}

bool ShapeTool::hasSelectedPart(const ToolContext& context) const {
    const auto spot = chosen(context);
    return spot && withoutCorner(context.document, object_, *spot).has_value();
}

void ShapeTool::removeChosen(const ToolContext& context) {
    const auto spot = chosen(context);
    auto state = spot ? withoutCorner(context.document, object_, *spot) : std::nullopt;
    if (!state) return;
    std::vector<ChangeStates::Change> changes;
    changes.push_back({object_, std::move(*state)});
    push(context, std::move(changes));
    context.undo.endGesture();
    chosen_.reset();
}

void ShapeTool::draw(const ToolContext& context, const Pointer& pointer, Overlay& overlay) const {
    select_.draw(context, pointer, overlay);
    const ObjectId id = inHand(context);
    if (!id) return;
    const std::vector<ShapeEdge> edges = edgesOf(context.document, id);
    for (const ShapeEdge& edge : edges) {
        overlay.line(edge.from, edge.to, handle_colors::kShade, 4.0f);
        overlay.line(edge.from, edge.to, kOutline, 1.5f);
    }
    const std::vector<ShapeHandle> spots = spotsOf(context.document, id);
    const auto under = held_ ? held_ : spotAt(spots, pointer);
    const auto last = chosen(context);
    for (auto spot = spots.rbegin(); spot != spots.rend(); ++spot) {
        drawSpot(overlay, *spot, pointer.pixel, under && isSame(*under, *spot), last && isSame(*last, *spot));
    }
    const auto edge = under ? std::nullopt : edgeAt(edges, pointer);
    if (edge) overlay.circle(pointer.position, kHalf * pointer.pixel, handle_colors::kHot, 2.0f);
}

}  // namespace plumb::editor
