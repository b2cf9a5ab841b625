#pragma once

#include "core/hash.hpp"
#include "core/text_store.hpp"

namespace plumb {

/// Scene changes that the simulation requests for the end of this tick. A world resource; the game reads and
/// clears it between ticks. Of several in one tick, the top overlay is closed first, then the last `next` is
/// opened; the scene is reloaded only if there is none.
struct SceneRequests {
    TextId next;           ///< path of the scene to change to, or to open as an overlay; empty for none
    bool overlay = false;  ///< open `next` as an overlay over the current scene
    bool close = false;    ///< close the top overlay
    bool reload = false;   ///< reload the current scene
    bool quit = false;     ///< quit the game

    [[nodiscard]] bool empty() const { return next.empty() && !close && !reload && !quit; }
    void addTo(Hasher& hasher) const {
        hasher.add(next.value);
        hasher.add(std::uint64_t{overlay} | std::uint64_t{close} << 1 | std::uint64_t{reload} << 2 |
                   std::uint64_t{quit} << 3);
    }
};

}  // namespace plumb
