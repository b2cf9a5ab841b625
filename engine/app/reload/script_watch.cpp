#include "app/reload/script_watch.hpp"

#include <utility>

#include "script/script_set.hpp"

namespace plumb {

ScriptWatch::ScriptWatch(Path folder) : folder_{std::move(folder)}, stamp_{stampOfScripts(folder_)} {}

bool ScriptWatch::poll(double now) {
    if (now < next_) return false;
    next_ = now + kInterval;
    return look();
}

bool ScriptWatch::look() {
    const std::uint64_t before = std::exchange(stamp_, stampOfScripts(folder_));
    return stamp_ != before;
}

}  // namespace plumb
