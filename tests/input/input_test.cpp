#include "input/input.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/log.hpp"
#include "core/random.hpp"
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

TEST(ActionMap, everyBindingReadsBackFromItsText) {
    for (const BindingKind kind :
         {BindingKind::Key, BindingKind::MouseButton, BindingKind::PadButton, BindingKind::PadAxis,
          BindingKind::PadAxisPlus, BindingKind::PadAxisMinus}) {
        for (int code = 0; code < 256; ++code) {
            for (std::int8_t pad = -1; pad < kPadCount; ++pad) {
                const Binding binding{kind, static_cast<std::uint8_t>(code), pad};
                const std::optional<Binding> read = bindingFromText(toText(binding));
                if (!read) continue;
                EXPECT_EQ(toText(*read), toText(binding));
            }
        }
    }
    for (std::size_t i = 1; i < kKeyCount; ++i) {
        EXPECT_EQ(keyFromName(nameOf(static_cast<Key>(i))), static_cast<Key>(i));
        EXPECT_FALSE(nameOf(static_cast<Key>(i)).empty());
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
