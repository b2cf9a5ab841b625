#include "physics/broadphase/box_rows.hpp"

#include <algorithm>
#include <limits>

#include "physics/broadphase/overlap.hpp"

namespace plumb::physics {

namespace {

constexpr std::uint32_t kBehind = 8;
constexpr float kEmpty = std::numeric_limits<float>::infinity();

}  // namespace

void BoxRows::reset(std::uint32_t places) {
    for (auto& side : low) side.assign(places + kBehind, kEmpty);
    filters.resize(places);
    ids.resize(places);
    states.assign(places, kFree);
    count = free = places;
    layers = masks = 0;
}

std::uint32_t BoxRows::addPlace() {
    for (auto& side : low) side.push_back(kEmpty);
    filters.emplace_back();
    ids.emplace_back();
    states.push_back(kFree);
    ++free;
    return count++;
}

void BoxRows::dropPlace() {
    for (auto& side : low) side.pop_back();
    filters.pop_back();
    ids.pop_back();
    states.pop_back();
    --count;
    --free;
}

void BoxRows::write(const Proxies& proxies, std::uint32_t place, std::uint32_t id, const AABB& box) {
    low[0][place] = box.min.x;
    low[1][place] = box.min.y;
    low[2][place] = -box.max.x;
    low[3][place] = -box.max.y;
    filters[place] = proxies.filters[id];
    ids[place] = id;
    free -= isFree(place) ? 1u : 0u;
    states[place] = proxies.motions[id] == ProxyMotion::Awake ? kAwake : kThere;
    layers |= filters[place].layers | overruledBy(filters[place].group);
    masks |= filters[place].mask | overruledBy(filters[place].group);
}

void BoxRows::erase(std::uint32_t place) {
    for (auto& side : low) side[place] = kEmpty;
    states[place] = kFree;
    ++free;
}

}  // namespace plumb::physics
