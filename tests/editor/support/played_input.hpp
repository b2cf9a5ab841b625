#pragma once

#include <cstdint>
#include <string>

#include "core/text.hpp"
#include "input/input_frame.hpp"

namespace plumb::editor {

/// Returns scripted player input for a tick: runs left and right, jumps, pauses jumping and moves the mouse.
inline InputFrame runAndJump(std::int64_t tick) {
    InputFrame frame;
    frame.set(Key::Right, tick / 90 % 3 != 1);
    frame.set(Key::Left, tick / 90 % 3 == 1);
    frame.set(Key::Space, tick % 47 < 14);
    frame.setMouse({static_cast<float>(tick % 320), 90.0f});
    return frame;
}

/// Returns the text of a scene with a ground and heaps of boxes on it.
inline std::string heapScene(int boxes) {
    std::string text = R"({"format": 1, "entities": [
  {"id": "0000000000000001", "name": "ground", "components": {"Transform": {"position": [-400, 700]},
   "BoxCollider": {"width": 4000, "height": 40}}})";
    for (int i = 0; i < boxes; ++i) {
        text += format(R"(,
  {"id": "{}", "name": "box {}", "components": {"Transform": {"position": [{}, {}]},
   "RigidBody": { }, "BoxCollider": {"width": 20, "height": 20}}})",
                       hexText(std::uint64_t{0x1000} + static_cast<std::uint64_t>(i)), i,
                       i % 25 * 60 + i / 25 % 2 * 7, 660 - i / 25 * 26);
    }
    return text + "]}";
}

}  // namespace plumb::editor
