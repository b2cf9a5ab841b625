#include "gameplay/systems/sound_cue_system.hpp"

#include "ecs/world.hpp"
#include "gameplay/sound_cue.hpp"
#include "scene/systems/animation_system.hpp"

namespace plumb {

void SoundCueSystem::update(World& world, float) {
    constexpr TextId kStep = textId("step");
    for (const AnimationFrameBegan& frame : world.events<AnimationFrameBegan>()) {
        if (frame.event == kStep) playCue(world, frame.entity, &SoundCues::step);
    }
}

}  // namespace plumb
