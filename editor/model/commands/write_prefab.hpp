#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/file.hpp"
#include "editor/model/document/command.hpp"
#include "editor/model/document/field_value.hpp"
#include "scene/files/prefab.hpp"

namespace plumb::editor {

/// Exchanges the text of a prefab's file, and with it the components of its instances that follow. The file
/// is written as a whole or not at all; what goes wrong is in the log, and the document still follows.
class WritePrefab final : public Command {
public:
    struct Change {
        ObjectId object;
        const TypeInfo* type = nullptr;
        std::optional<ComponentState> state;  ///< nothing: the entity has no such component
    };

    /// @param prefabs  outlives the command
    WritePrefab(std::string label, PrefabLibrary& prefabs, Path file, std::string text,
                std::vector<Change> changes)
        : label_{std::move(label)},
          prefabs_{prefabs},
          file_{std::move(file)},
          text_{std::move(text)},
          changes_{std::move(changes)} {}

    [[nodiscard]] std::string label() const override { return label_; }
    void apply(Document& document) override { swap(document); }
    void revert(Document& document) override { swap(document); }

private:
    void swap(Document& document);

    std::string label_;
    PrefabLibrary& prefabs_;
    Path file_;
    std::string text_;             // what is not in the file now
    std::vector<Change> changes_;  // what is not in the document now
};

}  // namespace plumb::editor
