#include <algorithm>
#include <iterator>

#include "tests/accuracy/tuning/report.hpp"

namespace plumb::tuning {

namespace {

struct Reason {
    std::string_view constant;
    std::string_view why;
};

constexpr Reason kReasons[] = {
    {"", ""},
};

}  // namespace

std::string_view reasonOf(std::string_view constant) {
    const auto found = std::find_if(std::begin(kReasons), std::end(kReasons),
                                    [&](const Reason& reason) { return reason.constant == constant; });
    return found == std::end(kReasons) ? std::string_view{} : found->why;
}

}  // namespace plumb::tuning
