#pragma once

#include <vector>

#include "core/hash.hpp"
#include "physics/broadphase/broad_phase.hpp"

namespace plumb::physics {

/// The pairs that have a contact: a hash set with open addressing, never iterated.
/// Source: D. Knuth, The Art of Computer Programming 3, 6.4, algorithms L and R.
class PairSet {
public:
    void clear();
    [[nodiscard]] bool has(PairKey key) const {
        if (size_ == 0) return false;
        for (std::size_t i = placeOf(key);; i = (i + 1) & mask_) {
            if (keys_[i] == key) return true;
            if (keys_[i] == kFree) return false;
        }
    }
    /// @return false if it was there already
    bool add(PairKey key);
    void remove(PairKey key);
    [[nodiscard]] std::size_t size() const { return size_; }

private:
    static constexpr PairKey kFree = ~PairKey{0};  // not a valid key

    [[nodiscard]] std::size_t placeOf(PairKey key) const {
        return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ull) >> shift_);
    }
    void grow();

    std::vector<PairKey> keys_;  // the size is a power of two; at most half of the slots are used
    std::size_t size_ = 0;
    std::size_t mask_ = 0;
    int shift_ = 64;
};

}  // namespace plumb::physics
