#pragma once

namespace plumb {

/// What the simulation requests of the program for the end of this tick: saveGame(), loadGame() and
/// showOptions(). A world resource; the loop reads it, and each tick begins without any.
struct GameRequests {
    static constexpr bool kNotSaved = true;

    int save = 0;          ///< slot, 0: none
    int load = 0;          ///< slot, 0: none
    bool options = false;  ///< open the options of the player
};

}  // namespace plumb
