#pragma once

#include <cstddef>
#include <string>

#include "editor/model/document/object_id.hpp"

namespace plumb::editor {

class Document;

/// The entities that a command is about.
struct Subject {
    ObjectId first;
    std::size_t count = 0;
};

/// One change of a document that can be taken back.
class Command {
public:
    virtual ~Command() = default;

    /// Completes "Undo …": "move 3 entities".
    [[nodiscard]] virtual std::string label() const = 0;
    /// For lists of what was done; empty for what is not about entities.
    [[nodiscard]] virtual Subject subject() const { return {}; }
    virtual void apply(Document& document) = 0;
    /// Brings back exactly what was before `apply`.
    virtual void revert(Document& document) = 0;
    /// Takes over a later command of the same gesture, already applied.
    /// @return false when the two do not belong together
    virtual bool absorb([[maybe_unused]] const Command& next) { return false; }
    /// True when the document, as it is after `apply`, equals the one before.
    [[nodiscard]] virtual bool changesNothing([[maybe_unused]] const Document& document) const {
        return false;
    }
};

}  // namespace plumb::editor
