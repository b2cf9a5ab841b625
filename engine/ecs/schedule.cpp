#include "ecs/schedule.hpp"

#include <algorithm>

#include "core/crash.hpp"
#include "core/profile.hpp"
#include "core/reports.hpp"
#include "ecs/system_gates.hpp"
#include "ecs/world.hpp"

namespace plumb {

Schedule::Box* Schedule::find(TypeKey key) const {
    for (const std::unique_ptr<Box>& box : boxes_) {
        if (box->key == key) return box.get();
    }
    return nullptr;
}

void Schedule::insert(std::unique_ptr<Box> box) {
    box->added = added_++;
    boxes_.push_back(std::move(box));
    sort();
}

void Schedule::remove(TypeKey key) {
    std::erase_if(boxes_, [key](const std::unique_ptr<Box>& box) { return box->key == key; });
}

void Schedule::setOrder(std::span<const std::string_view> names) {
    order_.assign(names.begin(), names.end());
    sort();
}

void Schedule::sort() {
    const auto place = [this](const Box& box) {
        return std::find(order_.begin(), order_.end(), box.name) - order_.begin();
    };
    std::sort(boxes_.begin(), boxes_.end(), [&](const auto& a, const auto& b) {
        const auto placeA = place(*a);
        const auto placeB = place(*b);
        return placeA != placeB ? placeA < placeB : a->added < b->added;
    });
}

std::vector<std::string_view> Schedule::names() const {
    std::vector<std::string_view> names;
    for (const std::unique_ptr<Box>& box : boxes_) names.push_back(box->name);
    return names;
}

void Schedule::run(World& world, float dt, Profile* profile) const {
    const Reporting reporting{world.reports()};
    world.reportMissed();  // of the code that ran before the systems
    SystemGates* const gates = world.service<SystemGates>();
    // By index, because a system may add another one, which then runs if it comes later in the order.
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        if (gates != nullptr && !gates->shouldRun(world, i, boxes_[i]->key)) continue;
        const Running running{boxes_[i]->name};
        const ProfileScope scope{profile, boxes_[i]->name};
        boxes_[i]->update(world, dt);
        world.reportMissed();
        world.commands().flush(world);
    }
}

}  // namespace plumb
