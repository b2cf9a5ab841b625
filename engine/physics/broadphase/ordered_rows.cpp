#include "physics/broadphase/ordered_rows.hpp"

namespace plumb::physics {

namespace {

constexpr std::uint64_t kTestsPerSort = 8;     // cost of sorting one box, in tests of eight boxes
constexpr std::uint32_t kSortsPerChoice = 32;  // the distribution of boxes changes slowly

}  // namespace

void OrderedRows::clearRows() {
    rows_.reset(0);
    sorted_ = sortedSize_ = 0;
    lost_ = 0;
}

void OrderedRows::collect(std::span<const std::uint32_t> arrivals) {
    order_.clear();
    for (std::uint32_t place = 0; place < rows_.count; ++place) {
        if (!rows_.isFree(place)) order_.push_back(rows_.ids[place]);
    }
    order_.insert(order_.end(), arrivals.begin(), arrivals.end());
}

void OrderedRows::noteSorted(std::uint32_t places) {
    sorted_ = places;
    sortedSize_ = static_cast<std::uint32_t>(order_.size());
    lost_ = 0;
}

bool OrderedRows::choiceIsDue() {
    const std::size_t before = chosenFor_;
    const std::size_t now = order_.size();
    const bool alike = now <= before + before / 8 && before <= now + now / 8;
    if (alike && sortsSince_++ < kSortsPerChoice) return false;
    chosenFor_ = now;
    sortsSince_ = 0;
    return true;
}

bool OrderedRows::isDue(std::size_t arrivals) const {
    const std::size_t behind = rows_.count - sorted_ + arrivals;
    return lost_ > kTestsPerSort * rows_.size() || behind > sorted_ / 2 + kFew ||
           rows_.size() < sortedSize_ / 4;
}

void OrderedRows::settle(std::size_t searches) {
    while (rows_.count > sorted_ && rows_.isFree(rows_.count - 1)) rows_.dropPlace();
    const std::uint32_t behind = rows_.count - sorted_;
    if (behind > kFew) lost_ += searches * (behind / 8);
}

}  // namespace plumb::physics
