#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "editor/model/document/document.hpp"

namespace plumb::editor {

/// True if `text` contains `part`, ignoring case.
bool containsWord(std::string_view text, std::string_view part);

/// Filter for finding entities by typed words: each word must occur in the entity's name or in the name of
/// one of its components; "c:body" matches component names only.
class NameFilter {
public:
    NameFilter(std::string_view words, const TypeRegistry& types);

    [[nodiscard]] bool empty() const { return words_.empty(); }
    [[nodiscard]] bool matches(const Document& document, ObjectId id) const;

private:
    struct Word {
        std::string name;                    ///< part of the entity's name; empty: "c:" search
        std::vector<const TypeInfo*> types;  ///< components whose names contain the word
    };
    std::vector<Word> words_;
};

}  // namespace plumb::editor
