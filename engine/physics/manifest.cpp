#include "physics/manifest.hpp"

namespace plumb::physics {

std::string_view nameOf(Effect effect) {
    constexpr std::array<std::string_view, kEffects> kNames{
        "gravity",        "rotation", "friction",  "restitution", "rolling",  "drag",
        "joints",         "motors",   "ccd",       "sleep",       "contacts", "triggers",
        "contact_events", "one_way",  "conveyor",  "kinematics",  "locks",    "area_gravity",
        "wind",           "buoyancy", "attractor", "explosion",   "springs",  "soft_bodies"};
    return kNames[static_cast<std::size_t>(effect)];
}

}  // namespace plumb::physics
