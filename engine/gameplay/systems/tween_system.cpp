#include "gameplay/systems/tween_system.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "ecs/world.hpp"
#include "gameplay/tweens.hpp"

namespace plumb {
namespace {

void setValue(const Tweens::Entry& tween, std::byte* field, const std::array<float, 4>& value) {
    if (tween.kind == Tweens::Kind::Color) {
        for (std::size_t i = 0; i < 4; ++i)
            field[i] = static_cast<std::byte>(std::clamp(std::floor(value[i] + 0.5f), 0.0f, 255.0f));
    } else {
        std::memcpy(field, value.data(), tween.kind == Tweens::Kind::Float ? sizeof(float) : sizeof(Vec2));
    }
}

/// @return false if the tween has ended
bool advance(World& world, const Tweens::Entry& tween) {
    std::byte* field = fieldOf(world, tween);
    if (field == nullptr) return false;
    const std::uint64_t passed = world.tick - tween.start;
    const float part = eased(tween.ease, static_cast<float>(passed) / static_cast<float>(tween.ticks));
    std::array<float, 4> value = tween.to;
    if (passed < tween.ticks) {
        for (std::size_t i = 0; i < 4; ++i) value[i] = tween.from[i] + (tween.to[i] - tween.from[i]) * part;
    }
    setValue(tween, field, value);
    if (passed < tween.ticks) return true;
    world.emit(TweenEnded{tween.entity});
    return false;
}

}  // namespace

void TweenSystem::update(World& world, float) {
    auto* tweens = world.findResource<Tweens>();
    if (tweens == nullptr) return;
    std::erase_if(tweens->entries, [&](const Tweens::Entry& tween) { return !advance(world, tween); });
}

}  // namespace plumb
