#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "editor/model/document/field_value.hpp"

namespace plumb::editor {

/// The user's change of one field in a running game.
struct PlayEdit {
    std::int64_t tick = 0;  ///< the change was made after this tick
    ObjectId object;
    const TypeInfo* type = nullptr;
    const FieldInfo* field = nullptr;
    FieldValue value;
    bool rewound = false;  ///< the game was rewound to before this change and continued from there

    [[nodiscard]] bool sameField(const PlayEdit& other) const {
        return object == other.object && type == other.type && field == other.field;
    }
};

/// The user's changes to a running game. They are applied again when recorded ticks are replayed, and can be
/// copied to the scene when the game stops.
class PlayEdits {
public:
    void clear() { log_.clear(), last_.clear(); }
    void add(const PlayEdit& edit);
    /// Applies the changes made after this tick again. Skips entities that do not exist, as in the first run.
    void replay(World& world, const ObjectNames& names, std::int64_t tick) const;
    /// Removes all later changes from the log, as the game continues from this tick; `last` keeps them as
    /// `rewound`.
    void cut(std::int64_t tick);
    /// Removes the changes made before this tick from the log, so that they are not replayed.
    void forgetBefore(std::int64_t tick);

    /// The last change of each field, in the order of the first change.
    [[nodiscard]] const std::vector<PlayEdit>& last() const { return last_; }
    /// The changes that are replayed, sorted by tick.
    [[nodiscard]] std::span<const PlayEdit> log() const { return log_; }

private:
    std::vector<PlayEdit> log_;  // sorted by tick
    std::vector<PlayEdit> last_;
};

/// Applies a change to a world. @return false if the entity or its component does not exist there
bool writePlayed(World& world, const ObjectNames& names, const PlayEdit& edit);

}  // namespace plumb::editor
