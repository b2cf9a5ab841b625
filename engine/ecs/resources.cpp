#include "ecs/resources.hpp"

#include <algorithm>

namespace plumb {

Resources::Box* Resources::find(TypeKey key) const {
    for (const std::unique_ptr<Box>& box : boxes_) {
        if (box->key == key) return box.get();
    }
    return nullptr;
}

Resources::Box& Resources::insert(std::unique_ptr<Box> box) {
    const auto at =
        std::upper_bound(boxes_.begin(), boxes_.end(), box->nameHash,
                         [](std::uint64_t hash, const auto& known) { return hash < known->nameHash; });
    return **boxes_.insert(at, std::move(box));
}

void Resources::assign(const Resources& other) {
    for (const std::unique_ptr<Box>& box : boxes_) {
        const Box* from = other.find(box->key);
        if (from != nullptr && from->present) continue;
        if (box->present) box->reset();
        box->present = false;
    }
    for (const std::unique_ptr<Box>& from : other.boxes_) {
        if (!from->present) continue;
        if (Box* to = find(from->key)) {
            to->assign(*from);
            to->present = true;
        } else {
            insert(from->copy());
        }
    }
}

void Resources::dropReloadable() {
    std::erase_if(boxes_, [](const std::unique_ptr<Box>& box) { return isReloadable(box->key); });
}

void Resources::addTo(Hasher& hasher) const {
    for (const std::unique_ptr<Box>& box : boxes_) {
        if (box->present) box->addTo(hasher);
    }
}

}  // namespace plumb
