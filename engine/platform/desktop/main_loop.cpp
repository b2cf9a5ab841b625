#include "platform/main_loop.hpp"

namespace plumb {

void runFrames(std::function<bool()> frame) {
    while (frame()) {
    }
}

bool canWait() { return true; }

}  // namespace plumb
