#include "scene/drawing/physics_drawing.hpp"

#include <algorithm>
#include <array>

#include "physics/debug_draw.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/physics_bridge.hpp"
#include "scene/scene_stack.hpp"

namespace plumb {
namespace {

using physics::DebugInk;
using physics::DebugRole;

/// Appearance of a DebugRole. Dots mark points, so they have a fixed size on the screen.
struct Look {
    Color color;
    float thickness = 1.5f;  // px of the screen
    float dot = 0.0f;        // px of the screen, radius of dots; 0: circles have their own radius
    std::uint8_t fill = 0;   // opacity of filled areas
};

constexpr Look lookOf(DebugRole role) {
    switch (role) {
        case DebugRole::Fixed: return {{96, 196, 118, 255}, 1.5f, 0.0f, 26};
        case DebugRole::Driven: return {{86, 156, 255, 255}, 1.5f, 0.0f, 40};
        case DebugRole::Awake: return {{255, 255, 255, 255}, 1.5f, 0.0f, 40};
        case DebugRole::Asleep: return {{150, 156, 172, 255}, 1.5f, 0.0f, 40};
        case DebugRole::Soft: return {{232, 200, 150, 255}};
        case DebugRole::Trigger: return {{198, 132, 255, 255}, 1.5f, 0.0f, 26};
        case DebugRole::Visitor: return {{198, 132, 255, 200}};
        case DebugRole::Bounds: return {{255, 236, 170, 160}, 1.0f};
        case DebugRole::BroadPhase: return {{255, 170, 90, 170}, 1.0f};
        case DebugRole::Region: return {{110, 150, 255, 130}, 1.0f};
        case DebugRole::Contact: return {{255, 72, 72, 255}, 1.5f, 3.0f, 255};
        case DebugRole::Normal: return {{255, 128, 128, 255}};
        case DebugRole::Impulse: return {{255, 226, 64, 255}, 2.0f};
        case DebugRole::Friction: return {{255, 150, 40, 255}, 2.0f};
        case DebugRole::Joint: return {{255, 104, 190, 255}, 1.5f, 3.0f, 255};
        case DebugRole::JointLimit: return {{255, 104, 190, 160}};
        case DebugRole::JointForce: return {{255, 190, 225, 255}, 2.0f};
        case DebugRole::Velocity: return {{64, 224, 240, 255}, 2.0f};
        case DebugRole::Path: return {{120, 200, 255, 200}, 1.0f};
        case DebugRole::Centre: return {{255, 255, 255, 255}, 1.5f, 2.0f, 255};
        case DebugRole::Island: return {{255, 255, 255, 255}, 0.0f, 0.0f, 150};
        case DebugRole::Rest: return {{96, 112, 255, 255}, 1.0f, 0.0f, 90};
        case DebugRole::Sweep: return {{120, 255, 180, 255}, 1.0f};
        case DebugRole::Impact: return {{255, 90, 30, 255}, 1.5f, 3.0f, 255};
        case DebugRole::Field: return {{190, 232, 90, 255}, 1.5f, 0.0f, 16};
        case DebugRole::Count: break;
    }
    return {};
}

constexpr auto kLooks = [] {
    std::array<Look, static_cast<std::size_t>(DebugRole::Count)> looks{};
    for (std::size_t i = 0; i < looks.size(); ++i) looks[i] = lookOf(static_cast<DebugRole>(i));
    return looks;
}();
const Look& lookFor(DebugInk ink) { return kLooks[static_cast<std::size_t>(ink.role)]; }

constexpr Color kIslandColors[] = {{230, 85, 75, 255},   {245, 160, 55, 255}, {225, 215, 70, 255},
                                   {110, 200, 80, 255},  {60, 200, 190, 255}, {80, 140, 245, 255},
                                   {150, 105, 235, 255}, {235, 110, 190, 255}};
constexpr Color kShadow{0, 0, 0, 150};  // below lines, so that they are visible on any background

constexpr float kDot = 4.0f;  // px of the screen: smaller shapes are drawn as dots

// Drawing layers: areas below shadows below strokes. Each layer is one draw call.
constexpr int kAreas = 0;
constexpr int kShadows = 1;
constexpr int kStrokes = 2;

constexpr PhysicsColor row(std::string_view label, DebugRole role, unsigned layer) {
    return {label, lookOf(role).color, layer};
}

constexpr std::array kColors{
    row("static", DebugRole::Fixed, physics::kDrawShapes),
    row("kinematic", DebugRole::Driven, physics::kDrawShapes),
    row("awake", DebugRole::Awake, physics::kDrawShapes),
    row("asleep", DebugRole::Asleep, physics::kDrawShapes),
    row("trigger", DebugRole::Trigger, physics::kDrawTriggers),
    row("contact", DebugRole::Contact, physics::kDrawContacts),
    row("normal", DebugRole::Normal, physics::kDrawNormals),
    row("impulse", DebugRole::Impulse, physics::kDrawImpulses),
    row("friction", DebugRole::Friction, physics::kDrawFriction),
    row("joint", DebugRole::Joint, physics::kDrawJoints),
    row("joint force", DebugRole::JointForce, physics::kDrawJointForces),
    row("velocity", DebugRole::Velocity, physics::kDrawVelocities),
    row("path", DebugRole::Path, physics::kDrawPaths),
    row("centre", DebugRole::Centre, physics::kDrawCentres),
    PhysicsColor{"island", kIslandColors[1], physics::kDrawIslands},
    row("field", DebugRole::Field, physics::kDrawFields),
    row("near sleep", DebugRole::Rest, physics::kDrawRest),
    row("sweep", DebugRole::Sweep, physics::kDrawSweeps),
    row("stopped", DebugRole::Impact, physics::kDrawSweeps),
    row("bounds", DebugRole::Bounds, physics::kDrawBounds),
    row("broad phase", DebugRole::BroadPhase, physics::kDrawBroadPhase),
    row("nodes, cells", DebugRole::Region, physics::kDrawBroadPhase),
};

/// Returns the colour of a stroke. Islands with consecutive numbers get colours that are easy to distinguish.
Color colorOf(DebugInk ink) {
    if (ink.role != DebugRole::Island) return lookFor(ink).color;
    return kIslandColors[(ink.island * 3u + ink.island / 8u) % std::size(kIslandColors)];
}

/// Canvas that adds the strokes (m, from the center of the view) to a draw list.
class ListCanvas final : public physics::DebugCanvas {
public:
    ListCanvas(DrawList& list, PixelScale scale, float pixel, std::vector<Vec2>& corners,
               std::vector<SpriteInstance>& dots)
        : list_{list}, scale_{scale}, pixel_{pixel}, corners_{corners}, dots_{dots} {
        dots_.clear();
        dot_.uv = {uvFromTexels(0.0f), uvFromTexels(0.0f), uvFromTexels(1.0f), uvFromTexels(1.0f)};
        dotSize_ = kDot * onePixel() / scale.pixels;
    }

