#pragma once

#include <string_view>

#include "core/file.hpp"
#include "editor/model/document/entity_view.hpp"

namespace plumb::editor {

/// What is hidden and locked in each scene, in `.plumb/view` of the project: it outlives the program, and git
/// leaves it out.
class ViewFile {
public:
    explicit ViewFile(Path project) : project_{std::move(project)} {}

    /// Hides and locks what was hidden and locked when this scene was open last.
    void read(std::string_view scene, EntityView& view);
    /// Writes it when it has changed since. What cannot be written is forgotten; no work is lost by
    /// that.
    void keep(std::string_view scene, const EntityView& view);

private:
    [[nodiscard]] Path fileOf(std::string_view scene) const;

    Path project_;
    std::uint64_t kept_ = 0;  // revision of the view that the file has
};

}  // namespace plumb::editor
