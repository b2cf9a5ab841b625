#pragma once

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "editor/model/document/document.hpp"

namespace plumb::editor {

/// The entities of a scene as the rows of a tree, flat and in order, so that a window draws only those in
/// sight. Made anew only when the tree, the words of the filter or what is open changes.
class SceneTree {
public:
    struct Row {
        ObjectId id;
        int depth = 0;
        bool parent = false;  ///< has rows below it, shown or not
    };

    /// @param words  what is looked for, then all matches stand in a plain list; see NameFilter
    void follow(const Document& document, std::string_view words);

    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
    [[nodiscard]] bool filters() const { return filters_; }
    [[nodiscard]] bool isClosed(ObjectId id) const { return closed_.count(id.value) > 0; }
    void setClosed(ObjectId id, bool closed);
    /// Opens all that an entity is below.
    void openTo(const Document& document, ObjectId id);
    /// The row of an entity; rows().size() when it has none.
    [[nodiscard]] std::size_t rowOf(ObjectId id) const;
    /// All from one row to another one, that one last.
    [[nodiscard]] std::vector<ObjectId> range(ObjectId from, ObjectId to) const;

private:
    /// An entity and its place in the file.
    struct Child {
        EntityId parent;
        ObjectId id;
    };

    void makeTree(const Document& document);
    void addRows(const Document& document, EntityId parent, int depth);

    std::vector<Row> rows_;
    std::vector<Child> children_;  // by parent, then by place in the file
    std::unordered_set<std::uint64_t> closed_;
    std::string words_;
    bool filters_ = false;        // some of the words say something
    std::uint64_t tree_ = ~0ull;  // revision of the document
    bool stale_ = true;
};

}  // namespace plumb::editor
