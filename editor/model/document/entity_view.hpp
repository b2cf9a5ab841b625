#pragma once

#include <cstdint>
#include <set>

#include "editor/model/document/object_id.hpp"

namespace plumb::editor {

/// Entities that are hidden or locked in the editor, and the tile layer that is shown alone (solo). Not part
/// of the undo history nor of the scene's file, so it causes no changes under version control; stored in the
/// editor's folder of the project (view_file.hpp).
class EntityView {
public:
    /// True if a tile layer is hidden itself or because another one is shown alone.
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
    /// Shows this tile layer alone; if it is already shown alone, shows all layers again.
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
