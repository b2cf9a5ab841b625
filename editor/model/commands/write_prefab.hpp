#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/file.hpp"
#include "editor/model/document/command.hpp"
#include "editor/model/document/field_value.hpp"
#include "scene/files/prefab.hpp"

namespace plumb::editor {

/// Replaces the text of a prefab's file and updates the components of its instances. The file is written
/// completely or not at all; an error is logged, and the document is changed in any case.
class WritePrefab final : public Command {
public:
    struct Change {
        ObjectId object;
        const TypeInfo* type = nullptr;
        std::optional<ComponentState> state;  ///< nullopt: the component is removed
    };

    /// @param prefabs  must outlive the command
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
    std::string text_;             // text to swap in: the new one, after `apply` the old one
    std::vector<Change> changes_;  // states to swap in: the new ones, after `apply` the old ones
};

}  // namespace plumb::editor
