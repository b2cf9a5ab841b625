#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace plumb {

/// A wrong use of a FixedList.
enum class ListFault : std::uint8_t { PushOnFull, IndexPastEnd };

/// Reports a wrong use of a FixedList: an assertion fails, or without assertions an error is logged, once per
/// kind, as it may occur in every tick.
void reportListFault(ListFault fault, std::size_t index, std::size_t size, std::size_t capacity);

/// A list with a fixed capacity and inline storage, for components with a few values.
/// Trivially copyable if T is; unused slots stay T{} so that equal lists have equal bytes.
/// No function reads or writes beyond the capacity, whatever `count` is set to.
template <class T, std::size_t N>
struct FixedList {
    std::array<T, N> items{};
    std::uint32_t count = 0;

    static constexpr std::size_t capacity() { return N; }
    [[nodiscard]] std::size_t size() const { return count < N ? count : N; }
    [[nodiscard]] bool empty() const { return count == 0; }
    [[nodiscard]] bool full() const { return count >= N; }

    /// Appends a value. If the list is full it stays as it is, and that is reported as an error: check
    /// full() first where it may happen. @return false if it was full
    bool push(const T& value) {
        if (full()) {
            reportListFault(ListFault::PushOnFull, N, N, N);
            return false;
        }
        items[count++] = value;
        return true;
    }
    /// Removes an item; those after it move up. @return false, without a change, if there is none at `i`
    bool erase(std::size_t i) {
        if (i >= size()) return false;
        const std::size_t last = size() - 1;
        for (; i < last; ++i) items[i] = items[i + 1];
        items[last] = T{};
        count = static_cast<std::uint32_t>(last);
        return true;
    }
    void clear() { *this = {}; }

    /// Item `i`. Where there is none that is reported as an error, and the result is an object that belongs
    /// to no list. @pre i < size()
    T& operator[](std::size_t i) {
        if (i < size()) [[likely]]
            return items[i];
        return outside(i);
    }
    const T& operator[](std::size_t i) const { return const_cast<FixedList&>(*this)[i]; }
    T* begin() { return items.data(); }
    T* end() { return items.data() + size(); }
    const T* begin() const { return items.data(); }
    const T* end() const { return items.data() + size(); }

    friend bool operator==(const FixedList&, const FixedList&) = default;

private:
    T& outside(std::size_t i) const {
        reportListFault(ListFault::IndexPastEnd, i, size(), N);
        thread_local T none;
        return none = T{};
    }
};

}  // namespace plumb
