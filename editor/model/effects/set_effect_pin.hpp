#pragma once

#include <string>

#include "ecs/system_gates.hpp"
#include "editor/model/document/command.hpp"
#include "reflect/json.hpp"

namespace plumb::editor {

/// Sets an engine effect to on or off in the object "effects" of the scene file; Auto removes its entry.
class SetEffectPin final : public Command {
public:
    SetEffectPin(std::string effect, Pin pin) : effect_{std::move(effect)}, pin_{pin} {}

    [[nodiscard]] std::string label() const override;
    void apply(Document& document) override;
    void revert(Document& document) override;
    [[nodiscard]] bool changesNothing(const Document&) const override { return before_ == after_; }

private:
    std::string effect_;
    Pin pin_;
    Json before_;  // the whole object "effects", so that undo restores its order
    Json after_;
};

}  // namespace plumb::editor
