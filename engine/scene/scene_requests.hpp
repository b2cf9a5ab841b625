#pragma once

#include "core/hash.hpp"
#include "core/text_store.hpp"

namespace plumb {

/// What the simulation wants to happen to scenes after this tick. A resource; the owner of the scenes reads
/// and empties it between ticks.
struct SceneRequests {
    TextId next;           ///< path of the scene to go to, or to lay over the current one; empty for none
    bool overlay = false;  ///< keep the current scene beneath, paused
    bool close = false;    ///< take the top overlay away
    bool reload = false;   ///< load the current scene anew
    bool quit = false;     ///< end the game

    [[nodiscard]] bool empty() const { return next.empty() && !close && !reload && !quit; }
    void addTo(Hasher& hasher) const {
        hasher.add(next.value);
        hasher.add(std::uint64_t{overlay} | std::uint64_t{close} << 1 | std::uint64_t{reload} << 2 |
                   std::uint64_t{quit} << 3);
    }
};

}  // namespace plumb
