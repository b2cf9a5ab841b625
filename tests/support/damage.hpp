#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/random.hpp"

namespace plumb::test {

/// Returns the bytes with some of them replaced by random ones, as a defective disk does.
/// @param maximum  maximum number of replaced bytes; the minimum is one
inline std::string withWrongBytes(std::string bytes, Random& random, std::uint32_t maximum = 3) {
    if (bytes.empty()) return bytes;
    for (std::uint32_t n = 1 + random.below(maximum); n > 0; --n) {
        bytes[random.below(static_cast<std::uint32_t>(bytes.size()))] = static_cast<char>(random.below(256));
    }
    return bytes;
}

/// Damages a JSON file as disks, editors and users do: changes bytes, and removes, repeats or replaces parts.
inline std::string damaged(std::string bytes, Random& random) {
    static constexpr std::array<std::string_view, 21> kTokens{"{",
                                                              "}",
                                                              "[",
                                                              "]",
                                                              ",",
                                                              "\"",
                                                              ":",
                                                              "null",
                                                              "-1",
                                                              "1e999",
                                                              "NaN",
                                                              "true",
                                                              "\"\"",
                                                              "{}",
                                                              "[]",
                                                              "\\",
                                                              "\xff",
                                                              "99999999999999999999",
                                                              "\"id\": \"a1\",",
                                                              "\"parent\": \"a1\",",
                                                              "\"prefab\": \"x\","};
    const auto token = [&random] { return kTokens[random.below(kTokens.size())]; };
    for (std::uint32_t i = 1 + random.below(4); i > 0 && !bytes.empty(); --i) {
        const std::size_t at = random.below(static_cast<std::uint32_t>(bytes.size()));
        const std::size_t length = std::min<std::size_t>(1 + random.below(40), bytes.size() - at);
        switch (random.below(6)) {
            case 0: bytes[at] = static_cast<char>(random.next()); break;
            case 1: bytes.erase(at, length); break;
            case 2: bytes.insert(at, bytes.substr(at, length)); break;
            case 3: bytes.insert(at, token()); break;
            case 4: bytes.replace(at, std::min<std::size_t>(length, 4), token()); break;
            default:
                if (random.below(20) == 0) bytes.resize(at);
                break;
        }
    }
    return bytes;
}

}  // namespace plumb::test
