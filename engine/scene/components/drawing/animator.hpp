#pragma once

#include <vector>

#include "core/fixed_list.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

class World;
struct Animation;

/// Plays the clips of an animation file on the entity's
/// Sprite. Game code or the file's state machine selects the clip.
struct Animator {
    static constexpr std::size_t kParameters = 8;  ///< maximum number of state machine parameters

    AnimationId animation;
    int clip = 0;        ///< index of the clip in the animation; a state machine sets it
    float speed = 1.0f;  ///< playback speed (ratio); negative plays backwards
    bool playing = true;
    bool loop = true;                          ///< false: every clip plays once, then stops
    int frame = 0;                             ///< index of the frame in the clip
    float timer = 0.0f;                        ///< s since the frame was first shown
    int direction = 0;                         ///< playback: 1 forward, -1 backward; 0: clip not started yet
    bool ended = false;                        ///< a clip that plays once has finished
    int state = 0;                             ///< index of the state in the state machine
    FixedList<float, kParameters> parameters;  ///< values of the parameters; bools and triggers: 0 or 1

    Animator() = default;
    explicit Animator(AnimationId file) : animation{file} {}
    /// Makes an animation from clips defined in code. The asset
    /// store keeps it under an id computed from its content.
    Animator(World& world, const std::vector<Animation>& clips);

    static void describe(TypeBuilder<Animator>& type) {
        type.name("Animator").doc("Plays the clips of an animation file on the entity's Sprite.");
        type.field<&Animator::animation>("animation").doc("Animation file to play.");
        type.field<&Animator::clip>("clip")
            .range(0.0f, 1023.0f)
            .doc("Index of the clip to play; a state machine in the file selects the clip instead.");
        type.field<&Animator::speed>("speed")
            .unit(Unit::Ratio)
            .range(-10.0f, 10.0f)
            .doc("Playback speed as a ratio; negative plays backwards.");
        type.field<&Animator::playing>("playing").doc("Plays the clip; off keeps the current frame.");
        type.field<&Animator::loop>("loop").doc("Repeats clips; off plays every clip once, then stops.");
        type.field<&Animator::frame>("frame").transient();
        type.field<&Animator::timer>("timer").unit(Unit::Seconds).transient();
        type.field<&Animator::direction>("direction").transient();
        type.field<&Animator::ended>("ended").transient();
        type.field<&Animator::state>("state").transient();
        type.field<&Animator::parameters>("parameters").transient();
    }
};

}  // namespace plumb
