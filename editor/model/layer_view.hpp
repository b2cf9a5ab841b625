#pragma once

#include <algorithm>
#include <vector>

#include "editor/model/object_id.hpp"

namespace plumb::editor {

/// Which layers one sees and may change while editing. A way of looking: not saved, never undone.
class LayerView {
public:
    [[nodiscard]] bool hides(ObjectId layer) const { return solo_ ? layer != solo_ : has(hidden_, layer); }
    [[nodiscard]] bool isHidden(ObjectId layer) const { return has(hidden_, layer); }
    [[nodiscard]] bool locks(ObjectId layer) const { return has(locked_, layer); }
    [[nodiscard]] ObjectId solo() const { return solo_; }

    void toggleHidden(ObjectId layer) { toggle(hidden_, layer); }
    void toggleLocked(ObjectId layer) { toggle(locked_, layer); }
    /// Shows this one alone, or all again.
    void toggleSolo(ObjectId layer) { solo_ = solo_ == layer ? ObjectId{} : layer; }
    void clear() { *this = {}; }

private:
    static bool has(const std::vector<ObjectId>& ids, ObjectId id) {
        return std::find(ids.begin(), ids.end(), id) != ids.end();
    }
    static void toggle(std::vector<ObjectId>& ids, ObjectId id) {
        if (std::erase(ids, id) == 0) ids.push_back(id);
    }

    std::vector<ObjectId> hidden_;
    std::vector<ObjectId> locked_;
    ObjectId solo_;
};

}  // namespace plumb::editor
