#pragma once

#include "input/input_frame.hpp"
#include "platform/events.hpp"

namespace plumb {

/// Gathers events between two ticks into the next InputFrame. A press that is shorter than a tick is down for
/// one tick, a release that is shorter is up for one: neither is lost.
class DeviceState {
public:
    void handle(const Event& event);

    /// What the next tick may know. Wheel turns are given once.
    InputFrame take();

    /// Lets go of everything, e.g. when the window loses the focus: the release would go to another window.
    void releaseAll();

private:
    void handlePad(const Event& event);

    InputFrame now_;      // what the devices say
    InputFrame changed_;  // bits that changed since the last take
    InputFrame given_;    // what the last tick got
};

}  // namespace plumb
