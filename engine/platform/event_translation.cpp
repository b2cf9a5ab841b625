#include "platform/event_translation.hpp"

#include <algorithm>
#include <optional>

#include <SDL.h>

#include "core/log.hpp"
#include "platform/key_codes.hpp"

namespace plumb {
namespace {

Modifiers heldModifiers() {
    const int held = SDL_GetModState();
    return {.shift = (held & KMOD_SHIFT) != 0,
            .control = (held & (KMOD_CTRL | KMOD_GUI)) != 0,
            .alt = (held & KMOD_ALT) != 0};
}

Vec2 place(Sint32 x, Sint32 y) { return {static_cast<float>(x), static_cast<float>(y)}; }

std::optional<Event> keyEvent(const SDL_KeyboardEvent& from) {
    Event event{.kind = from.type == SDL_KEYDOWN ? EventKind::KeyDown : EventKind::KeyUp};
    event.key = keyFromUsage(from.keysym.scancode);
    event.repeated = from.repeat != 0;
    event.modifiers = heldModifiers();
    if (event.key == Key::None) return std::nullopt;
    return event;
}

std::optional<Event> mouseButtonEvent(const SDL_MouseButtonEvent& from) {
    // SDL counts left, middle, right, x1, x2 from 1.
    if (from.button < 1 || from.button > kMouseButtonCount) return std::nullopt;
    Event event{.kind = from.type == SDL_MOUSEBUTTONDOWN ? EventKind::MouseDown : EventKind::MouseUp};
    event.mouseButton = static_cast<MouseButton>(from.button - 1);
    event.clicks = from.clicks;
    event.position = place(from.x, from.y);
    event.modifiers = heldModifiers();
    return event;
}

std::optional<Event> wheelEvent(const SDL_MouseWheelEvent& from) {
    Event event{.kind = EventKind::MouseWheel};
    const float sign = from.direction == SDL_MOUSEWHEEL_FLIPPED ? -1.0f : 1.0f;
    event.motion = Vec2{from.preciseX, from.preciseY} * sign;
    event.position = place(from.mouseX, from.mouseY);
    event.modifiers = heldModifiers();
    return event;
}

std::optional<Event> windowEvent(const SDL_WindowEvent& from) {
    switch (from.event) {
        case SDL_WINDOWEVENT_FOCUS_GAINED: return Event{.kind = EventKind::FocusGained};
        case SDL_WINDOWEVENT_FOCUS_LOST: return Event{.kind = EventKind::FocusLost};
        case SDL_WINDOWEVENT_SIZE_CHANGED: {
            Event event{.kind = EventKind::Resized};
            event.position = place(from.data1, from.data2);
            return event;
        }
        default: return std::nullopt;
    }
}

Event textEvent(EventKind kind, const char* text) {
    Event event{.kind = kind};
    event.text = text;
    return event;
}

/// -32768..32767 as -1..1, including both ends.
float axisValue(Sint16 value) { return std::max(static_cast<float>(value) / 32767.0f, -1.0f); }

}  // namespace

EventTranslation::~EventTranslation() {
    for (const Pad& pad : pads_) {
        if (pad.controller != nullptr)
            SDL_GameControllerClose(static_cast<SDL_GameController*>(pad.controller));
    }
}

std::optional<int> EventTranslation::slotOf(std::int32_t instance) const {
    for (int i = 0; i < kPadCount; ++i) {
        const Pad& pad = pads_[static_cast<std::size_t>(i)];
        if (pad.controller != nullptr && pad.instance == instance) return i;
    }
    return std::nullopt;
}

std::optional<Event> EventTranslation::addPad(int device) {
    SDL_GameController* controller = SDL_GameControllerOpen(device);
    if (controller == nullptr) return std::nullopt;
    const SDL_JoystickID instance = SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(controller));
    const auto free =
        std::find_if(pads_.begin(), pads_.end(), [](const Pad& pad) { return pad.controller == nullptr; });
    // SDL reports a pad that is connected at the start twice.
    if (slotOf(instance) || free == pads_.end()) {
        SDL_GameControllerClose(controller);
        return std::nullopt;
    }
    *free = {controller, instance};
    Event event{.kind = EventKind::PadAdded};
    event.pad = static_cast<int>(free - pads_.begin());
    const char* name = SDL_GameControllerName(controller);
    logNote("Input", "Gamepad {} connected: {}", event.pad + 1, name != nullptr ? name : "unnamed");
    return event;
}

std::optional<Event> EventTranslation::removePad(std::int32_t instance) {
    const std::optional<int> index = slotOf(instance);
    if (!index) return std::nullopt;
    Pad& pad = pads_[static_cast<std::size_t>(*index)];
    SDL_GameControllerClose(static_cast<SDL_GameController*>(pad.controller));
    pad = {};
    Event event{.kind = EventKind::PadRemoved};
    event.pad = *index;
    return event;
}

std::optional<Event> EventTranslation::translate(const SDL_Event& from) {
    switch (from.type) {
        case SDL_QUIT: return Event{.kind = EventKind::Quit};
        case SDL_WINDOWEVENT: return windowEvent(from.window);
        case SDL_KEYDOWN:
        case SDL_KEYUP: return keyEvent(from.key);
        case SDL_TEXTINPUT: return textEvent(EventKind::TextInput, from.text.text);
        case SDL_MOUSEMOTION: {
            Event event{.kind = EventKind::MouseMoved};
            event.position = place(from.motion.x, from.motion.y);
            event.motion = place(from.motion.xrel, from.motion.yrel);
            return event;
        }
        case SDL_MOUSEBUTTONDOWN:
        case SDL_MOUSEBUTTONUP: return mouseButtonEvent(from.button);
        case SDL_MOUSEWHEEL: return wheelEvent(from.wheel);
        case SDL_CONTROLLERDEVICEADDED: return addPad(from.cdevice.which);
        case SDL_CONTROLLERDEVICEREMOVED: return removePad(from.cdevice.which);
        case SDL_CONTROLLERBUTTONDOWN:
        case SDL_CONTROLLERBUTTONUP:
            return padButtonEvent(from.type == SDL_CONTROLLERBUTTONDOWN, from.cbutton.which,
                                  from.cbutton.button);
        case SDL_CONTROLLERAXISMOTION:
            return padAxisEvent(from.caxis.which, from.caxis.axis, axisValue(from.caxis.value));
        case SDL_DROPFILE: {
            // SDL passes ownership of the path.
            Event event = textEvent(EventKind::FileDropped, from.drop.file);
            SDL_free(from.drop.file);
            return event;
        }
        default: return std::nullopt;
    }
}

std::optional<Event> EventTranslation::padButtonEvent(bool down, std::int32_t instance, int button) const {
    const std::optional<int> index = slotOf(instance);
    if (!index || button < 0 || button >= static_cast<int>(kPadButtonCount)) return std::nullopt;
    Event event{.kind = down ? EventKind::PadDown : EventKind::PadUp};
    event.pad = *index;
    event.padButton = static_cast<PadButton>(button);
    return event;
}

std::optional<Event> EventTranslation::padAxisEvent(std::int32_t instance, int axis, float value) const {
    const std::optional<int> index = slotOf(instance);
    if (!index || axis < 0 || axis >= static_cast<int>(kPadAxisCount)) return std::nullopt;
    Event event{.kind = EventKind::PadAxisMoved};
    event.pad = *index;
    event.padAxis = static_cast<PadAxis>(axis);
    event.value = value;
    return event;
}

}  // namespace plumb
