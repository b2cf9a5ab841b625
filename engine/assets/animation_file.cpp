#include <array>
#include <string>
#include <utility>

#include "assets/animation.hpp"
#include "core/text.hpp"
#include "reflect/json.hpp"
#include "reflect/json_fields.hpp"
#include "reflect/json_text.hpp"

namespace plumb {
namespace {

constexpr auto kLoopNames = std::to_array<std::string_view>({"loop", "once", "pingPong"});
constexpr auto kParameterNames = std::to_array<std::string_view>({"float", "bool", "trigger"});
constexpr auto kComparisonNames = std::to_array<std::string_view>({">", "<", ">=", "<=", "==", "!="});
constexpr std::size_t kMaxStates = 1024;
constexpr std::size_t kMaxTransitions = 8192;
constexpr int kMaxCell = 16384;
constexpr float kMaxValue = 1e9f;

template <class Names, class Enum>
std::string nameIn(const Names& names, Enum value) {
    return std::string{names[static_cast<std::size_t>(value)]};
}

/// Reads the name of a clip, state or parameter of the file and returns its index. Reports an unknown name
/// and returns -1.
int readName(JsonFields& fields, std::string_view key, const AnimationSet& set,
             int (AnimationSet::*find)(std::string_view) const) {
    const std::string name = fields.text(key);
    const int index = (set.*find)(name);
    if (index < 0)
        fields.warn(key, format("the name \"{}\" is not defined in this file", name.substr(0, 80)),
                    "use a name that the file defines");
    return index;
}

AnimationFrame readFrame(JsonFields& fields) {
    AnimationFrame frame;
    const Vec2 cell = fields.vec2("cell", {});
    const auto inRange = [](float index) { return index >= 0.0f && index <= static_cast<float>(kMaxCell); };
    if (inRange(cell.x) && inRange(cell.y)) {
        frame.cellX = static_cast<int>(cell.x);
        frame.cellY = static_cast<int>(cell.y);
    } else {
        fields.warn("cell", format("column and row must be 0 to {}", kMaxCell), "write [column, row]");
    }
    frame.seconds = fields.number("seconds", 0.1f, 0.001f, 3600.0f);
    frame.event = fields.text("event");
    fields.warnUnknown();
    return frame;
}

Animation readClip(JsonFields& fields) {
    Animation clip;
    clip.name = fields.text("name");
    clip.loop = static_cast<LoopMode>(fields.choice("loop", 0, kLoopNames));
    for (JsonFields& item : fields.objects("frames", AnimationSet::kMaxFrames))
        clip.frames.push_back(readFrame(item));
    if (clip.frames.empty()) {
        fields.warn("frames", "the clip has no frames",
                    "add a frame; the sheet's first cell is used instead");
        clip.frames.emplace_back();
    }
    clip.unknown = fields.keepUnknown();
    return clip;
}

AnimationParameter readParameter(JsonFields& fields) {
    AnimationParameter parameter;
    parameter.name = fields.text("name");
    parameter.kind = static_cast<ParameterKind>(fields.choice("kind", 0, kParameterNames));
    if (const Json* initial = fields.find("default"); initial != nullptr && initial->is_boolean()) {
        parameter.initial = initial->get<bool>() ? 1.0f : 0.0f;
    } else {
        parameter.initial = fields.number("default", 0.0f, -kMaxValue, kMaxValue);
    }
    fields.warnUnknown();
    return parameter;
}

void readState(JsonFields& fields, AnimationSet& set) {
    AnimationState state;
    state.name = fields.text("name");
    state.clip = readName(fields, "clip", set, &AnimationSet::findClip);
    state.speed = fields.number("speed", 1.0f, -1000.0f, 1000.0f);
    fields.warnUnknown();
    if (state.clip >= 0) set.states.push_back(std::move(state));
}

/// Reads a condition. Without "is" and "value" it means "> 0": the bool or trigger is set.
bool readCondition(JsonFields& fields, const AnimationSet& set, AnimationTransition& transition) {
    AnimationCondition condition;
    condition.parameter = readName(fields, "parameter", set, &AnimationSet::findParameter);
    condition.is = static_cast<Comparison>(fields.choice("is", 0, kComparisonNames));
    if (const Json* value = fields.find("value"); value != nullptr && value->is_boolean()) {
        condition.value = value->get<bool>() ? 1.0f : 0.0f;
    } else {
        condition.value = fields.number("value", 0.0f, -kMaxValue, kMaxValue);
    }
    fields.warnUnknown();
    transition.when.push_back(condition);
    return condition.parameter >= 0;
}

/// Reads a transition; ignores it if a part is invalid, because without that part its meaning would change.
void readTransition(JsonFields& fields, AnimationSet& set) {
    AnimationTransition transition;
    bool good = true;
    if (const Json* from = fields.find("from"); from == nullptr || *from != "*") {
        transition.from = readName(fields, "from", set, &AnimationSet::findState);
        good = transition.from >= 0;
    }
    transition.to = readName(fields, "to", set, &AnimationSet::findState);
    good = good && transition.to >= 0;
    for (JsonFields& item : fields.objects("when", 64)) good = readCondition(item, set, transition) && good;
    transition.afterEnd = fields.flag("afterEnd", false);
    fields.warnUnknown();
    if (good) set.transitions.push_back(std::move(transition));
}

void readSheet(JsonFields& fields, AnimationSet& set) {
    set.image = fields.text("image");
    set.texture = {textId(set.image)};
    const Vec2 size = fields.vec2("frameSize", {});
    if (size.x >= 0.0f && size.x <= 16384.0f && size.y >= 0.0f && size.y <= 16384.0f) {
        set.frameWidth = static_cast<int>(size.x);
        set.frameHeight = static_cast<int>(size.y);
    } else {
        fields.warn("frameSize", "width and height must be 0 to 16384 px", "write [width, height] in px");
    }
}

Json clipJson(const Animation& clip) {
    Json json = Json::object();
    json["name"] = clip.name;
    json["loop"] = nameIn(kLoopNames, clip.loop);
    json["frames"] = Json::array();
    for (const AnimationFrame& frame : clip.frames) {
        Json item = Json::object();
        item["cell"] = Json::array({frame.cellX, frame.cellY});
        item["seconds"] = frame.seconds;
        if (!frame.event.empty()) item["event"] = frame.event;
        json["frames"].push_back(std::move(item));
    }
    writeKept(json, clip.unknown);
    return json;
}

Json parameterJson(const AnimationParameter& parameter) {
    Json json = Json::object();
    json["name"] = parameter.name;
    json["kind"] = nameIn(kParameterNames, parameter.kind);
    json["default"] = parameter.initial;
    return json;
}

Json stateJson(const AnimationSet& set, const AnimationState& state) {
    Json json = Json::object();
    json["name"] = state.name;
    json["clip"] = set.clips[static_cast<std::size_t>(state.clip)].name;
    if (state.speed != 1.0f) json["speed"] = state.speed;
    return json;
}

Json transitionJson(const AnimationSet& set, const AnimationTransition& transition) {
    const auto stateName = [&](int state) { return set.states[static_cast<std::size_t>(state)].name; };
    Json json = Json::object();
    json["from"] =
        transition.from == AnimationTransition::kAnyState ? std::string{"*"} : stateName(transition.from);
    json["to"] = stateName(transition.to);
    json["when"] = Json::array();
    for (const AnimationCondition& condition : transition.when) {
        Json item = Json::object();
        item["parameter"] = set.parameters[static_cast<std::size_t>(condition.parameter)].name;
        item["is"] = nameIn(kComparisonNames, condition.is);
        item["value"] = condition.value;
        json["when"].push_back(std::move(item));
    }
    if (transition.afterEnd) json["afterEnd"] = true;
    return json;
}

}  // namespace

Result<AnimationSet> parseAnimationSet(std::string_view text, std::string_view where,
                                       std::vector<Error>& problems) {
    const Result<Json> json = parseJson(text, where, &problems);
    if (!json) return json.error();
    if (!json->is_object()) {
        return Error{std::string{where}, "expected an object, found " + briefText(*json), "write { ... }"};
    }
    JsonFields fields{*json, std::string{where}, problems};
    if (!fields.acceptFormat(AnimationSet::kFormat)) {
        Error error = std::move(problems.back());
        problems.pop_back();
        return error;
    }
    AnimationSet set;
    readSheet(fields, set);
    for (JsonFields& item : fields.objects("clips", AnimationSet::kMaxClips))
        set.clips.push_back(readClip(item));
    for (JsonFields& item : fields.objects("parameters", AnimationSet::kMaxParameters)) {
        set.parameters.push_back(readParameter(item));
    }
    for (JsonFields& item : fields.objects("states", kMaxStates)) readState(item, set);
    for (JsonFields& item : fields.objects("transitions", kMaxTransitions)) readTransition(item, set);
    set.unknown = fields.keepUnknown();
    return set;
}

std::string writeAnimationSet(const AnimationSet& set) {
    Json json = Json::object();
    json["format"] = AnimationSet::kFormat;
    if (!set.image.empty()) json["image"] = set.image;
    if (set.frameWidth != 0 || set.frameHeight != 0) {
        json["frameSize"] = Json::array({set.frameWidth, set.frameHeight});
    }
    json["clips"] = Json::array();
    for (const Animation& clip : set.clips) json["clips"].push_back(clipJson(clip));
    for (const AnimationParameter& parameter : set.parameters)
        json["parameters"].push_back(parameterJson(parameter));
    for (const AnimationState& state : set.states) json["states"].push_back(stateJson(set, state));
    for (const AnimationTransition& transition : set.transitions) {
        json["transitions"].push_back(transitionJson(set, transition));
    }
    writeKept(json, set.unknown);
    return writeCompactJson(json);
}

}  // namespace plumb
