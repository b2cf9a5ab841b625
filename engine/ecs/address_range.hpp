#pragma once

#include <cstddef>

namespace plumb {

/// A reserved range of zeroed memory whose pages are allocated when they are
/// first used. It never moves, so pointers into it stay valid as it grows.
class AddressRange {
public:
    AddressRange() = default;
    /// Reserves the range; `ok()` is false if the system has not enough address space.
    explicit AddressRange(std::size_t bytes);
    ~AddressRange();
    AddressRange(const AddressRange&) = delete;
    AddressRange& operator=(const AddressRange&) = delete;
    AddressRange(AddressRange&& other) noexcept;
    AddressRange& operator=(AddressRange&& other) noexcept;

    [[nodiscard]] bool ok() const { return start_ != nullptr; }
    /// The first byte, aligned to os::memoryStep().
    [[nodiscard]] std::byte* start() const { return start_; }

    /// Makes a part usable. Required before its first use on systems that separate
    /// reserving from committing; elsewhere it requests huge pages if the part is large.
    /// @return false if there is not enough memory
    bool commit(std::size_t offset, std::size_t bytes);

private:
    void release();

    void* mapping_ = nullptr;
    std::size_t mapped_ = 0;  // bytes
    std::byte* start_ = nullptr;
};

}  // namespace plumb
