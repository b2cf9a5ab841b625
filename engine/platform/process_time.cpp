#include "platform/process_time.hpp"

#include "core/clock.hpp"
#include "core/os.hpp"

namespace plumb {

double processSeconds() {
    static const double begin = wallSeconds() - os::processAge();
    return wallSeconds() - begin;
}

}  // namespace plumb
