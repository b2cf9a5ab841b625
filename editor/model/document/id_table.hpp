#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/hash.hpp"

namespace plumb::editor {

/// Hash map from ObjectIds to values, without iteration, so that no result depends on its order. It uses open
/// addressing in one array, because thousands of lookups per frame would each cost one cache miss more with
/// bucket lists.
template <class Value>
class IdTable {
public:
    [[nodiscard]] std::size_t size() const { return count_; }
    /// Returns the value of an id, null if there is none or the id is 0.
    [[nodiscard]] const Value* find(std::uint64_t id) const {
        if (count_ == 0 || id == 0) return nullptr;
        const Slot& slot = slots_[placeOf(id)];
        return slot.id == id ? &slot.value : nullptr;
    }
    /// Adds or replaces a value. @pre id != 0
    void set(std::uint64_t id, Value value) {
        if ((count_ + 1) * 4 > slots_.size() * 3) grow();
        Slot& slot = slots_[placeOf(id)];
        if (slot.id == 0) ++count_;
        slot = {id, std::move(value)};
    }
    /// Removes a value. @return true if there was one
    bool erase(std::uint64_t id) {
        if (find(id) == nullptr) return false;
        const std::size_t mask = slots_.size() - 1;
        std::size_t hole = placeOf(id);
        // Moves entries that a lookup could not reach past the hole into it; each leaves a new hole.
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
        std::uint64_t id = 0;  // 0: the slot is free
        Value value{};
    };

    [[nodiscard]] std::size_t homeOf(std::uint64_t id) const {
        return static_cast<std::size_t>(mixBits(id)) & (slots_.size() - 1);
    }
    /// Index of the slot that holds the id, or of the free slot for it.
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

    std::vector<Slot> slots_;  // size: a power of two, at least a quarter of it free
    std::size_t count_ = 0;
};

}  // namespace plumb::editor
