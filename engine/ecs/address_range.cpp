#include "ecs/address_range.hpp"

#include <cstdlib>
#include <limits>
#include <memory>
#include <utility>

#if defined(_WIN32)
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#elif defined(__unix__) || defined(__APPLE__)
#include <sys/mman.h>
#include <sys/resource.h>
#endif

namespace plumb {

AddressRange::AddressRange(std::size_t bytes) : mapped_{bytes + kHugePage} {
#if defined(_WIN32)
    mapping_ = VirtualAlloc(nullptr, mapped_, MEM_RESERVE, PAGE_READWRITE);
#elif defined(__unix__) || defined(__APPLE__)
    int flags = MAP_PRIVATE | MAP_ANONYMOUS;
#if defined(MAP_NORESERVE)
    flags |= MAP_NORESERVE;
#endif
    mapping_ = mmap(nullptr, mapped_, PROT_READ | PROT_WRITE, flags, -1, 0);
    if (mapping_ == MAP_FAILED) mapping_ = nullptr;
#else
    mapping_ = std::calloc(mapped_, 1);
#endif
    if (mapping_ == nullptr) return;
    void* aligned = mapping_;
    std::size_t room = mapped_;
    start_ = static_cast<std::byte*>(std::align(kHugePage, bytes, aligned, room));
}

AddressRange::~AddressRange() { release(); }

AddressRange::AddressRange(AddressRange&& other) noexcept
    : mapping_{std::exchange(other.mapping_, nullptr)},
      mapped_{other.mapped_},
      start_{std::exchange(other.start_, nullptr)} {}

AddressRange& AddressRange::operator=(AddressRange&& other) noexcept {
    if (this == &other) return *this;
    release();
    mapping_ = std::exchange(other.mapping_, nullptr);
    mapped_ = other.mapped_;
    start_ = std::exchange(other.start_, nullptr);
    return *this;
}

void AddressRange::release() {
    if (mapping_ == nullptr) return;
#if defined(_WIN32)
    VirtualFree(mapping_, 0, MEM_RELEASE);
#elif defined(__unix__) || defined(__APPLE__)
    munmap(mapping_, mapped_);
#else
    std::free(mapping_);
#endif
    mapping_ = nullptr;
}

bool AddressRange::commit(std::size_t offset, std::size_t bytes) {
#if defined(_WIN32)
    return VirtualAlloc(start_ + offset, bytes, MEM_COMMIT, PAGE_READWRITE) != nullptr;
#elif defined(MADV_HUGEPAGE)
    // Small parts use small pages, so that a small world takes little memory.
    if (bytes >= kHugePage) {
        const std::size_t first = (offset + kHugePage - 1) / kHugePage * kHugePage;
        const std::size_t end = (offset + bytes) / kHugePage * kHugePage;
        if (first < end) madvise(start_ + first, end - first, MADV_HUGEPAGE);
    }
    return true;
#else
    static_cast<void>(offset);
    static_cast<void>(bytes);
    return true;
#endif
}

std::size_t addressLimit() {
    constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
#if defined(__unix__) || defined(__APPLE__)
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kNone;
    return static_cast<std::size_t>(limit.rlim_cur);
#else
    return kNone;
#endif
}

}  // namespace plumb
