#pragma once

#include <cstddef>

namespace plumb {

/// Zeroed memory that is reserved in one piece and takes real pages only where it is touched.
/// It never moves, so pointers into it stay valid however far it is used.
class AddressRange {
public:
    AddressRange() = default;
    /// Reserves; `ok()` says whether the system had so many addresses to give.
    explicit AddressRange(std::size_t bytes);
    ~AddressRange();
    AddressRange(const AddressRange&) = delete;
    AddressRange& operator=(const AddressRange&) = delete;
    AddressRange(AddressRange&& other) noexcept;
    AddressRange& operator=(AddressRange&& other) noexcept;

    [[nodiscard]] bool ok() const { return start_ != nullptr; }
    /// The first byte, on a 2 MiB border where the system can do that.
    [[nodiscard]] std::byte* start() const { return start_; }

    /// Makes a part usable. Needed before its first use on systems that count reserved memory apart
    /// from used memory; elsewhere it asks for huge pages when the part is large.
    /// @return false when the memory is used up
    bool commit(std::size_t offset, std::size_t bytes);

private:
    void release();

    void* mapping_ = nullptr;
    std::size_t mapped_ = 0;  // bytes
    std::byte* start_ = nullptr;
};

/// The size of a huge page and the alignment that gets one, in bytes.
inline constexpr std::size_t kHugePage = std::size_t{2} << 20;

/// Whether untouched addresses are free. Where they are not, worlds reserve less.
#if defined(__unix__) || defined(__APPLE__) || defined(_WIN32)
inline constexpr bool kAddressesAreFree = sizeof(void*) == 8;
#else
inline constexpr bool kAddressesAreFree = false;
#endif

/// Bytes that this process may reserve: what `ulimit -v` sets; SIZE_MAX where nothing limits it.
[[nodiscard]] std::size_t addressLimit();

}  // namespace plumb
