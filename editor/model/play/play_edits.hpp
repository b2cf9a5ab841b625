#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "editor/model/document/field_value.hpp"

namespace plumb::editor {

/// A field of a running game that was set by hand.
struct PlayEdit {
    std::int64_t tick = 0;  ///< after which it was set
    ObjectId object;
    const TypeInfo* type = nullptr;
    const FieldInfo* field = nullptr;
    FieldValue value;
    bool rewound = false;  ///< the game was taken back to before it and went on from there

    [[nodiscard]] bool sameField(const PlayEdit& other) const {
        return object == other.object && type == other.type && field == other.field;
    }
};

/// What was changed by hand while a game played: played again with the recorded ticks, and offered for
/// keeping when it stops.
class PlayEdits {
public:
    void clear() { log_.clear(), last_.clear(); }
    void add(const PlayEdit& edit);
    /// Sets again what was set after this tick. An entity that is gone is left out, as it was then.
    void replay(World& world, const ObjectNames& names, std::int64_t tick) const;
    /// The game goes on from this tick; what was set after it stays in the list, marked.
    void cut(std::int64_t tick);
    /// What was set before this tick will not be played again.
    void forgetBefore(std::int64_t tick);

    /// Each field once, with what it was set to last, in the order of the first change.
    [[nodiscard]] const std::vector<PlayEdit>& last() const { return last_; }
    [[nodiscard]] std::span<const PlayEdit> log() const { return log_; }

private:
    std::vector<PlayEdit> log_;  // by tick
    std::vector<PlayEdit> last_;
};

/// Sets a field of an entity; nothing when it is not there. @return whether it was
bool writePlayed(World& world, const ObjectNames& names, const PlayEdit& edit);

}  // namespace plumb::editor
