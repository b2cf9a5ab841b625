#include "platform/main_loop.hpp"

#include <emscripten.h>

namespace plumb {

void runFrames(std::function<bool()> frame) {
    static std::function<bool()> running;
    running = std::move(frame);
    constexpr int kFrameRateOfDisplay = 0;
    constexpr bool kNeverReturn = true;  // leaves this call by an exception of JavaScript: no destructor runs
    emscripten_set_main_loop(
        [] {
            if (!running()) emscripten_cancel_main_loop();
        },
        kFrameRateOfDisplay, kNeverReturn);
}

bool canWait() { return false; }

}  // namespace plumb
