#pragma once

#include <string_view>

namespace plumb {

/// The known attributes of one element of Tiled files, in XML and JSON format.
struct TmxElement {
    std::string_view name;
    std::string_view read;          ///< attributes that are imported, separated by spaces
    std::string_view ignored = {};  ///< attributes that only Tiled uses, separated by spaces
    bool editorOnly = false;        ///< only Tiled uses the element; it is skipped with its content

    [[nodiscard]] bool reads(std::string_view attribute) const;
    [[nodiscard]] bool isEditorOnly(std::string_view attribute) const;
};

/// Returns the known attributes of an element; null if no Tiled version up to 1.12 writes it.
const TmxElement* findTmxElement(std::string_view name);

}  // namespace plumb
