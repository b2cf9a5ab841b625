#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/assert.hpp"

namespace plumb {

/// A list with a fixed capacity and inline storage, for components with a few values.
/// Trivially copyable if T is; unused slots stay T{} so that equal lists have equal bytes.
template <class T, std::size_t N>
struct FixedList {
    std::array<T, N> items{};
    std::uint32_t count = 0;

    static constexpr std::size_t capacity() { return N; }
    [[nodiscard]] std::size_t size() const { return count; }
    [[nodiscard]] bool empty() const { return count == 0; }
    [[nodiscard]] bool full() const { return count == N; }

    void push(const T& value) {
        PLUMB_ASSERT(!full(), "a FixedList is full; give it a larger capacity");
        items[count++] = value;
    }
    void clear() { *this = {}; }

    T& operator[](std::size_t i) { return items[i]; }
    const T& operator[](std::size_t i) const { return items[i]; }
    T* begin() { return items.data(); }
    T* end() { return items.data() + count; }
    const T* begin() const { return items.data(); }
    const T* end() const { return items.data() + count; }

    friend bool operator==(const FixedList&, const FixedList&) = default;
};

}  // namespace plumb
