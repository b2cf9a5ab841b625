#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "reflect/field_types.hpp"
#include "reflect/json_fields.hpp"

namespace plumb {

enum class LoopMode : std::uint8_t { Loop, Once, PingPong };

/// A frame of a clip: a cell of the sprite sheet and its duration.
struct AnimationFrame {
    int cellX = 0;  ///< column in the sheet
    int cellY = 0;  ///< row in the sheet
    float seconds = 0.1f;
    std::string event;  ///< emitted when the frame begins, e.g. "step"; empty: none

    friend bool operator==(const AnimationFrame&, const AnimationFrame&) = default;
};

/// A clip: a named sequence of frames.
struct Animation {
    std::string name;
    std::vector<AnimationFrame> frames;
    LoopMode loop = LoopMode::Loop;
    std::vector<KeptProperty> unknown = {};  ///< unknown members of the file, kept for writing

    friend bool operator==(const Animation&, const Animation&) = default;
};

enum class ParameterKind : std::uint8_t { Float, Bool, Trigger };

/// An input of the state machine, set by the game. Bools and triggers are 0 or 1; a trigger is reset to 0 by
/// the transition that uses it.
struct AnimationParameter {
    std::string name;
    ParameterKind kind = ParameterKind::Float;
    float initial = 0.0f;

    friend bool operator==(const AnimationParameter&, const AnimationParameter&) = default;
};

struct AnimationState {
    std::string name;
    int clip = 0;        ///< index in the clips
    float speed = 1.0f;  ///< ratio to the clip's speed; negative plays backwards

    friend bool operator==(const AnimationState&, const AnimationState&) = default;
};

enum class Comparison : std::uint8_t { Greater, Less, GreaterOrEqual, LessOrEqual, Equal, NotEqual };

struct AnimationCondition {
    int parameter = 0;  ///< index in the parameters
    Comparison is = Comparison::Greater;
    float value = 0.0f;

    friend bool operator==(const AnimationCondition&, const AnimationCondition&) = default;
};

struct AnimationTransition {
    static constexpr int kAnyState = -1;

    int from = kAnyState;                  ///< index in the states; kAnyState: from every state
    int to = 0;                            ///< index in the states
    std::vector<AnimationCondition> when;  ///< all conditions must be true
    bool afterEnd = false;                 ///< also requires that the clip has reached its end at least once

    friend bool operator==(const AnimationTransition&, const AnimationTransition&) = default;
};

/// The clips of a sprite sheet and a state machine that selects them. The first state is the initial one.
struct AnimationSet {
    static constexpr int kFormat = 1;
    static constexpr std::size_t kMaxClips = 1024;
    static constexpr std::size_t kMaxFrames = 4096;  ///< per clip
    static constexpr std::size_t kMaxParameters = 8;

    std::string image;    ///< path of the sprite sheet; empty for clips created by code
    TextureId texture;    ///< id of `image`
    int frameWidth = 0;   ///< px; 0: the Sprite's width
    int frameHeight = 0;  ///< px; 0: the Sprite's height
    std::vector<Animation> clips;
    std::vector<AnimationParameter> parameters;
    std::vector<AnimationState> states;  ///< empty: the game selects the clips
    std::vector<AnimationTransition> transitions;
    std::vector<KeptProperty> unknown;  ///< unknown members of the file, kept for writing

    /// Returns the index of the clip, state or parameter with this name; -1 if there is none.
    [[nodiscard]] int findClip(std::string_view name) const;
    [[nodiscard]] int findState(std::string_view name) const;
    [[nodiscard]] int findParameter(std::string_view name) const;

    friend bool operator==(const AnimationSet&, const AnimationSet&) = default;
};

/// Returns a set of clips created by code, without a state machine.
AnimationSet animationSetOf(std::vector<Animation> clips);

/// Sample clips for a player character with a sheet of four cells in one row: idle, run and jump.
extern const std::vector<Animation> playerAnimations;

/// Reads the text of an `*.anim.json` file. Invalid parts are reported in `problems` and ignored.
/// @param where  the file's path, for errors
/// @error        the text is not a JSON object, or has a newer format
Result<AnimationSet> parseAnimationSet(std::string_view json, std::string_view where,
                                       std::vector<Error>& problems);

/// Returns the text of an `*.anim.json` file; parseAnimationSet() of it returns an equal set.
std::string writeAnimationSet(const AnimationSet& set);

}  // namespace plumb
