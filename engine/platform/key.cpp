#include "platform/key.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace plumb {
namespace {

constexpr auto kKeyNames = std::to_array<std::string_view>({
    // clang-format off
    "",
    "A", "B", "C", "D", "E", "F", "G", "H", "I", "J", "K", "L", "M", "N", "O", "P", "Q", "R", "S", "T", "U", "V", "W",
    "X", "Y", "Z",
    "0", "1", "2", "3", "4", "5", "6", "7", "8", "9",
    "Enter", "Escape", "Backspace", "Tab", "Space",
    "Minus", "Equals", "LeftBracket", "RightBracket", "Backslash", "Semicolon", "Apostrophe", "Grave", "Comma", "Period",
    "Slash",
    "CapsLock", "F1", "F2", "F3", "F4", "F5", "F6", "F7", "F8", "F9", "F10", "F11", "F12",
    "PrintScreen", "ScrollLock", "Pause", "Insert", "Home", "PageUp", "Delete", "End", "PageDown",
    "Right", "Left", "Down", "Up",
    "NumLock", "PadDivide", "PadMultiply", "PadMinus", "PadPlus", "PadEnter", "PadPeriod",
    "Pad0", "Pad1", "Pad2", "Pad3", "Pad4", "Pad5", "Pad6", "Pad7", "Pad8", "Pad9",
    "LeftControl", "LeftShift", "LeftAlt", "LeftSuper", "RightControl", "RightShift", "RightAlt", "RightSuper", "Menu"
    // clang-format on
});
static_assert(kKeyNames.size() == kKeyCount, "every key needs a name");

constexpr auto kMouseButtonNames = std::to_array<std::string_view>({"Left", "Middle", "Right", "X1", "X2"});
static_assert(kMouseButtonNames.size() == kMouseButtonCount, "every mouse button needs a name");

constexpr auto kPadButtonNames =
    std::to_array<std::string_view>({"A", "B", "X", "Y", "Back", "Guide", "Start", "LeftStick", "RightStick",
                                     "LeftShoulder", "RightShoulder", "Up", "Down", "Left", "Right"});
static_assert(kPadButtonNames.size() == kPadButtonCount, "every gamepad button needs a name");

constexpr auto kPadAxisNames =
    std::to_array<std::string_view>({"LeftX", "LeftY", "RightX", "RightY", "LeftTrigger", "RightTrigger"});
static_assert(kPadAxisNames.size() == kPadAxisCount, "every gamepad axis needs a name");

template <class Id>
std::string_view nameIn(std::span<const std::string_view> names, Id id) {
    const auto index = static_cast<std::size_t>(id);
    return index < names.size() ? names[index] : std::string_view{};
}

template <class Id>
std::optional<Id> idIn(std::span<const std::string_view> names, std::string_view name) {
    const auto at = std::find(names.begin(), names.end(), name);
    if (name.empty() || at == names.end()) return std::nullopt;
    return static_cast<Id>(at - names.begin());
}

}  // namespace

std::string_view nameOf(Key key) { return nameIn(kKeyNames, key); }
std::string_view nameOf(MouseButton button) { return nameIn(kMouseButtonNames, button); }
std::string_view nameOf(PadButton button) { return nameIn(kPadButtonNames, button); }
std::string_view nameOf(PadAxis axis) { return nameIn(kPadAxisNames, axis); }

std::optional<Key> keyFromName(std::string_view name) { return idIn<Key>(kKeyNames, name); }
std::optional<MouseButton> mouseButtonFromName(std::string_view name) {
    return idIn<MouseButton>(kMouseButtonNames, name);
}
std::optional<PadButton> padButtonFromName(std::string_view name) {
    return idIn<PadButton>(kPadButtonNames, name);
}
std::optional<PadAxis> padAxisFromName(std::string_view name) { return idIn<PadAxis>(kPadAxisNames, name); }

}  // namespace plumb
