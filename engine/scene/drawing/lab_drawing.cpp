#include "scene/drawing/lab_drawing.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "core/text.hpp"
#include "ecs/paused.hpp"
#include "physics/debug_draw.hpp"
#include "scene/components/bodies/ghost.hpp"
#include "scene/components/drawing/hidden.hpp"
#include "scene/components/slider.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/drawing/plot_drawing.hpp"
#include "scene/lab.hpp"
#include "scene/number_field.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/scene_stack.hpp"
#include "scene/slider_scale.hpp"

namespace plumb {

namespace {

constexpr int kGhostLayer = 40;           // drawing layer of the outlines of ghosts
constexpr float kSliderTextSize = 15.0f;  // px
constexpr float kTextAbove = 30.0f;       // px, from the text's top to the track

/// Draws the outlines of one ghost in its colour.
class GhostCanvas final : public physics::DebugCanvas {
public:
    GhostCanvas(DrawList& list, PixelScale scale, const Ghost& ghost, Vec2 origin)
        : list_{list}, scale_{scale}, origin_{origin}, style_{ghost.color, 2.0f, kGhostLayer} {
        fill_ = ghost.color;
        fill_.a = static_cast<std::uint8_t>(fill_.a / 6);
    }

    void line(Vec2 from, Vec2 to, physics::DebugInk ink) override {
        if (isShown(ink)) list_.line(px(from), px(to), style_);
    }
    void circle(Vec2 centre, float radius, physics::DebugInk ink) override {
        if (!isShown(ink)) return;
        list_.filledCircle(px(centre), radius * scale_.pixels, fill_, kGhostLayer);
        list_.circle(px(centre), radius * scale_.pixels, style_);
    }
    void polygon(std::span<const Vec2> corners, physics::DebugInk ink) override {
        if (!isShown(ink) || corners.size() > corners_.size()) return;
        for (std::size_t i = 0; i < corners.size(); ++i) corners_[i] = px(corners[i]);
        const std::span<const Vec2> placed{corners_.data(), corners.size()};
        list_.filledPolygon(placed, fill_, kGhostLayer);
        list_.polygon(placed, style_);
    }
    void arrow(Vec2, Vec2, physics::DebugInk) override {}

private:
    /// Static and kinematic shapes are not drawn, as the scene shows them already.
    static bool isShown(physics::DebugInk ink) {
        return ink.role != physics::DebugRole::Fixed && ink.role != physics::DebugRole::Driven;
    }
    [[nodiscard]] Vec2 px(Vec2 metres) const { return origin_ + toPixels(metres, scale_); }

    DrawList& list_;
    PixelScale scale_;
    Vec2 origin_;
    ShapeStyle style_;
    Color fill_;
    std::array<Vec2, 64> corners_;
};

void drawGhosts(const World& world, const SceneView& how, DrawList& list) {
    const auto* ghosts = world.findResource<GhostWorlds>();
    const auto* state = world.findResource<PhysicsState>();
    if (ghosts == nullptr || state == nullptr) return;
    for (const GhostWorlds::One& one : ghosts->all) {
        const auto* ghost = world.find<Ghost>(one.ghost);
        if (ghost == nullptr || world.has<Hidden>(one.ghost) || one.made == 0) continue;
        GhostCanvas canvas{list, state->scale, *ghost, how.view.center + ghost->offset};
        physics::DebugOptions choice;
        choice.parts = physics::kDrawShapes;
        choice.origin = positionInMetres(how.view.center, state->scale);
        choice.behind =
            world.count<Paused>() > 0 ? 0.0f : (1.0f - how.alpha) * static_cast<float>(kSecondsPerTick);
        physics::debugDraw(one.world, canvas, choice);
    }
}

/// Returns the text beside a slider: its value, or an error.
std::string valueText(const World& world, const Slider& slider, const NumberField* number, float value) {
    if (number == nullptr)
        return format("no numeric field {}.{}", world.texts().find(slider.component),
                      world.texts().find(slider.field));
    if (number->field().kind == FieldKind::Bool) return value != 0.0f ? "on" : "off";
    for (const EnumName& name : number->field().names) {
        if (name.value == static_cast<int>(value)) return std::string{name.name};
    }
    const std::string_view unit = world.texts().find(slider.unit);
    return format("{}{}{}", roughNumber(value), unit.empty() ? "" : " ", unit);
}

/// Returns the current value of a slider; without a target that of the first entity with the component.
float valueOf(const World& world, const Slider& slider, const NumberField& number) {
    if (slider.target) {
        const auto* lab = world.findResource<Lab>();
        const void* component = lab != nullptr ? lab->startOf(slider.target, number.type().name) : nullptr;
        if (component == nullptr && world.alive(slider.target))
            component = world.find(number.type(), slider.target);
        return component != nullptr ? number.read(component) : 0.0f;
    }
    float value = 0.0f;
    bool found = false;
    world.eachOf(number.type(), [&](EntityId, const void* component) {
        if (!found) value = number.read(component);
        found = true;
    });
    return value;
}

void drawSlider(const World& world, const Slider& slider, Vec2 start, LabelDrawing& labels, DrawList& list) {
    const auto number = world.types() == nullptr
                            ? std::nullopt
                            : NumberField::find(*world.types(), world.texts().find(slider.component),
                                                world.texts().find(slider.field));
    const float value = number ? valueOf(world, slider, *number) : 0.0f;
    const Vec2 knob = start + Vec2{slider.width * partOf(slider, value), 0.0f};
    const auto bar = [&](float from, float to, Color color) {
        list.filledRect({{from, start.y - 2.0f}, {to, start.y + 2.0f}}, color, slider.layer);
    };
    Color faint = slider.color;
    faint.a = static_cast<std::uint8_t>(faint.a / 4);
    bar(start.x, start.x + slider.width, faint);
    bar(start.x, knob.x, slider.color);
    list.filledCircle(knob, slider.held ? kSliderKnob + 2.0f : kSliderKnob, slider.color, slider.layer);
    TextStyle style;
    style.shape.size = kSliderTextSize;
    style.color = slider.color;
    style.layer = slider.layer;
    labels.write(world.texts().find(slider.text), start - Vec2{0.0f, kTextAbove}, style, list);
    style.shape.align = TextAlign::Right;
    labels.write(valueText(world, slider, number ? &*number : nullptr, value),
                 start + Vec2{slider.width, -kTextAbove}, style, list);
}

Vec2 cornerOf(const SceneView& how) {
    return how.parallax ? how.view.center - how.view.size * (0.5f / how.view.zoom) : Vec2{};
}

}  // namespace

void drawLab(const World& world, const SceneView& how, LabelDrawing& labels, DrawList& list) {
    if (how.place <= 0) drawGhosts(world, how, list);
    for (auto [entity, slider, transform] :
         world.query<const Slider, const Transform>(without<Hidden>, withPaused)) {
        if (isSeen(world, entity, how))
            drawSlider(world, slider, cornerOf(how) + transform.position, labels, list);
    }
    for (auto [entity, plot, transform] :
         world.query<const Plot, const Transform>(without<Hidden>, withPaused)) {
        if (isSeen(world, entity, how))
            drawPlot(world, entity, plot, cornerOf(how) + transform.position, labels, list);
    }
}

}  // namespace plumb
