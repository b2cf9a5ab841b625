#include "scene/systems/animation_system.hpp"

#include "assets/asset_store.hpp"
#include "assets/clip_cursor.hpp"
#include "scene/components/drawing/animator.hpp"
#include "scene/components/drawing/sprite.hpp"

namespace plumb {
namespace {

/// Advances the state machine, which selects the clip. @return playback speed of the state (ratio)
float chooseClip(const AnimationSet& set, Animator& animator) {
    if (set.states.empty()) return 1.0f;
    while (animator.parameters.size() < set.parameters.size() && !animator.parameters.full()) {
        animator.parameters.push(set.parameters[animator.parameters.size()].initial);
    }
    const auto last = static_cast<int>(set.states.size()) - 1;
    animator.state = animator.state < 0 ? 0 : animator.state > last ? last : animator.state;
    const std::span<float> parameters{animator.parameters.begin(), animator.parameters.size()};
    animator.state = advanceStateMachine(set, animator.state, parameters, animator.ended);
    const AnimationState& state = set.states[static_cast<std::size_t>(animator.state)];
    if (state.clip != animator.clip) {
        animator.clip = state.clip;
        animator.frame = 0;
        animator.timer = 0.0f;
        animator.direction = 0;
        animator.ended = false;
    }
    return state.speed;
}

void showFrame(const AnimationSet& set, const AnimationFrame& frame, Sprite& sprite) {
    if (!set.texture.empty()) sprite.texture = set.texture;
    if (set.frameWidth > 0) sprite.width = set.frameWidth;
    if (set.frameHeight > 0) sprite.height = set.frameHeight;
    sprite.source = {};
    sprite.frameX = frame.cellX;
    sprite.frameY = frame.cellY;
}

}  // namespace

void AnimationSystem::update(World& world, float dt) {
    const AssetStore* assets = world.service<AssetStore>();
    if (assets == nullptr) return;
    for (auto [entity, animator, sprite] : world.query<Animator, Sprite>()) {
        const AnimationSet& set = assets->animation(animator.animation);
        const float stateSpeed = chooseClip(set, animator);
        if (animator.clip < 0 || animator.clip >= static_cast<int>(set.clips.size())) continue;
        const Animation& clip = set.clips[static_cast<std::size_t>(animator.clip)];
        if (clip.frames.empty()) continue;
        if (animator.playing) {
            ClipCursor cursor{animator.frame, animator.timer, animator.direction, animator.ended};
            const LoopMode mode = animator.loop ? clip.loop : LoopMode::Once;
            const EntityId self = entity.id();
            advanceClip(clip, mode, cursor, dt * animator.speed * stateSpeed, [&](int frame) {
                const std::string& event = clip.frames[static_cast<std::size_t>(frame)].event;
                if (!event.empty()) world.emit(AnimationFrameBegan{self, textId(event)});
            });
            animator.frame = cursor.frame;
            animator.timer = cursor.timer;
            animator.direction = cursor.direction;
            animator.ended = cursor.ended;
        }
        const auto at =
            static_cast<std::size_t>(animator.frame < 0 ? 0 : animator.frame) % clip.frames.size();
        showFrame(set, clip.frames[at], sprite);
    }
}

}  // namespace plumb
