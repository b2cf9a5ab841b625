#include "script/script_handlers.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace plumb {
namespace {

struct OtherName {
    std::string_view other;
    std::string_view handler;
};
/// Names that a handler often has elsewhere.
constexpr std::array kOtherNames{
    OtherName{"onUpdate", "onTick"},          OtherName{"onFixedUpdate", "onTick"},
    OtherName{"onFrame", "onTick"},           OtherName{"onStart", "onCreate"},
    OtherName{"onInit", "onCreate"},          OtherName{"onReady", "onCreate"},
    OtherName{"onCreated", "onCreate"},       OtherName{"onCollision", "onCollisionEnter"},
    OtherName{"onTrigger", "onTriggerEnter"},
};

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool sameIgnoringCase(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower(x) == lower(y); });
}

/// True if one of the two names has a letter more, or the same letters with two neighbours swapped. Another
/// letter does not count: it often makes another word, as onLoad of onRoad.
bool isMistyped(std::string_view a, std::string_view b) {
    const auto same = [](char x, char y) { return lower(x) == lower(y); };
    while (!a.empty() && !b.empty() && same(a.front(), b.front())) {
        a.remove_prefix(1);
        b.remove_prefix(1);
    }
    while (!a.empty() && !b.empty() && same(a.back(), b.back())) {
        a.remove_suffix(1);
        b.remove_suffix(1);
    }
    if (a.size() == 2 && b.size() == 2) return same(a[0], b[1]) && same(a[1], b[0]);
    return a.size() + b.size() == 1;
}

}  // namespace

bool isHandlerName(std::string_view name) {
    return startsWith(name, kEventHandler) ||
           std::find(kScriptHandlers.begin(), kScriptHandlers.end(), name) != kScriptHandlers.end();
}

std::string handlerMeant(std::string_view name) {
    // Short names are near to too many others: onClick to onTick.
    constexpr std::size_t kLong = 10;
    constexpr std::string_view kEvent = "onEvent";
    if (isHandlerName(name) || name.size() <= 2 || !sameIgnoringCase(name.substr(0, 2), "on")) return {};
    for (const std::string_view handler : kScriptHandlers) {
        if (sameIgnoringCase(name, handler)) return std::string{handler};
    }
    for (const auto& [other, handler] : kOtherNames) {
        if (sameIgnoringCase(name, other)) return std::string{handler};
    }
    if (name.size() > kEvent.size() && sameIgnoringCase(name.substr(0, kEvent.size()), kEvent)) {
        const std::size_t start = name[kEvent.size()] == '_' ? kEvent.size() + 1 : kEvent.size();
        std::string event{name.substr(start)};
        if (!event.empty() && start == kEvent.size()) event[0] = lower(event[0]);
        return std::string{kEventHandler} + event;
    }
    for (const std::string_view handler : kScriptHandlers) {
        if (isMistyped(name, handler)) return std::string{handler};
    }
    return name.size() < kLong ? std::string{} : std::string{closestName(name, kScriptHandlers)};
}

}  // namespace plumb
