#include "core/reports.hpp"

#include <algorithm>

#include "core/hash.hpp"

namespace plumb {

constinit thread_local Reports* Reports::current;

bool Reports::isFirst(std::string_view where, std::string_view what, std::uint64_t which) {
    Hasher hasher;
    hasher.add(where);
    hasher.add(what);
    hasher.add(which);
    const std::uint64_t report = hasher.value();
    const auto at = std::lower_bound(reported_.begin(), reported_.end(), report);
    if (at != reported_.end() && *at == report) return false;
    reported_.insert(at, report);
    return true;
}

}  // namespace plumb
