#pragma once

#include <algorithm>
#include <vector>

#include "editor/model/document/id_table.hpp"
#include "editor/model/document/object_id.hpp"

namespace plumb::editor {

/// The selected entities in order of selection; the last one is the active one. Not part of the undo history.
class Selection {
public:
    [[nodiscard]] const std::vector<ObjectId>& all() const { return ids_; }
    [[nodiscard]] bool empty() const { return ids_.empty(); }
    [[nodiscard]] std::size_t size() const { return ids_.size(); }
    [[nodiscard]] bool has(ObjectId id) const { return known_.find(id.value) != nullptr; }
    [[nodiscard]] std::uint64_t revision() const { return revision_; }

    void clear() { set({}); }
    void set(std::vector<ObjectId> ids) {
        ids_.clear(), known_.clear(), ++revision_;
        for (const ObjectId id : ids) append(id);
    }
    void add(ObjectId id) {
        if (append(id)) ++revision_;
    }
    /// Adds several entities in this order. The last of them becomes the active one even if already selected.
    void add(const std::vector<ObjectId>& ids) {
        for (const ObjectId id : ids) append(id);
        if (!ids.empty()) makeActive(ids.back());
    }
    void remove(ObjectId id) {
        if (known_.erase(id.value)) std::erase(ids_, id), ++revision_;
    }
    void toggle(ObjectId id) { has(id) ? remove(id) : add(id); }

private:
    bool append(ObjectId id) {
        if (!id || has(id)) return false;
        known_.set(id.value, {});
        ids_.push_back(id);
        return true;
    }
    void makeActive(ObjectId id) {
        std::erase(ids_, id), ids_.push_back(id);
        ++revision_;
    }

    std::vector<ObjectId> ids_;
    struct Nothing {};
    IdTable<Nothing> known_;  // the ids of ids_, for lookup
    std::uint64_t revision_ = 0;
};

}  // namespace plumb::editor
