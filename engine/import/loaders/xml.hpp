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

/// An element of an XML file with its content; entities are replaced.
struct XmlElement {
    std::string name;
    std::vector<XmlAttribute> attributes;
    std::vector<XmlElement> children;
    std::string text;  ///< all characters between the tags, including CDATA sections
    int line = 0;      ///< line of the start tag, from 1

    /// The value of an attribute, or null.
    [[nodiscard]] const std::string* find(std::string_view attribute) const;
    /// The first child of that name, or null.
    [[nodiscard]] const XmlElement* child(std::string_view element) const;
};

/// Parses a whole document in UTF-8. Comments and processing instructions are skipped.
/// Document types are skipped, never expanded; one with declarations is refused.
///
/// @param where  the file's name, prefix of all errors
/// @error not well-formed, with the line; nested too deep, too many elements
Result<XmlElement> parseXml(std::string_view document, std::string_view where);

}  // namespace plumb
