#pragma once

#include <vector>

#include "core/fixed_list.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

class World;
struct Animation;

/// Plays the clips of an animation file on the entity's Sprite, by hand or by the file's state machine.
struct Animator {
    static constexpr std::size_t kParameters = 8;

    AnimationId animation;
    int clip = 0;        ///< index in the animation; the state machine sets it
    float speed = 1.0f;  ///< ratio; negative plays backwards
    bool playing = true;
    bool loop = true;                          ///< false stops every clip after one turn
    int frame = 0;                             ///< index in the clip
    float timer = 0.0f;                        ///< s since the frame began
    int direction = 0;                         ///< 1 forth, -1 on the way back; 0 until the clip has begun
    bool ended = false;                        ///< a clip that plays once is over
    int state = 0;                             ///< of the state machine
    FixedList<float, kParameters> parameters;  ///< of the state machine; bools and triggers as 0 and 1

    Animator() = default;
    explicit Animator(AnimationId file) : animation{file} {}
    /// Clips made by code. They are kept by the world under an id made from what is in them.
    Animator(World& world, const std::vector<Animation>& clips);

    static void describe(TypeBuilder<Animator>& type) {
        type.name("Animator").doc("Plays the clips of an animation file on the entity's Sprite.");
        type.field<&Animator::animation>("animation").doc("The animation file.");
        type.field<&Animator::clip>("clip")
            .range(0.0f, 1023.0f)
            .doc("The clip at the start; a state machine chooses its own.");
        type.field<&Animator::speed>("speed")
            .unit(Unit::Ratio)
            .range(-10.0f, 10.0f)
            .doc("Negative plays backwards.");
        type.field<&Animator::playing>("playing").doc("Keeps the frame while false.");
        type.field<&Animator::loop>("loop").doc("False stops every clip after one turn.");
        type.field<&Animator::frame>("frame").transient();
        type.field<&Animator::timer>("timer").unit(Unit::Seconds).transient();
        type.field<&Animator::direction>("direction").transient();
        type.field<&Animator::ended>("ended").transient();
        type.field<&Animator::state>("state").transient();
        type.field<&Animator::parameters>("parameters").transient();
    }
};

}  // namespace plumb
