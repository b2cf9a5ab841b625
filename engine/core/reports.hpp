#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace plumb {

/// The errors that a world has reported, so that those which every tick repeats are logged once. Not part of
/// the simulation.
class Reports {
public:
    /// True at the first call with these arguments since forget().
    /// @param which  distinguishes errors of the same text, e.g. the index of an entity
    bool isFirst(std::string_view where, std::string_view what, std::uint64_t which = 0);
    /// Lets all errors be reported again, as when a scene begins or other code was loaded.
    void forget() { reported_.clear(); }
    [[nodiscard]] std::size_t count() const { return reported_.size(); }

    /// Those of the world that this thread updates; null: none. For errors that belong to no world.
    static constinit thread_local Reports* current;

private:
    std::vector<std::uint64_t> reported_;  // hashes of the arguments, sorted
};

/// Makes reports those of this thread, as long as it lives.
class Reporting {
public:
    explicit Reporting(Reports& reports) : before_{Reports::current} { Reports::current = &reports; }
    ~Reporting() { Reports::current = before_; }
    Reporting(const Reporting&) = delete;
    Reporting& operator=(const Reporting&) = delete;

private:
    Reports* before_;
};

}  // namespace plumb
