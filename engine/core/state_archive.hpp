#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace plumb {

/// Writes values to bytes, or reads them from bytes: one function `archive(StateArchive&)` of a type does
/// both. For the state of a game in a file. Little-endian machines only, as everywhere in the engine. Reading
/// beyond the end, or a value of another size than was written, makes ok() false; what is read after that is
/// empty.
class StateArchive {
public:
    /// Appends to `bytes`, which must outlive this.
    static StateArchive writer(std::string& bytes) { return StateArchive{&bytes, {}}; }
    static StateArchive reader(std::string_view bytes) { return StateArchive{nullptr, bytes}; }

    [[nodiscard]] bool reading() const { return out_ == nullptr; }
    [[nodiscard]] bool ok() const { return ok_; }
    /// To be called for a value that was read and is invalid.
    void fail() { ok_ = false; }
    [[nodiscard]] std::size_t left() const { return in_.size(); }  ///< bytes that were not read yet

    void block(void* at, std::size_t bytes);
    /// Plain data, preceded by its size.
    template <class T>
    void value(T& value) {
        static_assert(std::is_trivially_copyable_v<T>, "write its members one by one");
        const auto size = static_cast<std::uint32_t>(sizeof(T));
        std::uint32_t known = size;
        block(&known, sizeof known);
        if (known != size) fail();
        block(&value, sizeof value);
    }
    void number(std::uint64_t& number) { block(&number, sizeof number); }
    void number(std::uint32_t& number) { block(&number, sizeof number); }
    void text(std::string& text);
    /// Returns the number of items that follow: `count`, or when reading the one that was written.
    /// @param leastBytes  of an item; more items than the bytes left can hold are refused
    std::size_t count(std::size_t count, std::size_t leastBytes = 1);
    /// Plain data, preceded by its size and number.
    template <class T>
    void list(std::vector<T>& list) {
        static_assert(std::is_trivially_copyable_v<T>, "write the items one by one");
        auto size = static_cast<std::uint32_t>(sizeof(T));
        block(&size, sizeof size);
        if (size != sizeof(T)) fail();
        const std::size_t items = count(list.size(), sizeof(T));
        if (reading()) list.resize(items);
        if (items > 0) block(list.data(), items * sizeof(T));
    }

private:
    StateArchive(std::string* out, std::string_view in) : out_{out}, in_{in} {}

    std::string* out_;
    std::string_view in_;  // not read yet
    bool ok_ = true;
};

}  // namespace plumb
