#include "core/profile.hpp"

namespace plumb {

void Profile::add(std::string_view name, double seconds) {
    for (Zone& zone : zones_) {
        if (zone.name == name) {
            zone.seconds += seconds;
            ++zone.calls;
            return;
        }
    }
    zones_.push_back({name, seconds, 1});
}

void Profile::reset() {
    for (Zone& zone : zones_) {
        zone.seconds = 0.0;
        zone.calls = 0;
    }
}

}  // namespace plumb
