#pragma once

#include <span>
#include <string>

#include "editor/model/shared_components.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// A button with a list of all components, to be searched by name and by what they are for.
class AddComponent {
public:
    /// @param held  what the entities have; what all of them have is not offered
    void draw(Ui& ui, const std::vector<ObjectId>& ids, std::span<const ComponentHolders> held);

private:
    void drawList(Ui& ui, const std::vector<ObjectId>& ids, std::span<const ComponentHolders> held,
                  bool first);

    std::string search_;
};

}  // namespace plumb::editor::ui
