#pragma once

#include <string_view>
#include <vector>

#include "core/clock.hpp"
#include "core/task_pool.hpp"

namespace plumb {

/// CPU seconds per named zone, summed until reset(). A null Profile pointer disables measuring.
class Profile {
public:
    struct Zone {
        std::string_view name;  ///< must be a literal; zones with equal texts are the same
        double seconds = 0.0;
        int calls = 0;
        double rounds = 0.0;       ///< s: wall time of the zone in which threads shared its work
        std::vector<double> busy;  ///< s: the part of `rounds` in which each thread worked, the caller first
    };

    void add(std::string_view name, double seconds);
    /// Adds the thread times of a pool during a zone: the difference between `after` and `before`.
    void addThreads(std::string_view name, const TaskPool::Times& before, const TaskPool::Times& after);
    void reset();
    [[nodiscard]] const std::vector<Zone>& zones() const { return zones_; }

    bool on = true;  ///< false disables measuring

private:
    Zone& zoneOf(std::string_view name);

    std::vector<Zone> zones_;
};

/// Adds the time of its own lifetime to a zone.
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
