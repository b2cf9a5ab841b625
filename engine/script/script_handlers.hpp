#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace plumb {

/// Functions that the engine calls if a script has them.
enum ScriptHandler : std::uint32_t {
    kOnCreate = 1,
    kOnTick = 2,
    kOnReload = 4,
    kOnCollisionEnter = 8,
    kOnCollisionStay = 16,
    kOnCollisionExit = 32,
    kOnTriggerEnter = 64,
    kOnTriggerStay = 128,
    kOnTriggerExit = 256,
    kOnDestroy = 512,
    kOnLoad = 1024
};
/// Names of the handlers, in the order of their bits.
inline constexpr std::array<std::string_view, 11> kScriptHandlers{
    "onCreate",        "onTick",          "onReload",       "onCollisionEnter",
    "onCollisionStay", "onCollisionExit", "onTriggerEnter", "onTriggerStay",
    "onTriggerExit",   "onDestroy",       "onLoad"};
/// What the names of handlers of events begin with: onEvent_NAME.
inline constexpr std::string_view kEventHandler = "onEvent_";

constexpr std::string_view nameOf(std::uint32_t handler) {
    std::size_t index = 0;
    while ((handler >>= 1) != 0) ++index;
    return kScriptHandlers[index];
}

/// True if the engine calls a function of this name.
bool isHandlerName(std::string_view name);
/// Returns the handler that a function of another name was probably meant to be; empty if there is none.
std::string handlerMeant(std::string_view name);

}  // namespace plumb
