#include "core/profile.hpp"

namespace plumb {

Profile::Zone& Profile::zoneOf(std::string_view name) {
    for (Zone& zone : zones_) {
        if (zone.name == name) return zone;
    }
    return zones_.emplace_back(Zone{name});
}

void Profile::add(std::string_view name, double seconds) {
    Zone& zone = zoneOf(name);
    zone.seconds += seconds;
    ++zone.calls;
}

void Profile::addThreads(std::string_view name, const TaskPool::Times& before, const TaskPool::Times& after) {
    Zone& zone = zoneOf(name);
    zone.rounds += after.rounds - before.rounds;
    zone.busy.resize(after.busy.size());
    for (std::size_t i = 0; i < after.busy.size(); ++i) zone.busy[i] += after.busy[i] - before.busy[i];
}

void Profile::reset() {
    for (Zone& zone : zones_) {
        zone.seconds = 0.0;
        zone.calls = 0;
        zone.rounds = 0.0;
        zone.busy.assign(zone.busy.size(), 0.0);
    }
}

}  // namespace plumb
