#include "input/input.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/log.hpp"
#include "core/text.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"

namespace plumb {
namespace {

InputFrame holding(std::initializer_list<Key> keys) {
    InputFrame frame;
    for (const Key key : keys) frame.set(key, true);
    return frame;
}

InputFrame stick(float x, float y) {
    InputFrame frame;
    frame.pads[0].axes[0] = static_cast<std::int16_t>(x * 32767.0f);
    frame.pads[0].axes[1] = static_cast<std::int16_t>(y * 32767.0f);
    return frame;
}

ActionMap mapOf(std::string_view text, std::vector<Error>& problems) {
    return actionMapFromJson(*parseJson(text, "x"), "project.json: input", problems);
}

TEST(Input, anActionIsPressedForOneTickHeldWhileDownAndReleasedForOneTick) {
    Input input;
    input.advance(holding({Key::Space}));
    EXPECT_TRUE(input.isPressed(Action::Jump));
    EXPECT_TRUE(input.isHeld(Action::Jump));

    input.advance(holding({Key::Space}));
    EXPECT_FALSE(input.isPressed(Action::Jump));
    EXPECT_TRUE(input.isHeld(Action::Jump));

    input.advance({});
    EXPECT_TRUE(input.isReleased(Action::Jump));
    input.advance({});
    EXPECT_FALSE(input.isReleased(Action::Jump));
}

TEST(Input, changingFromOneKeyOfAnActionToAnotherPressesItOnce) {
    Input input;
    input.advance(holding({Key::Space}));
    input.advance(holding({Key::Space, Key::W}));
    EXPECT_FALSE(input.isPressed(Action::Jump));
    input.advance(holding({Key::W}));
    EXPECT_TRUE(input.isHeld(Action::Jump));
    EXPECT_FALSE(input.isReleased(Action::Jump));
}

TEST(Input, anAxisIsTheSumOfItsKeysOrTheStick) {
    Input input;
    input.advance(holding({Key::Right}));
    EXPECT_EQ(input.getAxis(Axis::Horizontal), 1.0f);
    input.advance(holding({Key::Right, Key::A}));
    EXPECT_EQ(input.getAxis(Axis::Horizontal), 0.0f);
    input.advance(holding({Key::Left, Key::A}));
    EXPECT_EQ(input.getAxis(Axis::Horizontal), -1.0f);
    input.advance(stick(1.0f, 0.0f));
    EXPECT_EQ(input.getAxis(Axis::Horizontal), 1.0f);
    EXPECT_EQ(input.getAxis(Axis{"Unknown"}), 0.0f);
}

TEST(Input, theDeadZoneIsRoundAndTheRestIsRescaled) {
    Input input;
    for (const float at : {0.0f, 0.1f, 0.19f, -0.19f}) {
        input.advance(stick(at, 0.0f));
        EXPECT_EQ(input.getAxis(Axis::Horizontal), 0.0f) << at;
    }
    input.advance(stick(0.6f, 0.0f));
    EXPECT_NEAR(input.getAxis(Axis::Horizontal), 0.5f, 1e-3f);
    input.advance(stick(0.1f, 0.99f));
    EXPECT_GT(input.getAxis(Axis::Horizontal), 0.05f);
    for (int i = 0; i <= 100; ++i) {
        input.advance(stick(0.01f * static_cast<float>(i), 0.7f));
        EXPECT_LE(input.getAxis(Axis::Horizontal), 1.0f);
        EXPECT_GE(input.getAxis(Axis::Horizontal), 0.0f);
    }
}

TEST(Input, theLogContainsEachPressOnceIfEnabled) {
    std::vector<std::string> lines;
    const LogSink before =
        setLogSink([&](const LogLine& line) { lines.push_back("[" + line.channel + "] " + line.text); });
    Input input;
    input.advance(holding({Key::Up}));
    input.advance({});
    input.logging = true;
    input.advance(holding({Key::Up}));
    input.advance(holding({Key::Up}));
    setLogSink(before);

    EXPECT_EQ(lines, std::vector<std::string>{"[Input] Jump pressed"});
}

TEST(Input, namedActionsUseTheProjectsKeysAndOthersKeepTheirs) {
    std::vector<Error> problems;
    Input input{mapOf(R"({"actions": {"Dash": ["LeftShift", "Pad2 X", "Pad RightTrigger"]}})", problems)};
    EXPECT_TRUE(problems.empty());

    input.advance(holding({Key::LeftShift, Key::Space}));
    EXPECT_TRUE(input.isPressed(Action{"Dash"}));
    EXPECT_TRUE(input.isPressed(Action::Jump));

    InputFrame frame;
    frame.pads[0].buttons = 1u << static_cast<unsigned>(PadButton::X);
    input.advance(frame);
    EXPECT_FALSE(input.isHeld(Action{"Dash"}));
    frame.pads[1].buttons = frame.pads[0].buttons;
    input.advance(frame);
    EXPECT_TRUE(input.isHeld(Action{"Dash"}));
}

TEST(Input, aRestoredInputContinuesIdentically) {
    Input a;
    a.advance(holding({Key::Space}));
    Input b;
    b.restore(a.previousFrame(), a.frame());
    EXPECT_TRUE(b.isPressed(Action::Jump));
}

TEST(Input, anUnknownActionIsNeverPressedHeldOrReleased) {
    Input input;
    InputFrame all;
    all.keys.fill(0xffffffffu);
    for (const InputFrame& frame : {InputFrame{}, all, all, InputFrame{}, InputFrame{}}) {
        input.advance(frame);
        EXPECT_FALSE(input.isPressed(Action{"Unknown"}));
        EXPECT_FALSE(input.isHeld(Action{"Unknown"}));
        EXPECT_FALSE(input.isReleased(Action{"Unknown"}));
        EXPECT_EQ(input.getAxis(Axis{"Jump"}), 0.0f) << "an action is no axis";
    }
}

TEST(Input, keysAndButtonsThemselvesFollowTheFrames) {
    for (int bits = 0; bits < 4; ++bits) {
        const bool before = (bits & 1) != 0, now = (bits & 2) != 0;
        const auto frameOf = [](bool held) {
            InputFrame frame;
            frame.set(Key::F5, held);
            frame.mouseButtons = held ? 1u << static_cast<unsigned>(MouseButton::Middle) : 0u;
            frame.mouseX = held ? 3 : 0;
            return frame;
        };
        Input input;
        input.advance(frameOf(before));
        input.advance(frameOf(now));
        EXPECT_EQ(input.isPressed(Key::F5), now && !before);
        EXPECT_EQ(input.isHeld(Key::F5), now);
        EXPECT_EQ(input.isReleased(Key::F5), !now && before);
        EXPECT_EQ(input.isPressed(MouseButton::Middle), now && !before);
        EXPECT_EQ(input.isHeld(MouseButton::Middle), now);
        EXPECT_EQ(input.isReleased(MouseButton::Middle), !now && before);
        EXPECT_FALSE(input.isHeld(Key::F6) || input.isHeld(MouseButton::Left));
        EXPECT_EQ(input.mouse(), (Vec2{now ? 3.0f : 0.0f, 0.0f}));
        EXPECT_EQ(input.frame(), frameOf(now));
        EXPECT_EQ(input.previousFrame(), frameOf(before));
    }
}

/// A map of actions a0, a1, … and axes x0, x1, …, all with the same bindings but the first and the last.
ActionMap wideMap(std::size_t actions, std::size_t axes) {
    ActionMap map;
    for (std::size_t i = 0; i < actions; ++i)
        map.actions.push_back({format("a{}", i), {*bindingFromText(i == 0 ? "A" : i == 63 ? "B" : "C")}});
    for (std::size_t i = 0; i < axes; ++i)
        map.axes.push_back({format("x{}", i), {*bindingFromText(i == 31 ? "Left" : "Up")}, {}, {}});
    return map;
}

TEST(Input, theMapIsCutAtItsLimitsAndNotExtended) {
    EXPECT_EQ(Input{wideMap(3, 2)}.map(), wideMap(3, 2));
    EXPECT_EQ(Input{wideMap(64, 32)}.map(), wideMap(64, 32));
    EXPECT_EQ(Input{wideMap(70, 40)}.map(), wideMap(64, 32));
}

TEST(Input, theLastActionAndAxisWorkAndAreLoggedOnce) {
    std::vector<std::string> lines;
    const LogSink before = setLogSink([&](const LogLine& line) { lines.push_back(line.text); });
    Input input{wideMap(64, 32)};
    input.logging = true;
    input.advance(holding({Key::B, Key::Left}));
    input.advance(holding({Key::A}));
    setLogSink(before);

    EXPECT_EQ(lines, (std::vector<std::string>{"a63 pressed", "a0 pressed"}));
    EXPECT_TRUE(input.isReleased(Action{"a63"}));
    EXPECT_TRUE(input.isPressed(Action{"a0"}));
    EXPECT_FALSE(input.isHeld(Action{"a1"}) || input.isReleased(Action{"a62"}));
    input.advance(holding({Key::Left}));
    EXPECT_EQ(input.getAxis(Axis{"x31"}), -1.0f);
    EXPECT_EQ(input.getAxis(Axis{"x30"}), 0.0f);
    EXPECT_EQ(input.getAxis(Axis{"x32"}), 0.0f);
}

TEST(Input, aKeyOverridesSticksOfWhichTheOnePushedFarthestCounts) {
    std::vector<Error> problems;
    Input input{mapOf(R"({"axes": {"Horizontal": {"analog": ["Pad1 LeftX", "Pad2 LeftX"]}}, "deadZone": 0})",
                      problems)};
    ASSERT_TRUE(problems.empty());
    const auto at = [&](int first, int second, std::initializer_list<Key> keys = {}) {
        InputFrame frame = holding(keys);
        frame.pads[0].axes[0] = static_cast<std::int16_t>(first);
        frame.pads[1].axes[0] = static_cast<std::int16_t>(second);
        input.advance(frame);
        return input.getAxis(Axis::Horizontal);
    };
    EXPECT_EQ(at(32'767, -32'767), 1.0f) << "the first of two pushed equally far";
    EXPECT_EQ(at(-32'767, 32'767), -1.0f);
    EXPECT_EQ(at(-16'000, 32'767), 1.0f);
    EXPECT_EQ(at(16'000, -32'767), -1.0f);
    EXPECT_EQ(at(-32'767, 16'000), -1.0f);
    EXPECT_EQ(at(-32'767, -32'767, {Key::Right}), 1.0f);
    EXPECT_EQ(at(32'767, 0, {Key::Left}), -1.0f);
}

TEST(Input, aNewMapAppliesToTheCurrentAndThePreviousTick) {
    Input input;
    input.advance(holding({Key::K}));
    input.advance(holding({Key::K, Key::L}));
    EXPECT_FALSE(input.isHeld(Action::Jump));
    ActionMap map;
    map.bind("Jump", {*bindingFromText("K")});
    map.bind("Dash", {*bindingFromText("L")});
    input.setMap(map);
    EXPECT_TRUE(input.isHeld(Action::Jump));
    EXPECT_FALSE(input.isPressed(Action::Jump)) << "held in the tick before too";
    EXPECT_TRUE(input.isPressed(Action{"Dash"}));
    EXPECT_EQ(input.map(), map);
    EXPECT_FALSE(input.isHeld(Action::Attack));
}

TEST(Input, restoringReplacesBothFramesAndTheHashDependsOnBoth) {
    const auto hashOf = [](const Input& input) {
        Hasher hasher;
        input.addTo(hasher);
        return hasher.value();
    };
    const InputFrame jump = holding({Key::Space});
    Input input;
    std::vector<std::uint64_t> hashes;
    for (const InputFrame& previous : {InputFrame{}, jump}) {
        for (const InputFrame& current : {InputFrame{}, jump}) {
            input.restore(previous, current);
            const bool was = previous == jump, is = current == jump;
            EXPECT_EQ(input.isPressed(Action::Jump), is && !was);
            EXPECT_EQ(input.isHeld(Action::Jump), is);
            EXPECT_EQ(input.isReleased(Action::Jump), was && !is);
            for (const std::uint64_t other : hashes) EXPECT_NE(hashOf(input), other);
            hashes.push_back(hashOf(input));
        }
    }
}

TEST(ActionMap, aMapReadsBackFromItsJson) {
    std::vector<Error> problems;
    ActionMap map = ActionMap::defaults();
    map.bind("Dash", {*bindingFromText("Pad3 LeftY-"), *bindingFromText("Mouse X1")});
    map.deadZone = 0.3f;

    EXPECT_EQ(actionMapFromJson(toJson(map), "x", problems), map);
    EXPECT_TRUE(problems.empty());
}

TEST(ActionMap, anInvalidBindingIsReportedWithASuggestionAndOthersAreKept) {
    std::vector<Error> problems;
    const ActionMap map = mapOf(R"({"actions": {"Jump": ["Spce", "W", 7]}})", problems);

    ASSERT_EQ(problems.size(), 2u);
    EXPECT_EQ(problems[0].where, "project.json: input.actions.Jump");
    EXPECT_EQ(problems[0].remedy, "did you mean \"Space\"?");
    EXPECT_EQ(map.actions[static_cast<std::size_t>(map.find(Action::Jump))].bindings.size(), 1u);
}

TEST(ActionMap, wrongJsonTypesAreReportedAndKeepTheDefaults) {
    for (const char* text :
         {"[]", "7", R"({"actions": []})", R"({"axes": 3})", R"({"deadZone": 5})", R"({"action": {}})",
          R"({"actions": {"Jump": "Space"}})", R"({"axes": {"Horizontal": []}})",
          R"({"axes": {"Horizontal": {"negativ": []}}})"}) {
        std::vector<Error> problems;
        const ActionMap map = mapOf(text, problems);
        EXPECT_EQ(problems.size(), 1u) << text;
        EXPECT_GE(map.find(Axis::Vertical), 0) << text;
    }
}

TEST(ActionMap, actionsBeyondTheLimitAreReportedAndIgnored) {
    std::string text = R"({"actions": {)";
    for (int i = 0; i < 100; ++i) text += (i == 0 ? "\"a" : ", \"a") + std::to_string(i) + "\": []";
    std::vector<Error> problems;

    EXPECT_EQ(mapOf(text + "}}", problems).actions.size(), ActionMap::kMaxActions);

    EXPECT_FALSE(problems.empty());
}

}  // namespace
}  // namespace plumb
