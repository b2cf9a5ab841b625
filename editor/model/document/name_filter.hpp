#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "editor/model/document/document.hpp"

namespace plumb::editor {

/// Whether `text` has `part` in it, in any case.
bool containsWord(std::string_view text, std::string_view part);

/// What a person types to find entities: words that all must be in the name or in that of a component;
/// "c:body" only in that of a component.
class NameFilter {
public:
    NameFilter(std::string_view words, const TypeRegistry& types);

    [[nodiscard]] bool empty() const { return words_.empty(); }
    [[nodiscard]] bool matches(const Document& document, ObjectId id) const;

private:
    struct Word {
        std::string name;                    ///< to be in the name; empty: only components count
        std::vector<const TypeInfo*> types;  ///< the components that have it
    };
    std::vector<Word> words_;
};

}  // namespace plumb::editor
