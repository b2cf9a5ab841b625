#include "input/input.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/log.hpp"

namespace plumb {
namespace {

bool anyHeld(const std::vector<Binding>& bindings, const InputFrame& frame, float deadZone) {
    return std::any_of(bindings.begin(), bindings.end(),
                       [&](Binding binding) { return isHeld(binding, frame, deadZone); });
}

float pushOf(const AxisBindings& axis, const InputFrame& frame, float deadZone) {
    const int keys =
        (anyHeld(axis.positive, frame, deadZone) ? 1 : 0) - (anyHeld(axis.negative, frame, deadZone) ? 1 : 0);
    if (keys != 0) return static_cast<float>(keys);
    float strongest = 0.0f;
    for (const Binding binding : axis.analog) {
        const float strength = strengthOf(binding, frame, deadZone);
        if (std::abs(strength) > std::abs(strongest)) strongest = strength;
    }
    return strongest;
}

}  // namespace

Input::Input(ActionMap map) { setMap(std::move(map)); }

void Input::setMap(ActionMap map) {
    map_ = std::move(map);
    map_.actions.resize(std::min(map_.actions.size(), ActionMap::kMaxActions));
    map_.axes.resize(std::min(map_.axes.size(), ActionMap::kMaxAxes));
    actionIds_.clear();
    axisIds_.clear();
    for (const ActionBindings& action : map_.actions) actionIds_.push_back(textId(action.name).value);
    for (const AxisBindings& axis : map_.axes) axisIds_.push_back(textId(axis.name).value);
    restore(previous_, frame_);
}

Input::State Input::evaluate(const InputFrame& frame) const {
    State state;
    for (std::size_t i = 0; i < map_.actions.size(); ++i) {
        if (anyHeld(map_.actions[i].bindings, frame, map_.deadZone)) state.held |= std::uint64_t{1} << i;
    }
    for (std::size_t i = 0; i < map_.axes.size(); ++i)
        state.axes[i] = pushOf(map_.axes[i], frame, map_.deadZone);
    return state;
}

void Input::advance(const InputFrame& next) {
    previous_ = std::exchange(frame_, next);
    before_ = std::exchange(now_, evaluate(next));
    if (!logging) return;
    for (std::size_t i = 0; i < map_.actions.size(); ++i) {
        if ((now_.held & ~before_.held) >> i & 1) logNote("Input", "{} pressed", map_.actions[i].name);
    }
}

void Input::archive(StateArchive& archive) {
    InputFrame before = previous_, now = frame_;
    archive.value(before);
    archive.value(now);
    if (archive.reading()) restore(before, now);
}

void Input::restore(const InputFrame& previous, const InputFrame& current) {
    previous_ = previous;
    frame_ = current;
    before_ = evaluate(previous);
    now_ = evaluate(current);
}

bool Input::isIn(std::uint64_t actions, Action action) const {
    for (std::size_t i = 0; i < actionIds_.size(); ++i) {
        if (actionIds_[i] != action.id.value) continue;
        asked_.actions |= std::uint64_t{1} << i;
        return (actions >> i & 1) != 0;
    }
    return false;
}

bool Input::isPressed(Action action) const { return isIn(now_.held & ~before_.held, action); }
bool Input::isHeld(Action action) const { return isIn(now_.held, action); }
bool Input::isReleased(Action action) const { return isIn(before_.held & ~now_.held, action); }

float Input::getAxis(Axis axis) const {
    for (std::size_t i = 0; i < axisIds_.size(); ++i) {
        if (axisIds_[i] != axis.id.value) continue;
        asked_.axes |= std::uint64_t{1} << i;
        return now_.axes[i];
    }
    return 0.0f;
}

}  // namespace plumb
