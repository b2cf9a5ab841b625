#include "tests/support/allocations.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

// Atomic, because audio devices allocate memory in their own threads.
std::atomic<std::size_t> made{0};
std::atomic<std::size_t> freed{0};

void* allocate(std::size_t size) noexcept {
    made.fetch_add(1, std::memory_order_relaxed);
    return std::malloc(size == 0 ? 1 : size);
}

void* allocateOrThrow(std::size_t size) {
    if (void* memory = allocate(size)) return memory;
    throw std::bad_alloc{};
}

void* allocateOrThrow(std::size_t size, std::align_val_t alignment) {
    made.fetch_add(1, std::memory_order_relaxed);
    const auto unit = static_cast<std::size_t>(alignment);
    if (void* memory = std::aligned_alloc(unit, (size + unit - 1) / unit * unit)) return memory;
    throw std::bad_alloc{};
}

void release(void* memory) noexcept {
    if (memory != nullptr) freed.fetch_add(1, std::memory_order_relaxed);
    std::free(memory);
}

}  // namespace

// Replaces all operators new and delete, except nothrow new with alignment, which is never called. Otherwise
// memory from a sanitizer's operators could be freed by these, or the reverse.
void* operator new(std::size_t size) { return allocateOrThrow(size); }
void* operator new[](std::size_t size) { return allocateOrThrow(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void* operator new(std::size_t size, std::align_val_t unit) { return allocateOrThrow(size, unit); }
void* operator new[](std::size_t size, std::align_val_t unit) { return allocateOrThrow(size, unit); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { release(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

namespace plumb::test {

Allocations allocations() { return {made.load(), freed.load()}; }

}  // namespace plumb::test
