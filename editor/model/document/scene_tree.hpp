#pragma once

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "editor/model/document/document.hpp"

namespace plumb::editor {

/// The rows of the scene tree as a flat list, so that only visible rows need drawing. Rebuilt only when the
/// tree, the filter or the set of closed rows changes.
class SceneTree {
public:
    struct Row {
        ObjectId id;
        int depth = 0;
        bool parent = false;  ///< the entity has children, shown or not
    };

    /// Updates the rows. @param words  filter text (name_filter.hpp); if not empty, rows list only matches
    void follow(const Document& document, std::string_view words);

    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
    [[nodiscard]] bool filters() const { return filters_; }
    [[nodiscard]] bool isClosed(ObjectId id) const { return closed_.count(id.value) > 0; }
    void setClosed(ObjectId id, bool closed);
    /// Opens all ancestors of an entity.
    void openTo(const Document& document, ObjectId id);
    /// Returns the index of an entity's row; rows().size() if it has none.
    [[nodiscard]] std::size_t rowOf(ObjectId id) const;
    /// Returns the entities of all rows between two entities, both included, `to` last.
    [[nodiscard]] std::vector<ObjectId> range(ObjectId from, ObjectId to) const;

private:
    /// An entity and its parent.
    struct Child {
        EntityId parent;
        ObjectId id;
    };

    void makeTree(const Document& document);
    void addRows(const Document& document, EntityId parent, int depth);

    std::vector<Row> rows_;
    std::vector<Child> children_;  // sorted by parent, then by file order
    std::unordered_set<std::uint64_t> closed_;
    std::string words_;
    bool filters_ = false;        // the filter is not empty
    std::uint64_t tree_ = ~0ull;  // Document::treeRevision of the rows
    bool stale_ = true;
};

}  // namespace plumb::editor
