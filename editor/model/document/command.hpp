#pragma once

#include <cstddef>
#include <string>

#include "editor/model/document/object_id.hpp"

namespace plumb::editor {

class Document;

/// The entities that a command changes: the first of them, and their number.
struct Subject {
    ObjectId first;
    std::size_t count = 0;
};

/// A change of a document that can be undone.
class Command {
public:
    virtual ~Command() = default;

    /// Completes "Undo …": "move 3 entities".
    [[nodiscard]] virtual std::string label() const = 0;
    /// The changed entities, for the history panel; empty for commands that change no entities.
    [[nodiscard]] virtual Subject subject() const { return {}; }
    virtual void apply(Document& document) = 0;
    /// Restores exactly the state before `apply`.
    virtual void revert(Document& document) = 0;
    /// Merges the next command of the same gesture, which is already applied, into this one.
    /// @return false if they cannot be merged
    virtual bool absorb([[maybe_unused]] const Command& next) { return false; }
    /// True if the document after `apply` equals the one before it.
    [[nodiscard]] virtual bool changesNothing([[maybe_unused]] const Document& document) const {
        return false;
    }
};

}  // namespace plumb::editor
