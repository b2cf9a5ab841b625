#include "input/device_state.hpp"

#include <gtest/gtest.h>

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

TEST(DeviceState, invalidEventsChangeNothing) {
    DeviceState devices;
    devices.handle(padEvent(EventKind::PadDown, 99));
    devices.handle(padEvent(EventKind::PadDown, -1));
    devices.handle(keyEvent(Key::Count, true));
    devices.handle(keyEvent(Key::None, true));
    EXPECT_EQ(devices.take(), InputFrame{});
}

}  // namespace
}  // namespace plumb
