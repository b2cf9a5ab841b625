#pragma once

#include <span>
#include <string>

#include "editor/model/shared_components.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// A button that opens a list of all component types, searchable by name and description.
class AddComponent {
public:
    /// @param held  component types of the entities `ids`; a type that all of them have is not listed
    void draw(Ui& ui, const std::vector<ObjectId>& ids, std::span<const ComponentHolders> held);

private:
    void drawList(Ui& ui, const std::vector<ObjectId>& ids, std::span<const ComponentHolders> held,
                  bool first);

    std::string search_;
};

}  // namespace plumb::editor::ui
