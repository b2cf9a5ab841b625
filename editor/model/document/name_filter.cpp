#include "editor/model/document/name_filter.hpp"

#include <algorithm>
#include <cctype>

#include "core/text.hpp"

namespace plumb::editor {

bool containsWord(std::string_view text, std::string_view part) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

NameFilter::NameFilter(std::string_view words, const TypeRegistry& types) {
    for (const std::string_view written : split(words, ' ')) {
        const bool ofComponent = startsWith(written, "c:");
        const std::string_view part = ofComponent ? written.substr(2) : written;
        if (part.empty()) continue;
        Word& word = words_.emplace_back();
        if (!ofComponent) word.name = part;
        for (const TypeInfo& type : types.all()) {
            if (containsWord(type.name, part)) word.types.push_back(&type);
        }
    }
}

bool NameFilter::matches(const Document& document, ObjectId id) const {
    const EntityId entity = document.find(id);
    return std::all_of(words_.begin(), words_.end(), [&](const Word& word) {
        return (!word.name.empty() && containsWord(document.nameOf(id), word.name)) ||
               std::any_of(word.types.begin(), word.types.end(),
                           [&](const TypeInfo* type) { return document.world.has(*type, entity); });
    });
}

}  // namespace plumb::editor
