#pragma once

#include <string_view>
#include <vector>

#include "core/clock.hpp"

namespace plumb {

/// CPU seconds per named zone, summed until `reset`. One belongs to a loop; a null one measures nothing.
class Profile {
public:
    struct Zone {
        std::string_view name;  ///< a literal: compared by text
        double seconds = 0.0;
        int calls = 0;
    };

    void add(std::string_view name, double seconds);
    void reset();
    [[nodiscard]] const std::vector<Zone>& zones() const { return zones_; }

    bool on = true;  ///< else it measures nothing, as if there was none

private:
    std::vector<Zone> zones_;
};

/// Adds its own lifetime to a zone.
class ProfileScope {
public:
    ProfileScope(Profile* profile, std::string_view name)
        : profile_{profile != nullptr && profile->on ? profile : nullptr},
          name_{name},
          start_{profile_ != nullptr ? threadSeconds() : 0.0} {}
    ~ProfileScope() {
        if (profile_ != nullptr) profile_->add(name_, threadSeconds() - start_);
    }
    ProfileScope(const ProfileScope&) = delete;
    ProfileScope& operator=(const ProfileScope&) = delete;

private:
    Profile* profile_;
    std::string_view name_;
    double start_;
};

}  // namespace plumb
