#include "app/reload/script_watch.hpp"

#include <utility>

#include "script/script_set.hpp"

namespace plumb {

ScriptWatch::ScriptWatch(const ScriptSet& scripts, Path folder)
    : scripts_{scripts}, folder_{std::move(folder)} {}

bool ScriptWatch::poll(double now) {
    if (now < next_) return false;
    next_ = now + kInterval;
    return look();
}

bool ScriptWatch::look() const { return stampOfScripts(folder_) != scripts_.stamp(); }

}  // namespace plumb
