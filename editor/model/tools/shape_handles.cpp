#include "editor/model/tools/shape_handles.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ecs/hierarchy.hpp"
#include "editor/model/document/prefab_root.hpp"
#include "editor/model/tools/motion_paths.hpp"
#include "math/angle.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/colliders/capsule_collider.hpp"
#include "scene/components/colliders/chain_collider.hpp"
#include "scene/components/colliders/circle_collider.hpp"
#include "scene/components/colliders/polygon_collider.hpp"
#include "scene/components/drawing/sprite.hpp"

namespace plumb::editor {
namespace {

constexpr float kLeast = 1.0f;  // px: minimum length of a side and minimum radius
constexpr int kMiddle = 8;      // part index of the handle that moves a whole box or circle

/// Coordinate frames of an entity. "Turned" coordinates are rotated with the entity but not scaled: those of
/// the offsets of boxes and circles. "Scaled" ones are also scaled: those of the points of outlines.
struct Frame {
    explicit Frame(const Pose& at) : pose{at}, size{std::abs(at.scale.x), std::abs(at.scale.y)} {}

    [[nodiscard]] Vec2 toWorld(Vec2 turned) const { return pose.position + rotated(turned, pose.rotation); }
    [[nodiscard]] Vec2 toTurned(Vec2 world) const { return rotated(world - pose.position, -pose.rotation); }
    [[nodiscard]] Vec2 toScaled(Vec2 turned) const {
        return {pose.scale.x == 0.0f ? 0.0f : turned.x / pose.scale.x,
                pose.scale.y == 0.0f ? 0.0f : turned.y / pose.scale.y};
    }

