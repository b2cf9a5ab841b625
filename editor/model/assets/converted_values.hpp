#pragma once

#include <cstddef>
#include <vector>

#include "app/game_content.hpp"
#include "editor/model/document/document.hpp"

namespace plumb::editor {

/// Numbers of the edited scene whose fields have another kind in a new version of the code, e.g. 2.5 of a
/// float that is an integer now. World::convert converts them, but a scene's text that the old version wrote
/// has values that the new one does not accept. Without those of prefab instances, as their text says which
/// of them differ from the prefab.
class ConvertedValues {
public:
    /// @param document  after convertWorld()
    ConvertedValues(const Document& document, const ContentChange& change);

    /// Writes them into the scene, after it was read from its text.
    /// @return true if there are any that the text does not have
    bool restore(Document& document) const;

private:
    struct Field {
        FieldInfo before;
        FieldInfo now;
    };
    struct Component {
        ObjectId object;
        const TypeInfo* type = nullptr;
        std::size_t fields = 0;  ///< index into fields_
        std::vector<std::byte> bytes;
    };

    std::vector<std::vector<Field>> fields_;  // of each changed type: those with another kind of number
    std::vector<Component> components_;
};

}  // namespace plumb::editor
