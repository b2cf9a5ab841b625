#pragma once

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "physics/broadphase/broad_phase.hpp"

namespace plumb::physics {

/// A set of shape pairs: a hash set with open addressing, never iterated.
/// Source: D. Knuth, The Art of Computer Programming 3, 6.4, algorithms L and R.
class PairSet {
public:
    void clear() {
        std::fill(keys_.begin(), keys_.end(), kFree);
        size_ = 0;
    }
    [[nodiscard]] bool has(PairKey key) const { return size_ > 0 && keys_[find(key)] == key; }
    /// @return false if the set already had the key
    bool add(PairKey key) {
        if (2 * (size_ + 1) > keys_.size()) grow();
        const std::size_t i = find(key);
        if (keys_[i] == key) return false;
        keys_[i] = key;
        ++size_;
        return true;
    }
    void remove(PairKey key) {
        if (size_ == 0) return;
        std::size_t i = find(key);
        if (keys_[i] == kFree) return;
        --size_;
        // Moves a later key into the hole if the hole is in its probe sequence: searches stop at holes.
        for (std::size_t next = (i + 1) & mask_; keys_[next] != kFree; next = (next + 1) & mask_) {
            const std::size_t home = placeOf(keys_[next]);
            if (((next - home) & mask_) >= ((next - i) & mask_)) {
                keys_[i] = keys_[next];
                i = next;
            }
        }
        keys_[i] = kFree;
    }
    [[nodiscard]] std::size_t size() const { return size_; }

private:
    static constexpr std::size_t kSmallest = 64;
    static constexpr PairKey kFree = ~PairKey{0};  // not a valid key

    [[nodiscard]] std::size_t placeOf(PairKey key) const {
        return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ull) >> shift_);
    }
    /// Returns the slot of a key, or the free slot for it.
    [[nodiscard]] std::size_t find(PairKey key) const {
        std::size_t i = placeOf(key);
        while (keys_[i] != key && keys_[i] != kFree) i = (i + 1) & mask_;
        return i;
    }
    void grow() {
        const std::vector<PairKey> old =
            std::exchange(keys_, std::vector<PairKey>(std::max(kSmallest, keys_.size() * 2), kFree));
        mask_ = keys_.size() - 1;
        shift_ = 64 - std::countr_zero(keys_.size());
        size_ = 0;
        for (const PairKey key : old) {
            if (key != kFree) add(key);
        }
    }

    std::vector<PairKey> keys_;  // the size is a power of two; at most half of the slots are used
    std::size_t size_ = 0;
    std::size_t mask_ = 0;
    int shift_ = 64;
};

}  // namespace plumb::physics
