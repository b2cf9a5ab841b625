#pragma once

#include <string_view>

#include "core/file.hpp"
#include "editor/model/document/entity_view.hpp"

namespace plumb::editor {

/// Stores the hidden and locked entities of each scene in the project's folder `.plumb/view`, which git
/// ignores.
class ViewFile {
public:
    explicit ViewFile(Path project) : project_{std::move(project)} {}

    /// Restores the hidden and locked entities of a scene.
    void read(std::string_view scene, EntityView& view);
    /// Writes the file if the view has changed. Write errors are ignored, as no work is lost.
    void keep(std::string_view scene, const EntityView& view);

private:
    [[nodiscard]] Path fileOf(std::string_view scene) const;

    Path project_;
    std::uint64_t kept_ = 0;  // revision of the view stored in the file
};

}  // namespace plumb::editor
