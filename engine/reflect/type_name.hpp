#pragma once

#include <cstddef>
#include <string_view>

namespace plumb {

/// A type's name as the compiler writes it, with its namespaces.
template <class T>
constexpr std::string_view compilerTypeName() {
#if defined(_MSC_VER) && !defined(__clang__)
    constexpr std::string_view text = __FUNCSIG__;
    constexpr std::size_t open = text.find("compilerTypeName<") + 17;
    constexpr std::size_t start = text.find(' ', open) < text.rfind(">(") ? text.find(' ', open) + 1 : open;
    constexpr std::string_view name = text.substr(start, text.rfind(">(") - start);
    return name.substr(0, 7) == "plumb::" ? name.substr(7) : name;
#else
    constexpr std::string_view text = __PRETTY_FUNCTION__;
    constexpr std::size_t start = text.find("T = ") + 4;
    constexpr std::size_t end = text.find(';', start) < text.size() ? text.find(';', start) : text.rfind(']');
    // Compilers differ in whether they print the namespace of this function, so it is
    // always removed: the name is hashed, and the hash must be the same everywhere.
    constexpr std::string_view inside = "plumb::";
    constexpr std::string_view name = text.substr(start, end - start);
    return name.substr(0, inside.size()) == inside ? name.substr(inside.size()) : name;
#endif
}

/// A type's name without its namespaces: "GravitySystem".
template <class T>
constexpr std::string_view shortTypeName() {
    constexpr std::string_view name = compilerTypeName<T>();
    constexpr std::size_t colon = name.substr(0, name.find('<')).rfind(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

/// True if a name of compilerTypeName() is that of a type in an unnamed namespace: two files may have such
/// types of the same name.
constexpr bool isInUnnamedNamespace(std::string_view name) {
    for (const std::string_view mark : {"<unnamed>", "{anonymous}", "(anonymous", "`anonymous"}) {
        if (name.find(mark) != std::string_view::npos) return true;
    }
    return false;
}

}  // namespace plumb
