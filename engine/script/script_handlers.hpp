#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

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
    kOnTriggerExit = 256
};
/// Names of the handlers, in the order of their bits.
inline constexpr std::array<const char*, 9> kScriptHandlers{
    "onCreate",        "onTick",         "onReload",      "onCollisionEnter", "onCollisionStay",
    "onCollisionExit", "onTriggerEnter", "onTriggerStay", "onTriggerExit"};

constexpr const char* nameOf(std::uint32_t handler) {
    std::size_t index = 0;
    while ((handler >>= 1) != 0) ++index;
    return kScriptHandlers[index];
}

}  // namespace plumb
