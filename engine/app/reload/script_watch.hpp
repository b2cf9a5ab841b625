#pragma once

#include "core/file.hpp"

namespace plumb {

class ScriptSet;

/// Notices script files of a project that were changed, added or removed since they were read.
class ScriptWatch {
public:
    static constexpr double kInterval = 0.05;  ///< s between two looks

    /// @param scripts  must outlive this
    /// @param folder   of the project
    ScriptWatch(const ScriptSet& scripts, Path folder);

    /// Returns true if the scripts are to be read again. Looks every kInterval.
    /// @param now  s, of any clock
    bool poll(double now);
    /// As poll(), without waiting for the next look.
    [[nodiscard]] bool look() const;

private:
    const ScriptSet& scripts_;
    Path folder_;
    double next_ = 0.0;  // s
};

}  // namespace plumb
