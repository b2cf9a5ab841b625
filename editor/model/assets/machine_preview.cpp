#include "editor/model/assets/machine_preview.hpp"

#include <algorithm>
#include <utility>

#include "scene/components/drawing/animator.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/systems/animation_system.hpp"

namespace plumb::editor {
namespace {

constexpr int kMostSteps = 6;  // per frame; the preview slows down rather than catch up after a slow frame

template <class T>
const T* itemAt(const std::vector<T>& items, int index) {
    const bool there = index >= 0 && index < static_cast<int>(items.size());
    return there ? &items[static_cast<std::size_t>(index)] : nullptr;
}

}  // namespace

MachinePreview::MachinePreview(AssetStore& assets) : assets_{assets} {
    world_.provide(assets_);
    entity_ = world_.createEntity().id();
    world_.add<Sprite>(entity_);
    restart();
}

void MachinePreview::show(AnimationId animation) {
    if (std::exchange(animation_, animation) != animation) restart();
}

void MachinePreview::restart() {
    world_.add<Animator>(entity_, Animator{animation_});
    parameters_ = set().parameters;
    for (const AnimationParameter& parameter : parameters_) {
        FixedList<float, Animator::kParameters>& values = world_.get<Animator>(entity_).parameters;
        if (!values.full()) values.push(parameter.initial);
    }
    rest_ = kStep;  // the next advance() makes one step, which shows the first frame
}

void MachinePreview::advance(double seconds) {
    follow();
    rest_ = std::min(rest_ + seconds, kStep * kMostSteps);
    for (; rest_ >= kStep; rest_ -= kStep) {
        world_.beginTick();
        AnimationSystem{}.update(world_, static_cast<float>(kStep));
    }
}

/// Applies changes of the file's parameters; parameters with the same name and kind keep their values.
void MachinePreview::follow() {
    if (parameters_ == set().parameters) return;
    const std::vector<AnimationParameter> before = std::exchange(parameters_, set().parameters);
    auto& values = world_.get<Animator>(entity_).parameters;
    const auto old = values;
    values = {};
    for (const AnimationParameter& parameter : parameters_) {
        const auto known = std::find_if(before.begin(), before.end(), [&](const AnimationParameter& was) {
            return was.name == parameter.name && was.kind == parameter.kind;
        });
        const auto index = static_cast<std::size_t>(known - before.begin());
        if (!values.full())
            values.push(known != before.end() && index < old.size() ? old[index] : parameter.initial);
    }
}

void MachinePreview::enter(int state) {
    auto& animator = world_.get<Animator>(entity_);
    animator.state = state;
    animator.clip = -1;  // restarts the clip
    animator.ended = false;
    rest_ = std::max(rest_, kStep);
}

int MachinePreview::state() const {
    const int state = world_.get<Animator>(entity_).state;
    return itemAt(set().states, state) == nullptr ? -1 : state;
}

const AnimationFrame* MachinePreview::frame() const {
    const auto& animator = world_.get<Animator>(entity_);
    const Animation* clip = itemAt(set().clips, animator.clip);
    return clip == nullptr ? nullptr : itemAt(clip->frames, animator.frame);
}

float MachinePreview::value(int parameter) const {
    const auto& values = world_.get<Animator>(entity_).parameters;
    const auto index = static_cast<std::size_t>(parameter);
    return parameter >= 0 && index < values.size() ? values[index] : 0.0f;
}

void MachinePreview::setValue(int parameter, float value) {
    follow();
    auto& values = world_.get<Animator>(entity_).parameters;
    const auto index = static_cast<std::size_t>(parameter);
    if (parameter >= 0 && index < values.size()) values[index] = value;
}

}  // namespace plumb::editor