    Pose pose;
    Vec2 size;  ///< absolute value of the scale
};

/// The handles around a box, as ratios of its size: corners and centers of the sides.
constexpr std::array<Vec2, 8> kAround{Vec2{0.0f, 0.0f}, Vec2{0.5f, 0.0f}, Vec2{1.0f, 0.0f}, Vec2{1.0f, 0.5f},
                                      Vec2{1.0f, 1.0f}, Vec2{0.5f, 1.0f}, Vec2{0.0f, 1.0f}, Vec2{0.0f, 0.5f}};
/// Directions of the four handles on a circle.
constexpr std::array<Vec2, 4> kCompass{Vec2{1.0f, 0.0f}, Vec2{0.0f, 1.0f}, Vec2{-1.0f, 0.0f},
                                       Vec2{0.0f, -1.0f}};

template <class T>
T& valueOf(ComponentState& state) {
    return *static_cast<T*>(static_cast<void*>(state.bytes.data()));
}
template <class T>
const T& valueOf(const ComponentState& state) {
    return *static_cast<const T*>(static_cast<const void*>(state.bytes.data()));
}

// Boxes, and capsules by their bounding box.

template <class Box>
AABB boxIn(const Frame& frame, const Box& box) {
    return {box.offset, box.offset + scaled({box.width, box.height}, frame.size)};
}

template <class Box>
void addBox(const Frame& frame, const ComponentState& state, std::vector<ShapeHandle>& spots) {
    const AABB box = boxIn(frame, valueOf<Box>(state));
    for (int i = 0; i < 8; ++i) {
        const Vec2 part = kAround[static_cast<std::size_t>(i)];
        const Vec2 at = box.min + scaled(box.size(), part);
        spots.push_back(
            {frame.toWorld(at), state.type, i, i % 2 == 0 ? ShapeHandleKind::Corner : ShapeHandleKind::Side});
    }
    spots.push_back({frame.toWorld(box.center()), state.type, kMiddle, ShapeHandleKind::Middle});
}

/// Drags a box along one axis. Writes only the values that change, so that the others stay exactly as typed.
/// @param part  0: low side, 1: high side, 0.5: no change
void dragSide(float part, float to, float low, float high, float scale, float& offset, float& length) {
    if (part == 0.5f || scale == 0.0f) return;
    if (part == 0.0f) {
        offset = std::min(to, high - kLeast);
        length = (high - offset) / scale;
    } else {
        length = (std::max(to, low + kLeast) - low) / scale;
    }
}

template <class Box>
void dragBox(const Frame& frame, ComponentState& state, int part, Vec2 to) {
    Box& box = valueOf<Box>(state);
    const AABB now = boxIn(frame, box);
    if (part == kMiddle) {
        box.offset += to - now.center();
        return;
    }
    const Vec2 side = kAround[static_cast<std::size_t>(part)];
    dragSide(side.x, to.x, now.min.x, now.max.x, frame.size.x, box.offset.x, box.width);
    dragSide(side.y, to.y, now.min.y, now.max.y, frame.size.y, box.offset.y, box.height);
}

template <class Box>
void addBoxEdges(const Frame& frame, const ComponentState& state, std::vector<ShapeEdge>& edges) {
    const AABB box = boxIn(frame, valueOf<Box>(state));
    const std::array<Vec2, 4> corners{box.min, Vec2{box.max.x, box.min.y}, box.max,
                                      Vec2{box.min.x, box.max.y}};
    for (std::size_t i = 0; i < 4; ++i) {
        edges.push_back(
            {frame.toWorld(corners[i]), frame.toWorld(corners[(i + 1) % 4]), state.type, 0, false});
    }
}

// Circles.

float radiusIn(const Frame& frame, const CircleCollider& circle) {
    return circle.radius * std::max(frame.size.x, frame.size.y);
}

void addCircle(const Frame& frame, const ComponentState& state, std::vector<ShapeHandle>& spots) {
    const auto& circle = valueOf<CircleCollider>(state);
    for (int i = 0; i < 4; ++i) {
        const Vec2 at = circle.offset + kCompass[static_cast<std::size_t>(i)] * radiusIn(frame, circle);
        spots.push_back({frame.toWorld(at), state.type, i, ShapeHandleKind::Side});
    }
    spots.push_back({frame.toWorld(circle.offset), state.type, kMiddle, ShapeHandleKind::Middle});
}

void dragCircle(const Frame& frame, ComponentState& state, int part, Vec2 to) {
    auto& circle = valueOf<CircleCollider>(state);
    const float scale = std::max(frame.size.x, frame.size.y);
    if (part == kMiddle) {
        circle.offset = to;
    } else if (scale > 0.0f) {
        const float radius = dot(to - circle.offset, kCompass[static_cast<std::size_t>(part)]);
        circle.radius = std::max(radius, kLeast) / scale;
    }
}

void addCircleEdges(const Frame& frame, const ComponentState& state, std::vector<ShapeEdge>& edges) {
    const auto& circle = valueOf<CircleCollider>(state);
    constexpr int kSides = 32;
    const auto at = [&](int i) {
        const float angle = 2.0f * kPi * static_cast<float>(i) / kSides;
        return frame.toWorld(circle.offset + rotated({radiusIn(frame, circle), 0.0f}, angle));
    };
    for (int i = 0; i < kSides; ++i) edges.push_back({at(i), at(i + 1), state.type, 0, false});
}

// Outlines.

Vec2 offsetOf(const PolygonCollider& polygon) { return polygon.offset; }
Vec2 offsetOf(const ChainCollider&) { return {}; }
void moveOffset(PolygonCollider& polygon, Vec2 by) { polygon.offset += by; }
void moveOffset(ChainCollider& chain, Vec2 by) {
    for (Vec2& point : chain.points) point += by;
}
bool isClosed(const PolygonCollider&) { return true; }
bool isClosed(const ChainCollider& chain) { return chain.loop; }
std::size_t fewestCorners(const PolygonCollider&) { return 3; }
std::size_t fewestCorners(const ChainCollider& chain) { return chain.loop ? 3 : 2; }

template <class Outline>
Vec2 cornerIn(const Frame& frame, const Outline& outline, std::size_t i) {
    return frame.toWorld(scaled(outline.points[i] + offsetOf(outline), frame.pose.scale));
}
constexpr int kWhole = -1;  // part index of the handle that moves a whole outline

template <class Outline>
Vec2 middleIn(const Frame& frame, const Outline& outline) {
    Vec2 sum;
    for (const Vec2 point : outline.points) sum += point;
    const Vec2 mean = sum / static_cast<float>(outline.points.size());
    return frame.toWorld(scaled(mean + offsetOf(outline), frame.pose.scale));
}

template <class Outline>
void addOutline(const Frame& frame, const ComponentState& state, std::vector<ShapeHandle>& spots) {
    const auto& outline = valueOf<Outline>(state);
    for (std::size_t i = 0; i < outline.points.size(); ++i) {
        spots.push_back(
            {cornerIn(frame, outline, i), state.type, static_cast<int>(i), ShapeHandleKind::Corner});
    }
    if (!outline.points.empty())
        spots.push_back({middleIn(frame, outline), state.type, kWhole, ShapeHandleKind::Middle});
}

template <class Outline>
void dragOutline(const Frame& frame, ComponentState& state, int part, Vec2 to) {
    auto& outline = valueOf<Outline>(state);
    if (part == kWhole) {
        const Vec2 by = to - frame.toTurned(middleIn(frame, outline));
        moveOffset(outline, frame.toScaled(by));
    } else {
        outline.points[static_cast<std::size_t>(part)] = frame.toScaled(to) - offsetOf(outline);
    }
}

template <class Outline>
void addOutlineEdges(const Frame& frame, const ComponentState& state, std::vector<ShapeEdge>& edges) {
    const auto& outline = valueOf<Outline>(state);
    const std::size_t count = outline.points.size();
    if (count < 2) return;
    for (std::size_t i = 0; i + 1 < count || (i < count && isClosed(outline)); ++i) {
        edges.push_back({cornerIn(frame, outline, i), cornerIn(frame, outline, (i + 1) % count), state.type,
                         static_cast<int>(i) + 1, !outline.points.full()});
    }
}

template <class Outline>
bool insertCorner(const Frame& frame, ComponentState& state, int part, Vec2 at) {
    auto& outline = valueOf<Outline>(state);
    if (outline.points.full()) return false;
    outline.points.push({});
    std::rotate(outline.points.begin() + part, outline.points.end() - 1, outline.points.end());
    dragOutline<Outline>(frame, state, part, frame.toTurned(at));
    return true;
}

template <class Outline>
bool takeCorner(ComponentState& state, int part) {
    auto& outline = valueOf<Outline>(state);
    if (part < 0 || outline.points.size() <= fewestCorners(outline)) return false;
    return outline.points.erase(static_cast<std::size_t>(part));
}

/// Functions for one type of collider. Positions are in turned coordinates, px.
struct ShapeRow {
    std::string_view type;
    void (*spots)(const Frame&, const ComponentState&, std::vector<ShapeHandle>&);
    void (*drag)(const Frame&, ComponentState&, int part, Vec2 to);
    void (*edges)(const Frame&, const ComponentState&, std::vector<ShapeEdge>&);
    bool (*insert)(const Frame&, ComponentState&, int part, Vec2 at) = nullptr;
    bool (*take)(ComponentState&, int part) = nullptr;
    /// Moves the shape relative to its entity. @param by  px, turned coordinates
    void (*shift)(const Frame&, ComponentState&, Vec2 by) = nullptr;
};

template <class Collider>
void shiftOffset(const Frame&, ComponentState& state, Vec2 by) {
    valueOf<Collider>(state).offset += by;
}
template <class Outline>
void shiftOutline(const Frame& frame, ComponentState& state, Vec2 by) {
    moveOffset(valueOf<Outline>(state), frame.toScaled(by));
}

constexpr std::array kShapes{
    ShapeRow{"BoxCollider", addBox<BoxCollider>, dragBox<BoxCollider>, addBoxEdges<BoxCollider>, nullptr,
             nullptr, shiftOffset<BoxCollider>},
    ShapeRow{"CapsuleCollider", addBox<CapsuleCollider>, dragBox<CapsuleCollider>,
             addBoxEdges<CapsuleCollider>, nullptr, nullptr, shiftOffset<CapsuleCollider>},
    ShapeRow{"CircleCollider", addCircle, dragCircle, addCircleEdges, nullptr, nullptr,
             shiftOffset<CircleCollider>},
    ShapeRow{"PolygonCollider", addOutline<PolygonCollider>, dragOutline<PolygonCollider>,
             addOutlineEdges<PolygonCollider>, insertCorner<PolygonCollider>, takeCorner<PolygonCollider>,
             shiftOutline<PolygonCollider>},
    ShapeRow{"ChainCollider", addOutline<ChainCollider>, dragOutline<ChainCollider>,
             addOutlineEdges<ChainCollider>, insertCorner<ChainCollider>, takeCorner<ChainCollider>,
             shiftOutline<ChainCollider>},
};

const ShapeRow* rowOf(const TypeInfo& type) {
    const auto* row = std::find_if(kShapes.begin(), kShapes.end(),
                                   [&](const ShapeRow& item) { return item.type == type.name; });
    return row == kShapes.end() ? nullptr : row;
}

Frame frameOf(const Document& document, ObjectId id) {
    return Frame{worldPose(document.world, document.find(id))};
}

// Joints: all components with the fields "anchor" and "otherAnchor".

constexpr int kOwnAnchor = 0;
constexpr int kOtherAnchor = 1;

bool isJoint(const TypeInfo& type) { return type.find("anchor") && type.find("otherAnchor"); }

template <class T>
T& fieldOf(ComponentState& state, std::string_view name) {
    return *static_cast<T*>(state.type->find(name)->in(static_cast<void*>(state.bytes.data())));
}
template <class T>
T fieldOf(const ComponentState& state, std::string_view name) {
    return *static_cast<const T*>(state.type->find(name)->in(static_cast<const void*>(state.bytes.data())));
}

/// Returns the frame of an anchor: that of the joint's entity, of the connected entity, or of the world if
/// the joint is connected to the world.
Frame anchorFrame(const Document& document, ObjectId id, const ComponentState& state, int part) {
    if (part == kOwnAnchor) return frameOf(document, id);
    const ObjectId other = fieldOf<ObjectId>(state, "other");
    return document.find(other) ? frameOf(document, other) : Frame{Pose{}};
}

void addAnchors(const Document& document, ObjectId id, const ComponentState& state,
                std::vector<ShapeHandle>& spots) {
    const auto add = [&](int part, std::string_view field) {
        const Frame frame = anchorFrame(document, id, state, part);
        spots.push_back(
            {frame.toWorld(fieldOf<Vec2>(state, field)), state.type, part, ShapeHandleKind::Anchor});
    };
    add(kOwnAnchor, "anchor");
    const bool follows = state.type->find("autoAnchor") != nullptr && fieldOf<bool>(state, "autoAnchor");
    if (!follows) add(kOtherAnchor, "otherAnchor");
}

// The pivot of a sprite.

Vec2 pictureSize(const Sprite& sprite, const Frame& frame) {
    return {static_cast<float>(sprite.width) * frame.pose.scale.x,
            static_cast<float>(sprite.height) * frame.pose.scale.y};
}

/// Moves the entity's origin to `to`; its sprite, colliders and children keep their world positions.
void dragPivot(const Document& document, ObjectId id, std::vector<ChangeStates::Change>& states, Vec2 to) {
    const EntityId entity = document.find(id);
    const auto startOf = [&](const TypeInfo& type) -> ComponentState& {
        return std::find_if(states.begin(), states.end(),
                            [&](const ChangeStates::Change& change) {
                                return change.object == id && change.state.type == &type;
                            })
            ->state;
    };
    auto& transform = valueOf<Transform>(startOf(document.types().of<Transform>()));
    const EntityId parent = parentOf(document.world, entity);
    const Pose outer = parent ? worldPose(document.world, parent) : Pose{};
    const Pose start = composed(outer, {transform.position, transform.rotation, transform.scale});
    const Frame before{start};
    const Vec2 by = before.toTurned(to);  // px, turned coordinates: displacement of the origin
    const Vec2 inScale = before.toScaled(by);
    for (ChangeStates::Change& change : states) {
        if (change.object != id) {
            valueOf<Transform>(change.state).position -= inScale;
        } else if (const ShapeRow* row = rowOf(*change.state.type)) {
            row->shift(before, change.state, -by);
        } else if (change.state.type->key == typeKey<Sprite>()) {
            auto& sprite = valueOf<Sprite>(change.state);
            const Vec2 size = pictureSize(sprite, before);
            if (size.x != 0.0f) sprite.pivot.x += by.x / size.x;
            if (size.y != 0.0f) sprite.pivot.y += by.y / size.y;
        }
    }
    transform.position = relativeTo(outer, {to, 0.0f, {1.0f, 1.0f}}).position;
}

}  // namespace

std::vector<ShapeHandle> spotsOf(const Document& document, ObjectId id) {
    std::vector<ShapeHandle> spots;
    const EntityId entity = document.find(id);
    const World& world = document.world;
    if (!world.has<Transform>(entity)) return spots;
    const Frame frame = frameOf(document, id);
    for (const TypeInfo& type : document.types().all()) {
        const ShapeRow* row = rowOf(type);
        if ((row == nullptr && !isJoint(type)) || !world.has(type, entity)) continue;
        const ComponentState state = readComponent(document, type, entity);
        row != nullptr ? row->spots(frame, state, spots) : addAnchors(document, id, state, spots);
    }
    addWaySpots(document, id, spots);
    // Dragging the pivot moves the entity's origin, which is fixed for the root of a prefab.
    if (world.has<Sprite>(entity) && id != prefabRootOf(document))
        spots.push_back({frame.pose.position, &document.types().of<Sprite>(), 0, ShapeHandleKind::Pivot});
    return spots;
}

std::vector<ShapeEdge> edgesOf(const Document& document, ObjectId id) {
    std::vector<ShapeEdge> edges;
    const EntityId entity = document.find(id);
    if (!document.world.has<Transform>(entity)) return edges;
    for (const TypeInfo& type : document.types().all()) {
        const ShapeRow* row = rowOf(type);
        if (row != nullptr && document.world.has(type, entity))
            row->edges(frameOf(document, id), readComponent(document, type, entity), edges);
    }
    return edges;
}

std::vector<ChangeStates::Change> statesBehind(const Document& document, ObjectId id,
                                               const ShapeHandle& spot) {
    const World& world = document.world;
    const EntityId entity = document.find(id);
    if (spot.kind != ShapeHandleKind::Pivot) return {{id, readComponent(document, *spot.type, entity)}};
    std::vector<ChangeStates::Change> states;
    const TypeInfo& transform = document.types().of<Transform>();
    for (const TypeInfo& type : document.types().all()) {
        const bool hangs = &type == spot.type || &type == &transform || rowOf(type) != nullptr;
        if (hangs && world.has(type, entity)) states.push_back({id, readComponent(document, type, entity)});
    }
    for (const ObjectId child : document.objects()) {
        const EntityId at = document.find(child);
        if (parentOf(world, at) == entity && world.has<Transform>(at))
            states.push_back({child, readComponent(document, transform, at)});
    }
    return states;
}

std::vector<ChangeStates::Change> draggedTo(const Document& document, ObjectId id, const ShapeHandle& spot,
                                            std::vector<ChangeStates::Change> start, Vec2 to) {
    ComponentState& state = start.front().state;
    if (spot.kind == ShapeHandleKind::Pivot) {
        dragPivot(document, id, start, to);
    } else if (spot.kind == ShapeHandleKind::Way) {
        dragWay(document, id, state, spot.part, to);
    } else if (spot.kind == ShapeHandleKind::Anchor) {
        const Frame frame = anchorFrame(document, id, state, spot.part);
        fieldOf<Vec2>(state, spot.part == kOwnAnchor ? "anchor" : "otherAnchor") = frame.toTurned(to);
    } else {
        const Frame frame = frameOf(document, id);
        rowOf(*spot.type)->drag(frame, state, spot.part, frame.toTurned(to));
    }
    return start;
}

std::optional<ComponentState> withCorner(const Document& document, ObjectId id, const ShapeEdge& edge,
                                         Vec2 at) {
    const ShapeRow* row = rowOf(*edge.type);
    ComponentState state = readComponent(document, *edge.type, document.find(id));
    if (row->insert == nullptr || !row->insert(frameOf(document, id), state, edge.part, at))
        return std::nullopt;
    return state;
}

std::optional<ComponentState> withoutCorner(const Document& document, ObjectId id,
                                            const ShapeHandle& corner) {
    const ShapeRow* row = rowOf(*corner.type);
    if (row == nullptr || row->take == nullptr) return std::nullopt;
    ComponentState state = readComponent(document, *corner.type, document.find(id));
    if (!row->take(state, corner.part)) return std::nullopt;
    return state;
}

}  // namespace plumb::editor
