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

/// One picture of a clip: a cell of the sheet and how long it shows.
struct AnimationFrame {
    int cellX = 0;  ///< column in the sheet
    int cellY = 0;  ///< row in the sheet
    float seconds = 0.1f;
    std::string event;  ///< emitted when the frame begins, e.g. "step"; empty for none

    friend bool operator==(const AnimationFrame&, const AnimationFrame&) = default;
};

/// A clip: frames in order.
struct Animation {
    std::string name;
    std::vector<AnimationFrame> frames;
    LoopMode loop = LoopMode::Loop;
    std::vector<KeptProperty> unknown =
        {};  ///< what the file said and this program does not know; written back

    friend bool operator==(const Animation&, const Animation&) = default;
};

enum class ParameterKind : std::uint8_t { Float, Bool, Trigger };

/// What the game tells the state machine. Bools and triggers are 0 and 1; a trigger falls back to 0 once it
/// is used.
struct AnimationParameter {
    std::string name;
    ParameterKind kind = ParameterKind::Float;
    float initial = 0.0f;

    friend bool operator==(const AnimationParameter&, const AnimationParameter&) = default;
};

struct AnimationState {
    std::string name;
    int clip = 0;        ///< index in the clips
    float speed = 1.0f;  ///< ratio; negative plays backwards

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

    int from = kAnyState;                  ///< index in the states
    int to = 0;                            ///< index in the states
    std::vector<AnimationCondition> when;  ///< all must hold
    bool afterEnd = false;                 ///< and the clip has reached its end at least once

    friend bool operator==(const AnimationTransition&, const AnimationTransition&) = default;
};

/// The clips of one sheet, and the state machine that chooses among them. The first state is the start.
struct AnimationSet {
    static constexpr int kFormat = 1;
    static constexpr std::size_t kMaxClips = 1024;
    static constexpr std::size_t kMaxFrames = 4096;  ///< of one clip
    static constexpr std::size_t kMaxParameters = 8;

    std::string image;    ///< path of the sheet; empty for clips made by code
    TextureId texture;    ///< of `image`
    int frameWidth = 0;   ///< px; 0 keeps the Sprite's own
    int frameHeight = 0;  ///< px
    std::vector<Animation> clips;
    std::vector<AnimationParameter> parameters;
    std::vector<AnimationState> states;  ///< none: clips are chosen by hand
    std::vector<AnimationTransition> transitions;
    std::vector<KeptProperty> unknown;

    /// Index of what has this name; -1 when nothing has.
    [[nodiscard]] int findClip(std::string_view name) const;
    [[nodiscard]] int findState(std::string_view name) const;
    [[nodiscard]] int findParameter(std::string_view name) const;

    friend bool operator==(const AnimationSet&, const AnimationSet&) = default;
};

/// Clips made by code, without a state machine.
AnimationSet animationSetOf(std::vector<Animation> clips);

/// The clips of a sheet of four cells in a row, as the first character of most games has: idle, run and jump.
extern const std::vector<Animation> playerAnimations;

/// Reads `*.anim.json`. What is wrong inside is listed in `problems` and left out.
/// @param where  the file's path, for errors
/// @error        the text is no JSON object, or of a newer format
Result<AnimationSet> parseAnimationSet(std::string_view json, std::string_view where,
                                       std::vector<Error>& problems);

/// The text of `*.anim.json`; reading it gives the same set.
std::string writeAnimationSet(const AnimationSet& set);

}  // namespace plumb