    void line(Vec2 from, Vec2 to, DebugInk ink) override {
        stroke(ink, [&](const ShapeStyle& style) { list_.line(px(from), px(to), style); });
    }
    void arrow(Vec2 from, Vec2 to, DebugInk ink) override {
        stroke(ink, [&](const ShapeStyle& style) {
            if (style.layer == kShadows) return list_.line(px(from), px(to), style);
            list_.arrow(px(from), px(to), style);
        });
    }
    void circle(Vec2 centre, float radius, DebugInk ink) override {
        const Look& look = lookFor(ink);
        if (look.dot > 0.0f) return dot(px(centre), look.dot * onePixel(), look.color);
        const float wide = radius * scale_.pixels;
        fill(ink, [&](Color color) { list_.filledCircle(px(centre), wide, color, kAreas); });
        stroke(ink, [&](const ShapeStyle& style) { list_.circle(px(centre), wide, style); });
    }
    void polygon(std::span<const Vec2> corners, DebugInk ink) override {
        if (corners.empty()) return;
        if (const AABB box = boxOf(corners); isDot(box)) return dot(box, ink);
        corners_.clear();
        for (const Vec2 corner : corners) corners_.push_back(px(corner));
        fill(ink, [&](Color color) { list_.filledPolygon(corners_, color, kAreas); });
        stroke(ink, [&](const ShapeStyle& style) { list_.polygon(corners_, style); });
    }
    void box(const AABB& box, DebugInk ink) override {
        isDot(box) ? dot(box, ink) : DebugCanvas::box(box, ink);
    }

    /// Adds all collected dots to the list at once.
    void finish() {
        const std::span<SpriteInstance> room = list_.beginRun(dots_.size());
        std::copy(dots_.begin(), dots_.end(), room.begin());
        list_.endRun(dots_.size(), {}, kStrokes);
        dots_.clear();
    }

private:
    static AABB boxOf(std::span<const Vec2> corners) {
        AABB box{corners.front(), corners.front()};
        for (const Vec2 corner : corners) box = {min(box.min, corner), max(box.max, corner)};
        return box;
    }
    /// True if a shape is smaller than the width of its lines.
    [[nodiscard]] bool isDot(const AABB& box) const {
        const Vec2 size = box.size();
        return size.x < dotSize_ && size.y < dotSize_;
    }
    /// Collects a dot for finish(), as there are tens of thousands of dots when a whole level is in view.
    void dot(const AABB& box, DebugInk ink) {
        dot_.center = px(box.center());
        dot_.half = toPixels(box.size() * 0.5f, scale_);
        dot_.tint = colorOf(ink);
        dots_.push_back(dot_);
    }
    [[nodiscard]] Vec2 px(Vec2 metres) const { return list_.view().center + toPixels(metres, scale_); }
    /// Returns the size of a screen px in world px.
    [[nodiscard]] float onePixel() const { return pixel_ / list_.view().zoom; }

