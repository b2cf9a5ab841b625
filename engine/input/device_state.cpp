#include "input/device_state.hpp"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

constexpr float kWheelNotch = 120.0f;

std::int16_t toShort(float value, float scale) {
    if (!(value == value)) return 0;
    return static_cast<std::int16_t>(std::lround(std::clamp(value * scale, -32767.0f, 32767.0f)));
}

template <class Word>
void setBit(Word& word, Word& changed, unsigned bit, bool on) {
    const auto mask = static_cast<Word>(Word{1} << bit);
    const auto next = static_cast<Word>(on ? word | mask : word & ~mask);
    changed = static_cast<Word>(changed | (word ^ next));
    word = next;
}

/// Returns the bits for the next tick: bits that changed and changed back since the last tick are inverted.
template <class Word>
Word bitsToReport(Word now, Word changed, Word given) {
    const auto blips = static_cast<Word>(changed & static_cast<Word>(~(now ^ given)));
    return static_cast<Word>(now ^ blips);
}

}  // namespace

void DeviceState::handle(const Event& event) {
    switch (event.kind) {
        case EventKind::KeyDown:
        case EventKind::KeyUp: {
            const auto key = static_cast<unsigned>(event.key);
            if (event.repeated || key == 0 || key >= kKeyCount) return;
            setBit(now_.keys[key / 32], changed_.keys[key / 32], key % 32, event.kind == EventKind::KeyDown);
            return;
        }
        case EventKind::MouseDown:
        case EventKind::MouseUp:
            if (event.mouseButton >= MouseButton::Count) return;
            setBit(now_.mouseButtons, changed_.mouseButtons, static_cast<unsigned>(event.mouseButton),
                   event.kind == EventKind::MouseDown);
            [[fallthrough]];
        case EventKind::MouseMoved:
            now_.mouseX = toShort(event.position.x, 1.0f);
            now_.mouseY = toShort(event.position.y, 1.0f);
            return;
        case EventKind::MouseWheel:
            now_.wheelX = toShort(static_cast<float>(now_.wheelX) + event.motion.x * kWheelNotch, 1.0f);
            now_.wheelY = toShort(static_cast<float>(now_.wheelY) + event.motion.y * kWheelNotch, 1.0f);
            return;
        case EventKind::FocusLost: releaseAll(); return;
        case EventKind::PadAdded:
        case EventKind::PadRemoved:
        case EventKind::PadDown:
        case EventKind::PadUp:
        case EventKind::PadAxisMoved: handlePad(event); return;
        default: return;
    }
}

void DeviceState::handlePad(const Event& event) {
    if (event.pad < 0 || event.pad >= kPadCount) return;
    const auto place = static_cast<std::size_t>(event.pad);
    PadFrame& pad = now_.pads[place];
    if (event.kind == EventKind::PadAdded || event.kind == EventKind::PadRemoved) {
        setBit(now_.connectedPads, changed_.connectedPads, static_cast<unsigned>(event.pad),
               event.kind == EventKind::PadAdded);
        pad = {};
        changed_.pads[place] = {};
    } else if (event.kind == EventKind::PadAxisMoved) {
        if (event.padAxis < PadAxis::Count)
            pad.axes[static_cast<std::size_t>(event.padAxis)] = toShort(event.value, 32767.0f);
    } else if (event.padButton < PadButton::Count) {
        setBit(pad.buttons, changed_.pads[place].buttons, static_cast<unsigned>(event.padButton),
               event.kind == EventKind::PadDown);
    }
}

void DeviceState::releaseAll() {
    now_.keys = {};
    now_.mouseButtons = 0;
    now_.wheelX = now_.wheelY = 0;
    now_.pads = {};
    changed_ = {};
}

InputFrame DeviceState::take() {
    InputFrame frame = now_;
    for (std::size_t i = 0; i < frame.keys.size(); ++i) {
        frame.keys[i] = bitsToReport(now_.keys[i], changed_.keys[i], given_.keys[i]);
    }
    frame.mouseButtons = bitsToReport(now_.mouseButtons, changed_.mouseButtons, given_.mouseButtons);
    for (std::size_t i = 0; i < frame.pads.size(); ++i) {
        frame.pads[i].buttons =
            bitsToReport(now_.pads[i].buttons, changed_.pads[i].buttons, given_.pads[i].buttons);
    }
    now_.wheelX = now_.wheelY = 0;
    changed_ = {};
    given_ = frame;
    return frame;
}

}  // namespace plumb
