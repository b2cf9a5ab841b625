#pragma once

#include <string>

#include "ecs/system_gates.hpp"
#include "editor/model/document/command.hpp"
#include "reflect/json.hpp"

namespace plumb::editor {

/// Writes into the scene file's "effects" whether one of them is on or off; auto takes its line away.
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
    Json before_;  // all of "effects", so that its lines keep their order
    Json after_;
};

}  // namespace plumb::editor