    template <class Draw>
    void stroke(DebugInk ink, Draw&& draw) {
        const Look& look = lookFor(ink);
        if (look.thickness == 0.0f) return;
        const Color color = colorOf(ink);
        // Translucent strokes have no shadow.
        if (color.a == 255) draw(ShapeStyle{kShadow, (look.thickness + 2.0f) * pixel_, kShadows});
        draw(ShapeStyle{color, look.thickness * pixel_, kStrokes});
    }
    template <class Draw>
    void fill(DebugInk ink, Draw&& draw) const {
        Color color = colorOf(ink);
        color.a = lookFor(ink).fill;
        if (color.a > 0) draw(color);
    }
    void dot(Vec2 place, float radius, Color color) {
        const auto square = [&](float half, Color ink, int layer) {
            list_.filledRect({place - Vec2{half, half}, place + Vec2{half, half}}, ink, layer);
        };
        square(radius + onePixel(), kShadow, kShadows);
        square(radius, color, kStrokes);
    }

    DrawList& list_;
    PixelScale scale_;
    float pixel_;
    std::vector<Vec2>& corners_;
    std::vector<SpriteInstance>& dots_;
    SpriteInstance dot_;    // values that all dots have in common
    float dotSize_ = 0.0f;  // m, size in the world that kDot px of the screen show
};

}  // namespace

std::span<const PhysicsColor> physicsColors() { return kColors; }

void PhysicsDrawing::markSelected(const PhysicsState& state, std::span<const EntityId> selected) {
    selectedUsers_.clear();
    for (const EntityId entity : selected) selectedUsers_.push_back(userOf(entity));
    std::sort(selectedUsers_.begin(), selectedUsers_.end());
    const auto isSelected = [&](std::uint64_t user) {
        return std::binary_search(selectedUsers_.begin(), selectedUsers_.end(), user);
    };
    const physics::Bodies& bodies = state.world.bodies;
    selectedBodies_.assign(bodies.size(), 0);
    for (std::size_t body = 0; body < bodies.size(); ++body)
        selectedBodies_[body] = isSelected(bodies.info[body].user) ? 1 : 0;
    const auto chooseFrom = [&](const auto& links, std::size_t count, auto idOf, auto& chosen) {
        chosen.assign(count, 0);
        for (const auto& link : links) {
            if (idOf(link).index < count && isSelected(userOf(link.entity))) chosen[idOf(link).index] = 1;
        }
    };
    chooseFrom(
        state.fields, state.world.fields.all.size(), [](const FieldLinkage& link) { return link.field; },
        selectedFields_);
    chooseFrom(
        state.softBodies, state.world.softBodies.all.size(),
        [](const SoftLinkage& link) { return link.body; }, selectedSoft_);
}

void PhysicsDrawing::draw(const World& world, const PhysicsShown& shown, float behind, float pixel,
                          DrawList& list) {
    auto* running = world.findResource<PhysicsState>();
    const PhysicsState* state = lowestPhysics(world);
    if (state == nullptr || shown.any() == 0) return;
    ListCanvas canvas{list, state->scale, pixel, corners_, dots_};
    physics::DebugOptions choice;
    choice.origin = positionInMetres(list.view().center, state->scale);
    choice.behind = behind;
    const AABB visible = visibleBox(list.view());
    const Vec2 origin = list.view().center;
    const AABB sight{toMetres(visible.min - origin, state->scale),
                     toMetres(visible.max - origin, state->scale)};
    choice.sight = &sight;
    const Vec2 dot{kDot * pixel / list.view().zoom, 0.0f};  // px of the world
    choice.minimum = toMetres(dot, state->scale).x;
    choice.lastStep = state == running ? physics::lastStepOf(running->world) : nullptr;
    choice.parts = shown.layers & physics::kDrawAll;
    debugDraw(state->world, canvas, choice);
    choice.parts = shown.ofSelected & physics::kDrawAll;
    if (choice.parts != 0 && !shown.selected.empty()) {
        markSelected(*state, shown.selected);
        choice.selectedOnly = true;
        choice.bodies = selectedBodies_;
        choice.fields = selectedFields_;
        choice.softBodies = selectedSoft_;
        debugDraw(state->world, canvas, choice);
    }
    canvas.finish();
}

void previewPhysics(World& world) {
    constexpr float kTick = 1.0f / 60.0f;  // s
    // Editors write components without recording the change, so treat everything as changed.
    PhysicsState& state = world.resource<PhysicsState>();
    state.members = {};
    state.mark = 0;
    syncBodies(world, kTick);
}

}  // namespace plumb
