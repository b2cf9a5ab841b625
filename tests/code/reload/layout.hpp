#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

#include "reflect/type_info.hpp"

namespace plumb::test {

/// A short text of plain data.
struct Word {
    std::array<char, 12> letters{};

    Word() = default;
    explicit Word(std::string_view text) {
        std::copy_n(text.begin(), std::min(text.size(), letters.size() - 1), letters.begin());
    }
    [[nodiscard]] std::string_view view() const { return letters.data(); }
};

/// A field of the component Changing, see FieldInfo.
struct LayoutField {
    Word name, was;
    FieldKind kind = FieldKind::Float;
    bool isSigned = true;
    float min = std::numeric_limits<float>::lowest();
    float max = std::numeric_limits<float>::max();
    std::uint32_t size = 0;
    std::uint32_t offset = 0;
    std::uint32_t capacity = 0;  ///< of a list of floats
    std::array<Word, 4> enumNames{};
    std::array<int, 4> enumValues{};
};

/// What a version of the module says about its component Changing: the content of the file that the
/// environment variable kLayoutVariable names.
struct Layout {
    std::uint32_t fieldCount = 0;
    std::array<LayoutField, 16> fields{};
    std::uint32_t size = 0;  ///< bytes; 0: a tag
    std::array<std::byte, 2048> defaults{};
    bool listed = true;  ///< false: the module has no such component
};

inline constexpr const char* kLayoutVariable = "PLUMB_TEST_LAYOUT";

}  // namespace plumb::test
