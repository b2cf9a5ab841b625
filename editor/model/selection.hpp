#pragma once

#include <algorithm>
#include <vector>

#include "editor/model/object_id.hpp"

namespace plumb::editor {

/// What is selected, in the order of selecting: the last one is the one in hand. Not an edit: never undone.
class Selection {
public:
    [[nodiscard]] const std::vector<ObjectId>& all() const { return ids_; }
    [[nodiscard]] bool empty() const { return ids_.empty(); }
    [[nodiscard]] std::size_t size() const { return ids_.size(); }
    [[nodiscard]] bool has(ObjectId id) const {
        return std::find(ids_.begin(), ids_.end(), id) != ids_.end();
    }
    [[nodiscard]] std::uint64_t revision() const { return revision_; }

    void clear() { set({}); }
    void set(std::vector<ObjectId> ids) { ids_ = std::move(ids), ++revision_; }
    void add(ObjectId id) {
        if (!has(id)) ids_.push_back(id), ++revision_;
    }
    void remove(ObjectId id) {
        if (std::erase(ids_, id) > 0) ++revision_;
    }
    void toggle(ObjectId id) { has(id) ? remove(id) : add(id); }

private:
    std::vector<ObjectId> ids_;
    std::uint64_t revision_ = 0;
};

}  // namespace plumb::editor
