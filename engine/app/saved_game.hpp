#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "ecs/world.hpp"

namespace plumb {

// The file of a saved game. All numbers are little-endian:
//
//     "PLUMBSAV"  u32 version  u32 bytes of the name, the name of the project
//     u64 bytes of the state  u64 bytes of the packed state  u64 hash of all bytes but these
//     the state of the world (World::toBytes), packed by zlib

/// Returns the bytes of the file.
/// @error a type of the game cannot be saved
Result<std::string> savedGame(const World& world, std::string_view project);

/// Reads a saved game. Its state replaces that of a game by Game::load().
/// @param world     of the running game, with its types; is not changed
/// @param where     of the file, for messages
/// @param problems  receives what was left out, as this version of the game does not have it
/// @error not a saved game, of a newer version, of another project, damaged
Result<Snapshot> readSavedGame(std::string_view bytes, const World& world, std::string_view project,
                               const std::string& where, std::vector<Error>& problems);

/// The saved games of a player: one file for each slot, which are numbered from 1 to kSaveSlots.
class SaveSlots {
public:
    /// @param folder   of the game's data
    /// @param project  name of the project
    SaveSlots(Path folder, std::string project);

    /// Saves the state of a world. After an error the slot is what it was before.
    Result<Done> save(const World& world, int slot);
    struct Saved {
        std::string file;  ///< its bytes
        Snapshot state;    ///< for Game::load()
    };
    /// Reads the saved game of a slot for a world, which is not changed. What was left out is logged.
    [[nodiscard]] Result<Saved> read(const World& world, int slot) const;
    /// One bit per slot that has a saved game: InputFrame::saves.
    [[nodiscard]] std::uint32_t filled() const { return filled_; }
    [[nodiscard]] Path fileOf(int slot) const;

private:
    Path folder_;
    std::string project_;
    std::uint32_t filled_ = 0;
};

}  // namespace plumb
