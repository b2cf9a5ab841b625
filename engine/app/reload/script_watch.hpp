#pragma once

#include <cstdint>

#include "core/file.hpp"

namespace plumb {

/// Notices changed, new and removed script files of a project.
class ScriptWatch {
public:
    static constexpr double kInterval = 0.05;  ///< s between two looks

    /// @param folder  of the project; its scripts were read already
    explicit ScriptWatch(Path folder);

    /// Returns true once for each change. Looks every kInterval.
    /// @param now  s, of any clock
    bool poll(double now);
    /// As poll(), without waiting for the next look.
    bool look();

private:
    Path folder_;
    std::uint64_t stamp_ = 0;  // of the script files that were read
    double next_ = 0.0;        // s
};

}  // namespace plumb
