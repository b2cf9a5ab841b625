#include "input/action_map.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "tests/support/faults.hpp"

namespace plumb {
namespace {

/// The whole texts of the problems of a map; the map is in `map`.
std::vector<std::string> problemsOf(const std::string& text, ActionMap* map = nullptr) {
    std::vector<Error> problems;
    ActionMap read = actionMapFromJson(*parseJson(text, "x"), "game: input", problems);
    if (map != nullptr) *map = std::move(read);
    std::vector<std::string> texts;
    for (const Error& problem : problems) texts.push_back(problem.text());
    return texts;
}
using Texts = std::vector<std::string>;

std::vector<Binding> bindingsOf(std::initializer_list<std::string_view> texts) {
    std::vector<Binding> bindings;
    for (const std::string_view text : texts) bindings.push_back(*bindingFromText(text));
    return bindings;
}

TEST(ActionMapTest, namesAreFoundAtTheirPlaceAndOthersAreNot) {
    const ActionMap map = ActionMap::defaults();
    const std::string_view actions[] = {"Jump", "Attack", "Interact", "Confirm", "Cancel", "Pause"};
    ASSERT_EQ(map.actions.size(), std::size(actions));
    for (std::size_t i = 0; i < std::size(actions); ++i) {
        EXPECT_EQ(map.actions[i].name, actions[i]);
        EXPECT_EQ(map.find(Action{actions[i]}), static_cast<int>(i));
    }
    ASSERT_EQ(map.axes.size(), 2u);
    EXPECT_EQ(map.find(Axis::Horizontal), 0);
    EXPECT_EQ(map.find(Axis::Vertical), 1);
    EXPECT_EQ(map.find(Action{"Dash"}), -1);
    EXPECT_EQ(map.find(Axis{"Jump"}), -1);
    EXPECT_EQ(ActionMap{}.find(Action::Jump), -1);
}

TEST(ActionMapTest, bindingReplacesTheBindingsOfAnActionOrAddsIt) {
    ActionMap map = ActionMap::defaults();
    map.bind("Jump", bindingsOf({"J"}));
    map.bind("Pause", {});
    map.bind("Dash", bindingsOf({"Pad3 LeftY-", "Mouse X1"}));
    map.bind("Dash", bindingsOf({"K", "L"}));
    ASSERT_EQ(map.actions.size(), 7u);
    EXPECT_EQ(map.actions[0], (ActionBindings{"Jump", bindingsOf({"J"})}));
    EXPECT_EQ(map.actions[5], (ActionBindings{"Pause", {}}));
    EXPECT_EQ(map.actions[6], (ActionBindings{"Dash", bindingsOf({"K", "L"})}));
    EXPECT_EQ(map.actions[1], ActionMap::defaults().actions[1]);
}

TEST(ActionMapTest, anActionBeyondTheLimitIsNotBound) {
    const test::Faults faults;
    ActionMap map;
    for (std::size_t i = 0; i < ActionMap::kMaxActions; ++i) map.bind(format("a{}", i), {});
    ASSERT_EQ(map.actions.size(), ActionMap::kMaxActions);
    map.bind("one more", bindingsOf({"J"}));
    EXPECT_EQ(map.actions.size(), ActionMap::kMaxActions);
    map.bind("a63", bindingsOf({"J"}));
    EXPECT_EQ(map.actions.back(), (ActionBindings{"a63", bindingsOf({"J"})})) << "one of the map still is";
}

TEST(ActionMapTest, readListsReplaceThoseOfTheDefaults) {
    ActionMap map;
    EXPECT_EQ(problemsOf(R"({"actions": {"Jump": ["J"], "Dash": []}, "deadZone": 0.5,
                             "axes": {"Vertical": {"positive": ["K"], "analog": []},
                                      "Throttle": {"negative": ["L"]}}})",
                         &map),
              Texts{});
    ActionMap expected = ActionMap::defaults();
    expected.actions[0].bindings = bindingsOf({"J"});
    expected.actions.push_back({"Dash", {}});
    expected.axes[1].positive = bindingsOf({"K"});
    expected.axes[1].analog.clear();
    expected.axes.push_back({"Throttle", bindingsOf({"L"}), {}, {}});
    expected.deadZone = 0.5f;
    EXPECT_EQ(map, expected);
}

TEST(ActionMapTest, invalidBindingsAreReportedWithTheirPlaceAndASuggestion) {
    const std::string example = "write e.g. \"Space\", \"Mouse Left\" or \"Pad A\"";
    const std::string x40(40, 'x');
    ActionMap map;
    EXPECT_EQ(
        problemsOf(R"({"actions": {"Jump": ["Spce", "W", 7, "#####", ")" + x40 + R"(y", true]}})", &map),
        (Texts{"game: input.actions.Jump: no key, button or stick is named \"Spce\"; did you mean \"Space\"?",
               "game: input.actions.Jump: no key, button or stick is named \"7\"; did you mean \"7\"?",
               "game: input.actions.Jump: no key, button or stick is named \"#####\"; " + example,
               "game: input.actions.Jump: no key, button or stick is named \"" + x40 + "\"; " + example,
               "game: input.actions.Jump: no key, button or stick is named \"true\"; " + example}));
    EXPECT_EQ(map.actions[0].bindings, bindingsOf({"W"}));
    EXPECT_EQ(
        problemsOf(R"({"axes": {"Vertical": {"analog": ["Pad LeftZ"]}}})"),
        Texts{
            "game: input.axes.Vertical.analog: no key, button or stick is named \"Pad LeftZ\"; did you mean "
            "\"Pad Left\"?"});
}

TEST(ActionMapTest, aListWithoutAValidBindingChangesNothing) {
    ActionMap map;
    EXPECT_EQ(problemsOf(R"({"actions": {"Jump": ["Kx"], "Pause": []},
                             "axes": {"Vertical": {"negative": ["Kx"], "positive": ["Kx", "K"]}}})",
                         &map)
                  .size(),
              3u);
    ActionMap expected = ActionMap::defaults();
    expected.bind("Pause", {});
    expected.axes[1].positive = bindingsOf({"K"});
    EXPECT_EQ(map, expected);
}

