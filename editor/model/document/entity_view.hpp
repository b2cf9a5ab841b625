#pragma once

#include <cstdint>
#include <set>

#include "editor/model/document/object_id.hpp"

namespace plumb::editor {

/// Which entities one sees, and which the mouse goes through, while editing; and which tile layer is shown
/// alone. A way of looking: never undone, and not in the scene's file, so that no other person's git sees it.
/// It is kept in the project's own folder of the editor (see view_file.hpp).
class EntityView {
public:
    /// Of a tile layer: whether it is out of sight by itself or because another one is shown alone.
    [[nodiscard]] bool hides(ObjectId layer) const { return solo_ ? layer != solo_ : isHidden(layer); }
    [[nodiscard]] bool isHidden(ObjectId id) const { return hidden_.count(id) > 0; }
    [[nodiscard]] bool locks(ObjectId id) const { return locked_.count(id) > 0; }
    [[nodiscard]] ObjectId solo() const { return solo_; }
    [[nodiscard]] const std::set<ObjectId>& hidden() const { return hidden_; }
    [[nodiscard]] const std::set<ObjectId>& locked() const { return locked_; }
    [[nodiscard]] bool showsAll() const { return hidden_.empty() && locked_.empty(); }
    [[nodiscard]] std::uint64_t revision() const { return revision_; }  ///< grows with every change

    void setHidden(ObjectId id, bool hidden) { set(hidden_, id, hidden); }
    void setLocked(ObjectId id, bool locked) { set(locked_, id, locked); }
    void toggleHidden(ObjectId id) { setHidden(id, !isHidden(id)); }
    void toggleLocked(ObjectId id) { setLocked(id, !locks(id)); }
    /// Shows this one alone, or all again.
    void toggleSolo(ObjectId layer) { solo_ = solo_ == layer ? ObjectId{} : layer, ++revision_; }
    void clear() { hidden_.clear(), locked_.clear(), solo_ = {}, ++revision_; }

private:
    void set(std::set<ObjectId>& ids, ObjectId id, bool in) {
        if (in ? ids.insert(id).second : ids.erase(id) > 0) ++revision_;
    }

    std::set<ObjectId> hidden_;
    std::set<ObjectId> locked_;
    ObjectId solo_;
    std::uint64_t revision_ = 0;
};

}  // namespace plumb::editor
