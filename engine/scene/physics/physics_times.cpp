#include "scene/physics/physics_times.hpp"

#include <algorithm>

#include "physics/simulation.hpp"

namespace plumb {
namespace {

constexpr int kStepsOfRows = 30;  // steps to average over, as faster changing numbers are not readable

}  // namespace

void PhysicsTimes::watch(World& world, bool on) {
    const bool same = on == watching_ && (!on || world.service<PhysicsTimes>() == this);
    watching_ = on;
    if (same || !on) return;
    world.provide(*this);
    steps_ = 0;
    profile_.reset();
    rows_.clear();
    rows_.reserve(physics::stages().size() + 1);
}

void PhysicsTimes::endStep() {
    if (!watching_ || ++steps_ < kStepsOfRows) return;
    readRows();
    profile_.reset();
    steps_ = 0;
}

void PhysicsTimes::take(const Profile& tick) {
    if (!watching_) return;
    for (const Profile::Zone& zone : tick.zones()) {
        if (zone.calls > 0) profile_.add(zone.name, zone.seconds);
    }
}

void PhysicsTimes::readRows() {
    rows_.clear();
    const auto add = [&](std::string_view name) {
        for (const Profile::Zone& zone : profile_.zones()) {
            if (zone.name == name && zone.calls > 0)
                rows_.push_back({name, static_cast<float>(1000.0 * zone.seconds / steps_)});
        }
    };
    add(kPhysicsSync);
    for (const physics::StageInfo& stage : physics::stages()) add(stage.name);
}

}  // namespace plumb
