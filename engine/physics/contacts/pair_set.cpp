#include "physics/contacts/pair_set.hpp"

#include <algorithm>
#include <utility>

namespace plumb::physics {

namespace {
constexpr std::size_t kSmallest = 64;
}

void PairSet::clear() {
    std::fill(keys_.begin(), keys_.end(), kFree);
    size_ = 0;
}

void PairSet::grow() {
    const std::vector<PairKey> old =
        std::exchange(keys_, std::vector<PairKey>(std::max(kSmallest, keys_.size() * 2), kFree));
    mask_ = keys_.size() - 1;
    shift_ = 64;
    for (std::size_t places = keys_.size(); places > 1; places /= 2) --shift_;
    size_ = 0;
    for (const PairKey key : old) {
        if (key != kFree) add(key);
    }
}

bool PairSet::add(PairKey key) {
    if (2 * (size_ + 1) > keys_.size()) grow();
    std::size_t i = placeOf(key);
    for (; keys_[i] != kFree; i = (i + 1) & mask_) {
        if (keys_[i] == key) return false;
    }
    keys_[i] = key;
    ++size_;
    return true;
}

void PairSet::remove(PairKey key) {
    if (size_ == 0) return;
    std::size_t i = placeOf(key);
    for (; keys_[i] != key; i = (i + 1) & mask_) {
        if (keys_[i] == kFree) return;
    }
    --size_;
    // Moves later keys of the probe sequence into the hole, if they may be there: no search may stop at it.
    for (std::size_t next = (i + 1) & mask_; keys_[next] != kFree; next = (next + 1) & mask_) {
        const std::size_t home = placeOf(keys_[next]);
        if (((next - home) & mask_) >= ((next - i) & mask_)) {
            keys_[i] = keys_[next];
            i = next;
        }
    }
    keys_[i] = kFree;
}

}  // namespace plumb::physics
