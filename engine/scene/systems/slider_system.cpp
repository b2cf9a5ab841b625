#include "scene/systems/slider_system.hpp"

#include <cmath>
#include <optional>

#include "ecs/world.hpp"
#include "input/input.hpp"
#include "scene/components/drawing/hidden.hpp"
#include "scene/components/experiment.hpp"
#include "scene/components/transform.hpp"
#include "scene/lab.hpp"
#include "scene/number_field.hpp"
#include "scene/scene_stack.hpp"
#include "scene/slider_scale.hpp"

namespace plumb {

namespace {

bool isOver(const Slider& slider, Vec2 start, Vec2 mouse) {
    const float along = mouse.x - start.x;
    return along >= -kSliderKnob && along <= slider.width + kSliderKnob &&
           std::fabs(mouse.y - start.y) <= kSliderKnob;
}

/// @return true if the value has changed
bool writeTo(World& world, const NumberField& number, EntityId entity, float value) {
    const void* before = std::as_const(world).find(number.type(), entity);
    if (before == nullptr) return false;
    const float old = number.read(before);
    if (old == value) return false;
    void* component = world.find(number.type(), entity);
    number.write(component, value);
    // The initial state of an experiment gets the new value too.
    if (Lab* lab = world.findResource<Lab>()) {
        if (void* start = lab->startOf(entity, number.type().name)) number.write(start, value);
    }
    return number.read(component) != old;
}

bool set(World& world, const Slider& slider, float value) {
    if (world.types() == nullptr) return false;
    const auto number = NumberField::find(*world.types(), world.texts().find(slider.component),
                                          world.texts().find(slider.field));
    if (!number) return false;
    if (slider.target) return world.alive(slider.target) && writeTo(world, *number, slider.target, value);
    bool changed = false;
    world.eachOf(number->type(), [&](EntityId entity, const void*) {
        changed = writeTo(world, *number, entity, value) || changed;
    });
    return changed;
}

/// Handles the mouse for one slider. @param start  px, left end of the track
void follow(World& world, Slider& slider, Vec2 start, const Input& input) {
    if (input.isPressed(MouseButton::Left)) slider.held = isOver(slider, start, input.mouse());
    if (!slider.held) return;
    const float part = (input.mouse().x - start.x) / slider.width;
    if (set(world, slider, valueAt(slider, part))) world.resource<Lab>().sliderMoved = true;
    if (input.isHeld(MouseButton::Left)) return;
    slider.held = false;
    Lab& lab = world.resource<Lab>();
    lab.sliderReleased = lab.sliderMoved;
}

}  // namespace

void SliderSystem::update(World& world, float) {
    if (world.count<Slider>() == 0) return;
    if (Lab* lab = world.findResource<Lab>()) lab->sliderReleased = false;
    for (auto [entity, slider, transform] : world.query<Slider, const Transform>(without<Hidden>))
        follow(world, slider, transform.position, inputFor(world, entity));
}

}  // namespace plumb
