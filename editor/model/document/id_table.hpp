#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/hash.hpp"

namespace plumb::editor {

/// Values by lasting ids. Only looked up, never iterated, so that its order decides nothing. One array with
/// open addressing: thousands of ids are looked up in every frame, and a list for each bucket costs a wait
/// for memory more.
template <class Value>
class IdTable {
public:
    [[nodiscard]] std::size_t size() const { return count_; }
    /// Null where there is none; so it is for id 0, which no entity has.
    [[nodiscard]] const Value* find(std::uint64_t id) const {
        if (count_ == 0 || id == 0) return nullptr;
        const Slot& slot = slots_[placeOf(id)];
        return slot.id == id ? &slot.value : nullptr;
    }
    /// Adds or replaces. @pre id != 0
    void set(std::uint64_t id, Value value) {
        if ((count_ + 1) * 4 > slots_.size() * 3) grow();
        Slot& slot = slots_[placeOf(id)];
        if (slot.id == 0) ++count_;
        slot = {id, std::move(value)};
    }
    /// @return whether there was one
    bool erase(std::uint64_t id) {
        if (find(id) == nullptr) return false;
        const std::size_t mask = slots_.size() - 1;
        std::size_t hole = placeOf(id);
        // What would not be found past the hole moves into it, and leaves one itself.
        for (std::size_t at = (hole + 1) & mask; slots_[at].id != 0; at = (at + 1) & mask) {
            if (((at - homeOf(slots_[at].id)) & mask) < ((at - hole) & mask)) continue;
            slots_[hole] = std::move(slots_[at]);
            hole = at;
        }
        slots_[hole] = {};
        --count_;
        return true;
    }
    void clear() {
        slots_.clear();
        count_ = 0;
    }

private:
    struct Slot {
        std::uint64_t id = 0;  // 0: free
        Value value{};
    };

    [[nodiscard]] std::size_t homeOf(std::uint64_t id) const {
        return static_cast<std::size_t>(mixBits(id)) & (slots_.size() - 1);
    }
    /// Where the id is, or where it would be.
    [[nodiscard]] std::size_t placeOf(std::uint64_t id) const {
        std::size_t at = homeOf(id);
        while (slots_[at].id != 0 && slots_[at].id != id) at = (at + 1) & (slots_.size() - 1);
        return at;
    }
    void grow() {
        std::vector<Slot> old(slots_.empty() ? 16 : slots_.size() * 2);
        std::swap(old, slots_);
        for (Slot& slot : old) {
            if (slot.id != 0) slots_[placeOf(slot.id)] = std::move(slot);
        }
    }

    std::vector<Slot> slots_;  // a power of two; at least a quarter is free
    std::size_t count_ = 0;
};

}  // namespace plumb::editor
