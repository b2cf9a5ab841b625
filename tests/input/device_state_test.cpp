#include "input/device_state.hpp"

#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace plumb {
namespace {

Event keyEvent(Key key, bool down) {
    Event event{.kind = down ? EventKind::KeyDown : EventKind::KeyUp};
    event.key = key;
    return event;
}

Event padEvent(EventKind kind, int pad, PadButton button = PadButton::A) {
    Event event{.kind = kind};
    event.pad = pad;
    event.padButton = button;
    return event;
}

TEST(DeviceState, aKeyIsHeldFromItsPressToItsRelease) {
    DeviceState devices;
    devices.handle(keyEvent(Key::Space, true));
    EXPECT_TRUE(devices.take().has(Key::Space));
    EXPECT_TRUE(devices.take().has(Key::Space));
    devices.handle(keyEvent(Key::Space, false));
    EXPECT_FALSE(devices.take().has(Key::Space));
}

TEST(DeviceState, aPressShorterThanATickIsDownForOneTick) {
    DeviceState devices;
    devices.handle(keyEvent(Key::Space, true));
    devices.handle(keyEvent(Key::Space, false));

    EXPECT_TRUE(devices.take().has(Key::Space));
    EXPECT_FALSE(devices.take().has(Key::Space));
}

TEST(DeviceState, aReleaseShorterThanATickIsUpForOneTick) {
    DeviceState devices;
    devices.handle(keyEvent(Key::Space, true));
    static_cast<void>(devices.take());
    devices.handle(keyEvent(Key::Space, false));
    devices.handle(keyEvent(Key::Space, true));

    EXPECT_FALSE(devices.take().has(Key::Space));
    EXPECT_TRUE(devices.take().has(Key::Space));
}

TEST(DeviceState, shortPressesOfMouseAndGamepadAreNotLostEither) {
    DeviceState devices;
    devices.handle(padEvent(EventKind::PadAdded, 1));
    devices.handle(padEvent(EventKind::PadDown, 1));
    devices.handle(padEvent(EventKind::PadUp, 1));
    devices.handle(Event{.kind = EventKind::MouseDown});
    devices.handle(Event{.kind = EventKind::MouseUp});

    const InputFrame first = devices.take();
    EXPECT_TRUE(first.pads[1].has(PadButton::A));
    EXPECT_TRUE(first.has(MouseButton::Left));
    const InputFrame second = devices.take();
    EXPECT_FALSE(second.pads[1].has(PadButton::A));
    EXPECT_FALSE(second.has(MouseButton::Left));
}

TEST(DeviceState, keyRepeatIsIgnored) {
    DeviceState devices;
    Event repeated = keyEvent(Key::A, true);
    repeated.repeated = true;
    devices.handle(repeated);
    EXPECT_FALSE(devices.take().has(Key::A));
}

TEST(DeviceState, wheelMovementIsSummedAndReportedOnce) {
    DeviceState devices;
    Event wheel{.kind = EventKind::MouseWheel};
    wheel.motion = {0.0f, 1.5f};
    devices.handle(wheel);
    devices.handle(wheel);
    EXPECT_EQ(devices.take().wheelY, 360);
    EXPECT_EQ(devices.take().wheelY, 0);
}

TEST(DeviceState, losingTheFocusReleasesEverything) {
    DeviceState devices;
    devices.handle(keyEvent(Key::D, true));
    devices.handle(padEvent(EventKind::PadAdded, 0));
    devices.handle(padEvent(EventKind::PadDown, 0));
    static_cast<void>(devices.take());
    devices.handle(Event{.kind = EventKind::FocusLost});

    const InputFrame frame = devices.take();
    EXPECT_FALSE(frame.has(Key::D));
    EXPECT_EQ(frame.pads[0], PadFrame{});
    EXPECT_EQ(frame.connectedPads, 1);
}

TEST(DeviceState, disconnectingAGamepadReleasesItsButtons) {
    DeviceState devices;
    devices.handle(padEvent(EventKind::PadAdded, 2));
    devices.handle(padEvent(EventKind::PadDown, 2));
    Event axis = padEvent(EventKind::PadAxisMoved, 2);
    axis.value = -1.0f;
    devices.handle(axis);
    EXPECT_EQ(devices.take().pads[2].axes[0], -32767);
    devices.handle(padEvent(EventKind::PadRemoved, 2));

    const InputFrame frame = devices.take();
    EXPECT_EQ(frame.connectedPads, 0);
    EXPECT_EQ(frame.pads[2], PadFrame{});
}

Event mouseEvent(EventKind kind, MouseButton button, Vec2 position) {
    Event event{.kind = kind};
    event.mouseButton = button;
    event.position = position;
    return event;
}

Event axisEvent(int pad, PadAxis axis, float value) {
    Event event = padEvent(EventKind::PadAxisMoved, pad);
    event.padAxis = axis;
    event.value = value;
    return event;
}

TEST(DeviceState, invalidEventsChangeNothing) {
    DeviceState devices;
    for (const int pad : {99, kPadCount, -1}) {
        for (const EventKind kind :
             {EventKind::PadAdded, EventKind::PadRemoved, EventKind::PadDown, EventKind::PadUp})
            devices.handle(padEvent(kind, pad));
        devices.handle(axisEvent(pad, PadAxis::LeftX, 1.0f));
    }
    for (int pad = 0; pad < kPadCount; ++pad) {
        devices.handle(padEvent(EventKind::PadDown, pad, PadButton::Count));
        devices.handle(axisEvent(pad, PadAxis::Count, 1.0f));
    }
    devices.handle(keyEvent(Key::Count, true));
    devices.handle(keyEvent(Key::None, true));
    devices.handle(mouseEvent(EventKind::MouseDown, MouseButton::Count, {5.0f, 6.0f}));
    devices.handle(Event{.kind = EventKind::Resized});
    EXPECT_EQ(devices.take(), InputFrame{});
}

TEST(DeviceState, everyKeyAndButtonHasItsOwnBit) {
    for (std::size_t i = 1; i < kKeyCount; ++i) {
        DeviceState devices;
        devices.handle(keyEvent(static_cast<Key>(i), true));
        InputFrame expected;
        expected.set(static_cast<Key>(i), true);
        ASSERT_EQ(devices.take(), expected) << nameOf(static_cast<Key>(i));
        ASSERT_EQ(expected.keys[i / 32], 1u << i % 32);
    }
    for (std::size_t i = 0; i < kMouseButtonCount; ++i) {
        DeviceState devices;
        devices.handle(mouseEvent(EventKind::MouseDown, static_cast<MouseButton>(i), {}));
        InputFrame expected;
        expected.mouseButtons = static_cast<std::uint16_t>(1u << i);
        ASSERT_EQ(devices.take(), expected) << i;
    }
    for (std::size_t i = 0; i < kPadButtonCount; ++i) {
        for (int pad = 0; pad < kPadCount; ++pad) {
            DeviceState devices;
            devices.handle(padEvent(EventKind::PadAdded, pad));
            devices.handle(padEvent(EventKind::PadDown, pad, static_cast<PadButton>(i)));
            InputFrame expected;
            expected.connectedPads = static_cast<std::uint16_t>(1u << pad);
            expected.pads[static_cast<std::size_t>(pad)].buttons = static_cast<std::uint16_t>(1u << i);
            ASSERT_EQ(devices.take(), expected) << i << " of gamepad " << pad;
        }
    }
}

TEST(DeviceState, axesAreScaledRoundedAndKeptInTheRange) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const auto& [value, expected] : {std::pair{0.0f, 0},
                                          {1.0f, 32'767},
                                          {-1.0f, -32'767},
                                          {7.0f, 32'767},
                                          {-7.0f, -32'767},
                                          {0.5f, 16'384},
                                          {-0.25f, -8192},
                                          {nan, 0}}) {
        for (std::size_t axis = 0; axis < kPadAxisCount; ++axis) {
            DeviceState devices;
            devices.handle(axisEvent(1, static_cast<PadAxis>(axis), value));
            InputFrame frame;
            frame.pads[1].axes[axis] = static_cast<std::int16_t>(expected);
            ASSERT_EQ(devices.take(), frame) << value;
        }
    }
}

TEST(DeviceState, theMouseIsWhereTheLastEventWas) {
    DeviceState devices;
    const auto position = [&] {
        const InputFrame frame = devices.take();
        return std::pair{int{frame.mouseX}, int{frame.mouseY}};
    };
    devices.handle(mouseEvent(EventKind::MouseMoved, MouseButton::Left, {12.6f, -3.4f}));
    EXPECT_EQ(position(), (std::pair{13, -3}));
    EXPECT_EQ(position(), (std::pair{13, -3})) << "until it moves";
    devices.handle(mouseEvent(EventKind::MouseDown, MouseButton::Left, {40.0f, 50.0f}));
    EXPECT_EQ(position(), (std::pair{40, 50}));
    devices.handle(mouseEvent(EventKind::MouseUp, MouseButton::Left, {-1e9f, 1e9f}));
    EXPECT_EQ(position(), (std::pair{-32'767, 32'767}));
    devices.handle(mouseEvent(EventKind::MouseMoved, MouseButton::Left, {32'767.0f, -32'767.0f}));
    devices.handle(Event{.kind = EventKind::FocusLost});
    EXPECT_EQ(position(), (std::pair{32'767, -32'767})) << "not by the loss of the focus";
}

TEST(DeviceState, theWheelIsTheSumOfItsNotchesInBothDirections) {
    DeviceState devices;
    const auto turn = [&](float x, float y) {
        Event wheel{.kind = EventKind::MouseWheel};
        wheel.motion = {x, y};
        devices.handle(wheel);
    };
    turn(1.0f, -2.0f);
    turn(0.5f, 0.25f);
    InputFrame expected;
    expected.wheelX = 180;
    expected.wheelY = -210;
    EXPECT_EQ(devices.take(), expected);
    EXPECT_EQ(devices.take(), InputFrame{});
    for (int i = 0; i < 3; ++i) turn(200.0f, -200.0f);
    EXPECT_EQ(devices.take().wheelX, 32'767);
    turn(1.0f, 1.0f);
    devices.handle(Event{.kind = EventKind::FocusLost});
    EXPECT_EQ(devices.take(), InputFrame{});
}

TEST(DeviceState, whatWasPressedBeforeTheFocusOrTheGamepadWasLostIsNotReported) {
    DeviceState devices;
    devices.handle(keyEvent(Key::A, true));
    devices.handle(mouseEvent(EventKind::MouseDown, MouseButton::Right, {}));
    devices.handle(padEvent(EventKind::PadDown, 0));
    devices.handle(Event{.kind = EventKind::FocusLost});
    EXPECT_EQ(devices.take(), InputFrame{});
    for (const EventKind kind : {EventKind::PadAdded, EventKind::PadRemoved}) {
        devices.handle(padEvent(EventKind::PadDown, 3));
        devices.handle(axisEvent(3, PadAxis::LeftY, 1.0f));
        devices.handle(padEvent(kind, 3));
        InputFrame expected;
        expected.connectedPads = kind == EventKind::PadAdded ? 8 : 0;
        EXPECT_EQ(devices.take(), expected);
    }
}

/// One key or button as a caller sees it.
struct Control {
    bool down = false;      ///< now
    bool changed = false;   ///< since the last tick
    bool reported = false;  ///< in the last tick

    void set(bool now) {
        changed = changed || down != now;
        down = now;
    }
    bool take() {
        const bool isBlip = changed && down == reported;
        reported = isBlip ? !down : down;
        changed = false;
        return reported;
    }
};

TEST(DeviceStateProperty, aChangeBetweenTwoTicksIsNeverLostAndNothingElseIsReported) {
    constexpr Key kKeys[] = {Key::A, Key::Digit5, Key::Space, Key::Up, Key::Menu};
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        DeviceState devices;
        Control keys[std::size(kKeys)];
        Control mouse[kMouseButtonCount];
        Control pads[kPadCount][2];
        for (int step = 0; step < 500; ++step) {
            const bool down = random.below(2) == 0;
            switch (random.below(4)) {
                case 0: {
                    const std::uint32_t which = random.below(std::size(kKeys));
                    devices.handle(keyEvent(kKeys[which], down));
                    keys[which].set(down);
                    break;
                }
                case 1: {
                    const std::uint32_t which = random.below(kMouseButtonCount);
                    devices.handle(mouseEvent(down ? EventKind::MouseDown : EventKind::MouseUp,
                                              static_cast<MouseButton>(which), {}));
                    mouse[which].set(down);
                    break;
                }
                case 2: {
                    const std::uint32_t pad = random.below(kPadCount), which = random.below(2);
                    devices.handle(padEvent(down ? EventKind::PadDown : EventKind::PadUp,
                                            static_cast<int>(pad),
                                            which == 0 ? PadButton::A : PadButton::Right));
                    pads[pad][which].set(down);
                    break;
                }
                default: {
                    InputFrame expected;
                    for (std::size_t i = 0; i < std::size(kKeys); ++i) expected.set(kKeys[i], keys[i].take());
                    for (std::size_t i = 0; i < kMouseButtonCount; ++i) {
                        if (mouse[i].take())
                            expected.mouseButtons =
                                static_cast<std::uint16_t>(expected.mouseButtons | 1u << i);
                    }
                    for (std::size_t pad = 0; pad < kPadCount; ++pad) {
                        unsigned buttons = pads[pad][0].take() ? 1u : 0u;
                        if (pads[pad][1].take()) buttons |= 1u << static_cast<unsigned>(PadButton::Right);
                        expected.pads[pad].buttons = static_cast<std::uint16_t>(buttons);
                    }
                    ASSERT_EQ(devices.take(), expected) << step;
                }
            }
        }
    }
}

}  // namespace
}  // namespace plumb