TEST(ActionMapTest, otherTypesAreReportedWithWhatWasExpected) {
    const struct {
        const char* json;
        const char* problem;
    } cases[] = {
        {"7", "game: input: expected an object, found 7; write { ... }"},
        {R"({"actions": [1]})",
         "game: input.actions: expected an object, found [...]; write { \"Jump\": [\"Space\"] }"},
        {R"({"axes": 3})",
         "game: input.axes: expected an object, found 3; write { \"Horizontal\": { ... } }"},
        {R"({"actions": {"Jump": "Space"}})",
         "game: input.actions.Jump: expected a list, found \"Space\"; write [\"Space\", \"Pad A\"]"},
        {R"({"axes": {"Vertical": {"negative": 1}}})",
         "game: input.axes.Vertical.negative: expected a list, found 1; write [\"Space\", \"Pad A\"]"},
        {R"({"axes": {"Vertical": []}})",
         "game: input.axes.Vertical: expected an object, found []; write { ... }"},
        {R"({"deadZone": 0.951})",
         "game: input.deadZone: expected a number from 0 to 0.95, found 0.951; correct it"},
        {R"({"deadZone": -0.001})",
         "game: input.deadZone: expected a number from 0 to 0.95, found -0.001; correct it"},
    };
    for (const auto& test : cases) {
        ActionMap map;
        EXPECT_EQ(problemsOf(test.json, &map), Texts{test.problem});
        EXPECT_EQ(map.deadZone, ActionMap::defaults().deadZone);
    }
    for (const float limit : {0.0f, 0.95f}) {
        ActionMap map;
        EXPECT_EQ(problemsOf(format(R"({"deadZone": {}})", limit), &map), Texts{});
        EXPECT_EQ(map.deadZone, limit);
    }
}

std::string listOf(std::size_t count) {
    std::string list = "[";
    for (std::size_t i = 0; i < count; ++i) list += i == 0 ? "\"A\"" : ", \"A\"";
    return list + "]";
}

TEST(ActionMapTest, aListHasAtMost16Bindings) {
    ActionMap map;
    EXPECT_EQ(problemsOf(R"({"actions": {"Jump": )" + listOf(16) + "}}", &map), Texts{});
    EXPECT_EQ(map.actions[0].bindings.size(), 16u);
    EXPECT_EQ(problemsOf(R"({"actions": {"Jump": )" + listOf(20) + "}}", &map),
              Texts{"game: input.actions.Jump: more than 16 bindings; remove some"});
    EXPECT_EQ(map.actions[0].bindings.size(), 16u);
}

/// { "a0": value, "a1": value, ... }
std::string objectOf(std::size_t count, std::string_view value) {
    std::string object = "{";
    for (std::size_t i = 0; i < count; ++i) object += format("{}\"a{}\": {}", i == 0 ? "" : ", ", i, value);
    return object + "}";
}

TEST(ActionMapTest, aMapHasAtMost64ActionsAnd32Axes) {
    const ActionMap defaults = ActionMap::defaults();
    const std::size_t actions = ActionMap::kMaxActions - defaults.actions.size();
    const std::size_t axes = ActionMap::kMaxAxes - defaults.axes.size();
    ActionMap map;
    EXPECT_EQ(
        problemsOf(format(R"({"actions": {}, "axes": {}})", objectOf(actions, "[]"), objectOf(axes, "{}")),
                   &map),
        Texts{});
    EXPECT_EQ(map.actions.size(), 64u);
    EXPECT_EQ(map.axes.size(), 32u);
    EXPECT_EQ(problemsOf(format(R"({"actions": {}, "axes": {}})", objectOf(actions + 1, "[]"),
                                objectOf(axes + 1, "{}")),
                         &map),
              (Texts{"game: input.actions.a58: more than 64 actions; remove some",
                     "game: input.axes.a30: more than 32 axes; remove some"}));
    EXPECT_EQ(map.actions.size(), 64u);
    EXPECT_EQ(map.axes.size(), 32u);
}

TEST(ActionMapTest, theJsonContainsEveryList) {
    ActionMap map;
    map.actions = {{"Jump", bindingsOf({"J", "Pad A"})}, {"Rest", {}}};
    map.axes = {{"Turn", bindingsOf({"Left"}), bindingsOf({"Right"}), bindingsOf({"Pad2 RightX"})}};
    map.deadZone = 0.25f;
    EXPECT_EQ(toJson(map), *parseJson(R"({"actions": {"Jump": ["J", "Pad A"], "Rest": []},
        "axes": {"Turn": {"negative": ["Left"], "positive": ["Right"], "analog": ["Pad2 RightX"]}},
        "deadZone": 0.25})",
                                      "x"));
}

}  // namespace
}  // namespace plumb
