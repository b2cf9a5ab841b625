#include "ecs/address_range.hpp"

#include <memory>
#include <utility>

#include "core/os.hpp"

namespace plumb {

AddressRange::AddressRange(std::size_t bytes) : mapped_{bytes + os::memoryStep()} {
    mapping_ = os::reserveMemory(mapped_);
    if (mapping_ == nullptr) return;
    void* aligned = mapping_;
    std::size_t room = mapped_;
    start_ = static_cast<std::byte*>(std::align(os::memoryStep(), bytes, aligned, room));
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
    if (mapping_ != nullptr) os::releaseMemory(mapping_, mapped_);
    mapping_ = nullptr;
}

bool AddressRange::commit(std::size_t offset, std::size_t bytes) {
    return os::commitMemory(start_ + offset, bytes);
}

}  // namespace plumb
