#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plumb::test {

/// A documented declaration of a header.
struct Declaration {
    std::string name;       ///< without scope and parameters
    std::string signature;  ///< in one line, without body and attributes
    std::string doc;        ///< the `///` comment above or the `///<` comment behind, in one line
    bool isType = false;    ///< a class, struct or enum
    bool isFunction = false;
    bool continues = false;            ///< without a comment, directly below one that has a comment
    std::vector<Declaration> members;  ///< public ones of a class, values of an enum
};

/// Reads the declarations of a header that is formatted as those of the engine. No C++ parser: it knows
/// comments, brackets, and the words that begin a type.
std::vector<Declaration> readHeader(std::string_view text);

}  // namespace plumb::test
