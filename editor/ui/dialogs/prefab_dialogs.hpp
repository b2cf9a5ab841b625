#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "editor/model/prefabs/override_list.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The dialogs that ask for the name of a new prefab, and that list the overrides of an instance.
class PrefabDialogs {
public:
    void draw(Ui& ui);

private:
    void open(Ui& ui);
    void drawName(Ui& ui);
    void drawOverrides(Ui& ui);
    void drawRow(Ui& ui, const OverrideRow& row, std::size_t index);

    std::array<char, 64> name_{};
    std::string problem_;            // error of the last try to make a prefab
    std::vector<OverrideRow> rows_;  // overrides of `instance_`
    std::uint64_t rowsOf_ = ~0ull;   // revision of the scene for which `rows_` was computed
    ObjectId instance_;              // entity whose overrides are shown
};

}  // namespace plumb::editor::ui
