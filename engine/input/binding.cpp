#include "input/binding.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/text.hpp"

namespace plumb {
namespace {

constexpr std::string_view kMousePrefix = "Mouse ";
constexpr std::string_view kPadPrefix = "Pad";

template <class Id>
Binding bindingOf(BindingKind kind, Id id, std::int8_t pad = Binding::kAnyPad) {
    return {kind, static_cast<std::uint8_t>(id), pad};
}

std::optional<Binding> padBindingFromText(std::string_view name, std::int8_t pad) {
    if (const auto button = padButtonFromName(name)) return bindingOf(BindingKind::PadButton, *button, pad);
    if (const auto axis = padAxisFromName(name)) return bindingOf(BindingKind::PadAxis, *axis, pad);
    if (name.empty() || (name.back() != '+' && name.back() != '-')) return std::nullopt;
    const auto axis = padAxisFromName(name.substr(0, name.size() - 1));
    if (!axis) return std::nullopt;
    return bindingOf(name.back() == '+' ? BindingKind::PadAxisPlus : BindingKind::PadAxisMinus, *axis, pad);
}

/// Returns both axes of the stick to which an axis belongs; nothing for triggers.
std::optional<std::pair<PadAxis, PadAxis>> stickOf(PadAxis axis) {
    if (axis == PadAxis::LeftX || axis == PadAxis::LeftY) return std::pair{PadAxis::LeftX, PadAxis::LeftY};
    if (axis == PadAxis::RightX || axis == PadAxis::RightY)
        return std::pair{PadAxis::RightX, PadAxis::RightY};
    return std::nullopt;
}

float axisOf(const PadFrame& pad, PadAxis axis, float deadZone) {
    const float value = pad.axis(axis);
    float reach = std::abs(value);
    if (const auto stick = stickOf(axis))
        reach = length(Vec2{pad.axis(stick->first), pad.axis(stick->second)});
    if (reach <= deadZone || deadZone >= 1.0f) return 0.0f;
    const float stretched = (std::min(reach, 1.0f) - deadZone) / (1.0f - deadZone);
    return std::clamp(value / reach * stretched, -1.0f, 1.0f);
}

float strengthOn(Binding binding, const PadFrame& pad, float deadZone) {
    const auto axis = static_cast<PadAxis>(binding.code);
    switch (binding.kind) {
        case BindingKind::PadButton: return pad.has(static_cast<PadButton>(binding.code)) ? 1.0f : 0.0f;
        case BindingKind::PadAxis: return axisOf(pad, axis, deadZone);
        case BindingKind::PadAxisPlus: return std::max(axisOf(pad, axis, deadZone), 0.0f);
        case BindingKind::PadAxisMinus: return std::max(-axisOf(pad, axis, deadZone), 0.0f);
        default: return 0.0f;
    }
}

std::vector<std::string> allNames() {
    std::vector<std::string> names;
    const auto addAll = [&](BindingKind kind, std::size_t count, std::size_t first) {
        for (std::size_t code = first; code < count; ++code) names.push_back(toText(bindingOf(kind, code)));
    };
    addAll(BindingKind::Key, kKeyCount, 1);
    addAll(BindingKind::MouseButton, kMouseButtonCount, 0);
    addAll(BindingKind::PadButton, kPadButtonCount, 0);
    addAll(BindingKind::PadAxis, kPadAxisCount, 0);
    return names;
}

}  // namespace

std::string toText(Binding binding) {
    const auto padText = [&](std::string_view name, std::string_view half) {
        const std::string place = binding.pad == Binding::kAnyPad ? "" : format("{}", binding.pad + 1);
        return format("Pad{} {}{}", place, name, half);
    };
    const std::string_view axis = nameOf(static_cast<PadAxis>(binding.code));
    switch (binding.kind) {
        case BindingKind::Key: return std::string{nameOf(static_cast<Key>(binding.code))};
        case BindingKind::MouseButton:
            return format("Mouse {}", nameOf(static_cast<MouseButton>(binding.code)));
        case BindingKind::PadButton: return padText(nameOf(static_cast<PadButton>(binding.code)), "");
        case BindingKind::PadAxis: return padText(axis, "");
        case BindingKind::PadAxisPlus: return padText(axis, "+");
        case BindingKind::PadAxisMinus: return padText(axis, "-");
    }
    return {};
}

std::optional<Binding> bindingFromText(std::string_view text) {
    if (const auto key = keyFromName(text)) return bindingOf(BindingKind::Key, *key);
    if (startsWith(text, kMousePrefix)) {
        const auto button = mouseButtonFromName(text.substr(kMousePrefix.size()));
        return button ? std::optional{bindingOf(BindingKind::MouseButton, *button)} : std::nullopt;
    }
    if (!startsWith(text, kPadPrefix)) return std::nullopt;
    text.remove_prefix(kPadPrefix.size());
    std::int8_t pad = Binding::kAnyPad;
    if (!text.empty() && text[0] >= '1' && text[0] < '1' + kPadCount) {
        pad = static_cast<std::int8_t>(text[0] - '1');
        text.remove_prefix(1);
    }
    return startsWith(text, " ") ? padBindingFromText(text.substr(1), pad) : std::nullopt;
}

std::string closestBinding(std::string_view text) {
    const std::vector<std::string> names = allNames();
    const std::vector<std::string_view> views{names.begin(), names.end()};
    return std::string{closestName(text, views)};
}

float strengthOf(Binding binding, const InputFrame& frame, float deadZone) {
    if (binding.kind == BindingKind::Key) return frame.has(static_cast<Key>(binding.code)) ? 1.0f : 0.0f;
    if (binding.kind == BindingKind::MouseButton) {
        return frame.has(static_cast<MouseButton>(binding.code)) ? 1.0f : 0.0f;
    }
    if (binding.pad != Binding::kAnyPad) {
        return strengthOn(binding, frame.pads[static_cast<std::size_t>(binding.pad)], deadZone);
    }
    float strongest = 0.0f;
    for (const PadFrame& pad : frame.pads) {
        const float strength = strengthOn(binding, pad, deadZone);
        if (std::abs(strength) > std::abs(strongest)) strongest = strength;
    }
    return strongest;
}

bool isHeld(Binding binding, const InputFrame& frame, float deadZone) {
    return std::abs(strengthOf(binding, frame, deadZone)) > 0.5f;
}

}  // namespace plumb
