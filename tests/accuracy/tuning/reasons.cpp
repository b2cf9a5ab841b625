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
    {"kMaxTurn",
     "at double, contact points are recomputed less often while a pile settles, and 8 of 150 more end "
     "with overlaps below 1 cm; but from somewhere below 0.1 on, outdated normals feed energy to boxes "
     "that rock on balls"},
    {"kMousePull",
     "no family has a mouse joint; of 600 random crates (quality 1, 2, 4) that one pulls into a floor or "
     "wall, the deepest rests 5.3 cm inside, 2.8 at half and 11.3 at double; of 300 loads up to 1,000 "
     "times as heavy it lifts 58 %, 52 at half and 66 at double"},
    {"kSweptCore",
     "with the whole outline, sweeps stop bodies that slide or graze, such as dominoes along each other "
     "and crates on lifts; and fewer hits are left to the sweep, which knows their time, so that a gas "
     "loses energy; with a quarter, more hits are left to it, and no family is worse"},
    {"kRounded",
     "below 1 the correction of overshoot() (stages/finish_bodies.cpp) is never applied to bodies that "
     "fly off fast, which then move half a substep's acceleration too far: in a rotating drum, deeper "
     "into others"},
};

}  // namespace

std::string_view reasonOf(std::string_view constant) {
    const auto found = std::find_if(std::begin(kReasons), std::end(kReasons),
                                    [&](const Reason& reason) { return reason.constant == constant; });
    return found == std::end(kReasons) ? std::string_view{} : found->why;
}

}  // namespace plumb::tuning
