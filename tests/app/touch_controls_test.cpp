#include "app/touch_controls.hpp"

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(TouchControls, areTheKeysOfWhatTheGameHasAskedForSinceTheLastLook) {
    Input input;
    EXPECT_EQ(touchControls(input.map(), input.takeAsked()), R"({"axes":[],"actions":[]})");
    (void)input.isPressed(Action::Jump);
    (void)input.getAxis(Axis::Horizontal);
    (void)input.isHeld(Action{"Nothing"});
    EXPECT_EQ(
        touchControls(input.map(), input.takeAsked()),
        R"({"axes":[{"name":"Horizontal","negative":{"key":"Left","usage":80},"positive":{"key":"Right","usage":79}}],"actions":[{"name":"Jump","key":"Space","usage":44}]})");
    EXPECT_EQ(input.takeAsked(), Input::Asked{})
        << "an action that the game no longer asks for has no button";
    (void)input.isReleased(Action::Pause);
    EXPECT_NE(touchControls(input.map(), input.takeAsked()).find("Pause"), std::string::npos);
}

TEST(TouchControls, whatNeedsNoButtonHasNone) {
    ActionMap map;
    map.bind("Fire", {*bindingFromText("Mouse Left"), *bindingFromText("Pad X")});
    map.bind("Jump", {*bindingFromText("Pad A"), *bindingFromText("Space"), *bindingFromText("W")});
    map.bind("Confirm", {*bindingFromText("Space")});
    map.bind("Quoted \"name\"", {*bindingFromText("Q")});
    map.axes.push_back({"Stick", {}, {}, {*bindingFromText("Pad LeftX")}});
    Input::Asked all;
    all.actions = all.axes = ~std::uint64_t{0};
    EXPECT_EQ(
        touchControls(map, all),
        R"({"axes":[],"actions":[{"name":"Jump","key":"Space","usage":44},{"name":"Quoted \"name\"","key":"Q","usage":20}]})");
}

TEST(TouchControls, areOthersAfterTheKeysHaveChanged) {
    Input input;
    TouchControls shown;
    const auto changes = [&] {
        (void)input.isPressed(Action::Jump);
        return shown.look(input);
    };
    EXPECT_TRUE(changes());
    EXPECT_FALSE(changes());
    ActionMap map = input.map();
    map.bind("Jump", {*bindingFromText("K")});
    input.setMap(map);
    EXPECT_TRUE(changes());
    EXPECT_EQ(shown.text(), R"({"axes":[],"actions":[{"name":"Jump","key":"K","usage":14}]})");
    EXPECT_TRUE(shown.look(input)) << "the game does not ask for it any more";
}

}  // namespace
}  // namespace plumb
