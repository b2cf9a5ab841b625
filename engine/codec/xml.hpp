#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"

namespace plumb {

struct XmlAttribute {
    std::string name;
    std::string value;
};

/// An element of an XML file with everything in it, entities already replaced.
struct XmlElement {
    std::string name;
    std::vector<XmlAttribute> attributes;
    std::vector<XmlElement> children;
    std::string text;  ///< all characters between the tags, those of CDATA sections too
    int line = 0;      ///< of the start tag, from 1

    /// The value of an attribute, or null.
    [[nodiscard]] const std::string* find(std::string_view attribute) const;
    /// The first child of that name, or null.
    [[nodiscard]] const XmlElement* child(std::string_view element) const;
};

/// Reads a whole document in UTF-8. Comments and processing instructions are skipped.
/// Document types are skipped, never expanded: one with declarations of its own is refused.
///
/// @param where  the file's name, put before every error
/// @error        anything that is not well-formed, with its line; too deep, too many elements
Result<XmlElement> parseXml(std::string_view document, std::string_view where);

}  // namespace plumb
