#pragma once

#include "input/input_frame.hpp"
#include "platform/events.hpp"

namespace plumb {

/// Collects the events between two ticks in the next InputFrame. A press that is shorter than a tick is held
/// for one tick, and a release that is shorter is released for one tick, so neither is lost.
class DeviceState {
public:
    void handle(const Event& event);

    /// Returns the input of the next tick. Wheel motion is returned only once.
    InputFrame take();

    /// Releases all keys, buttons and sticks, e.g. when the window loses the focus and with it the events of
    /// their release.
    void releaseAll();

private:
    void handlePad(const Event& event);

    InputFrame now_;      // current state of the devices
    InputFrame changed_;  // bits that changed since the last take()
    InputFrame given_;    // the last result of take()
};

}  // namespace plumb
