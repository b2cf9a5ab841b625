#include "tests/accuracy/stability/maps.hpp"

#include <array>
#include <cmath>

#include "core/text.hpp"

namespace plumb::stability {

namespace {

constexpr double kQualities[] = {0, 1, 2, 3, 4, 5, -1};
constexpr std::uint32_t kUsualRows = 1u << 2 | 1u << 6;  // bit set: rows of quality 2 and automatic quality

constexpr double kRatios[] = {1, 10, 100, 1e3, 1e4, 1e5, 1e6};
constexpr double kHeights[] = {5, 10, 20, 50, 100};
constexpr double kChains[] = {5, 10, 20, 50, 100, 200};
constexpr double kSteps[] = {1.0 / 240, 1.0 / 120, 1.0 / 60, 1.0 / 30, 1.0 / 15};
constexpr double kGravities[] = {0.1, 0.3, 1, 3, 10, 30, 100};
constexpr double kSizes[] = {1e-3, 1e-2, 0.1, 1, 10, 100, 1e3};
constexpr double kScales[] = {1e-3, 1e-2, 0.03, 0.1, 0.3, 1, 10, 100, 1e3};
constexpr double kDistances[] = {0, 1e3, 1e4, 1e5, 1e6};
constexpr double kThin[] = {0.1, 0.03, 0.01, 3e-3, 1e-3, 3e-4};
constexpr double kLoads[] = {1, 10, 100, 1e3, 1e4};
constexpr double kTorques[] = {1, 10, 100, 1e3, 1e4, 1e6};
constexpr double kBounces[] = {0, 0.25, 0.5, 0.75, 0.9, 1};
constexpr double kFrictions[] = {0, 0.1, 0.2, 0.5, 1, 2, 10};
constexpr double kSpins[] = {1, 10, 30, 100, 300, 1e3};
constexpr double kCrowds[] = {2, 3, 5, 10, 20, 50};
constexpr double kLeft[] = {0.9, 0.5, 0.2, 0.05, 0.0};
constexpr double kPresses[] = {0.1, 1, 10, 100};

constexpr Axis kByQuality{"quality", Label::Quality, kQualities};
constexpr Axis kByRatio{"mass of the top box to one below", Label::Plain, kRatios};
constexpr Axis kByBall{"mass of the ball to a link", Label::Plain, kRatios};
constexpr Axis kByStep{"step", Label::Step, kSteps};
constexpr Axis kByHeight{"boxes", Label::Plain, kHeights};
constexpr Axis kByLinks{"links", Label::Plain, kChains};

constexpr Map kMaps[] = {
    {"mass_ratio", "Mass ratio", "A heavy box on two unit boxes, 10 s. Exact: nothing moves.", kByQuality,
     kByRatio, 0, heavyOnTop, kUsualRows},
    {"mass_ratio_height", "Mass ratio on a stack",
     "A heavy box on top of a stack of unit boxes, automatic quality, 10 s. Exact: nothing moves.", kByHeight,
     kByRatio, 0, heavyOnStack, 1u << 1},
    {"stack", "Stack", "A stack of unit boxes, 10 s. Exact: nothing moves.", kByQuality, kByHeight, 0,
     stackOf, kUsualRows},
    {"stack_step", "Step", "A stack of ten unit boxes, 10 s. Exact: nothing moves.", kByQuality, kByStep, 0,
     stackAtStep, kUsualRows},
    {"stack_height_step", "Step and height",
     "A stack of unit boxes, automatic quality, 10 s. Exact: nothing moves.", kByStep, kByHeight, 0,
     tallAtStep, 1u << 2},
    {"gravity",
     "Gravity",
     "A stack of ten unit boxes, 10 s. Exact: nothing moves.",
     kByQuality,
     {"gravity, times 10 m/s2", Label::Times, kGravities},
     2,
     stackInGravity,
     kUsualRows},
    {"size_ratio",
     "Size ratio",
     "A box on a unit box (larger ones on two, under their ends) of equal density, so 1000 times the "
     "size is a million times the mass; 10 s. Exact: nothing moves.",
     kByQuality,
     {"size of the upper box, m", Label::Plain, kSizes},
     3,
     sizesAtDensity,
     kUsualRows},
    {"size_ratio_equal",
     "Size ratio, equal masses",
     "A box on a unit box (larger ones on two, under their ends), each of 1 kg, 10 s. Exact: nothing "
     "moves.",
     kByQuality,
     {"size of the upper box, m", Label::Plain, kSizes},
     3,
     sizesAtMass,
     kUsualRows},
    {"scale",
     "Scale of the world",
     "A stack of five boxes, all of the same size, 10 s. Exact: nothing moves.",
     kByQuality,
     {"size of a box, m", Label::Plain, kScales},
     5,
     stackAtScale,
     kUsualRows},
    {"far",
     "Far from the origin",
     "A stack of ten unit boxes, 10 s. Exact: nothing moves.",
     kByQuality,
     {"distance, m", Label::Plain, kDistances},
     0,
     stackFarAway,
     kUsualRows},
    {"plates",
     "Thin plates",
     "A stack of five plates of 1 m, 10 s. Exact: nothing moves.",
     kByQuality,
     {"thickness, m", Label::Plain, kThin},
     0,
     thinPlates,
     kUsualRows},
    {"slivers",
     "Sliver polygons",
     "Eight triangles of 1 m, dropped on a floor at all angles, 10 s. Exact: they rest and overlap nothing.",
     kByQuality,
     {"thickness, m", Label::Plain, kThin},
     0,
     slivers,
     kUsualRows},
    {"chain", "Chain", "Links of 0.5 m that hang from a pin, 10 s. Exact: nothing moves.", kByQuality,
     kByLinks, 0, chainOf, kUsualRows},
    {"chain_ball", "Ball on a chain",
     "Twenty links of 0.5 m with a ball at their end, 10 s. Exact: nothing moves.", kByQuality, kByBall, 0,
     ballOnChain, kUsualRows},
    {"chain_length_ball", "Ball and length of a chain",
     "Links of 0.5 m with a ball at their end, automatic quality, 10 s. Exact: nothing moves.", kByLinks,
     kByBall, 0, ballOnChainOf, 1u << 5},
    {"chain_step", "Chain and step",
     "Twenty links with a ball of 100 times their mass, 10 s. Exact: nothing moves.", kByQuality, kByStep, 0,
     chainAtStep, kUsualRows},
    {"chain_swing", "Swinging chain",
     "Links of 0.5 m, released horizontally, 10 s. Exact: joints are closed; energy does not grow.",
     kByQuality, kByLinks, 0, swingingChain, kUsualRows},
    {"bridge",
     "Loaded bridge",
     "Twenty planks between two posts and a crate that falls on their middle, 10 s. Exact: joints are "
     "closed, "
     "nothing overlaps and the crate did not fall through.",
     kByQuality,
     {"mass of the crate to a plank", Label::Plain, kLoads},
     0,
     loadedBridge,
     kUsualRows},
    {"pendulum", "Pendulum and step",
     "A rigid arm of 1 m, released horizontally. Exact: after 10 s it returns to the same height.",
     kByQuality, kByStep, 0, pendulumAtStep, kUsualRows},
    {"motor_limit",
     "Motor against a limit",
     "An arm of 1 m (0.1 kg) that a motor drives into its limit for 5 s. Exact: it stays at the limit, its "
     "joint "
     "closed.",
     kByQuality,
     {"torque, N m", Label::Plain, kTorques},
     0,
     motorAtLimit,
     kUsualRows},
    {"restitution",
     "Restitution",
     "A ball falls 2 m on a floor. Exact: it rises to e2 of the height, three times; energy does not grow in "
     "10 s.",
     kByQuality,
     {"restitution e", Label::Plain, kBounces},
     0,
     bounce,
     kUsualRows},
    {"restitution_step",
     "Restitution and step",
     "A ball falls 2 m on a floor at quality 2. Exact: it rises to e2 of the height, three times; energy "
     "does not grow in 10 s.",
     kByStep,
     {"restitution e", Label::Plain, kBounces},
     0,
     bounceAtStep,
     0b11111},
    {"friction",
     "Friction",
     "A crate on a slope of 0.5 rad for 3 s. Exact: it slides by the formula, or stays where the friction is "
     "above tan 0.5 = 0.546.",
     kByQuality,
     {"friction", Label::Plain, kFrictions},
     0,
     slope,
     kUsualRows},
    {"spin",
     "Spin on a floor",
     "A plank of 2 m by 0.2 m that spins and falls on a floor, 10 s. Exact: energy does not grow, nothing "
     "overlaps "
     "at the end.",
     kByQuality,
     {"spin, rad/s", Label::Plain, kSpins},
     0,
     spinOnFloor,
     kUsualRows},
    {"spin_crates",
     "Spin among crates",
     "The plank spins into 16 crates in a pit, 10 s. Exact: energy does not grow, nothing overlaps at the "
     "end.",
     kByQuality,
     {"spin, rad/s", Label::Plain, kSpins},
     0,
     spinAmongCrates,
     kUsualRows},
    {"overlap",
     "Full overlap at spawn",
     "Unit boxes created in the same place, 10 s. Exact: they separate gently and rest. Energy is "
     "measured from the time when they are separated; before, none may be faster than 4 m/s plus a "
     "fall from their height.",
     kByQuality,
     {"boxes in one place", Label::Plain, kCrowds},
     0,
     spawnedInOnePlace,
     kUsualRows},
    {"crusher",
     "Kinematic crusher",
     "A press moves down on three crates at 0.5 m/s, leaves too little room for them, waits for 1 s "
     "and moves up. Exact: 5 s later they rest without overlap.",
     kByQuality,
     {"room left, of their height", Label::Percent, kLeft},
     0,
     crushed,
     kUsualRows},
    {"crusher_speed",
     "Fast crusher",
     "A press moves down on three crates to half their height, waits for 1 s and moves up. Exact: 5 s "
     "later they rest without overlap.",
     kByQuality,
     {"speed of the press, m/s", Label::Plain, kPresses},
     0,
     crushedFast,
     kUsualRows},
};

/// Formats a number: "0.001", "10", "10⁴".
std::string numberText(double value) {
    if (value > 0.0 && value < 1.0e-3) return fixedText(value, 4);
    if (value < 1.0e4) return shortestText(value);
    constexpr std::array<const char*, 10> kPowers{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    const auto power = static_cast<std::size_t>(std::lround(std::log10(value)));
    return format("10{}", kPowers[power % kPowers.size()]);
}

}  // namespace

std::string labelOf(Label label, double value) {
    switch (label) {
        case Label::Quality: return value < 0.0 ? "auto" : fixedText(value, 0);
        case Label::Step: return format("1/{} s", fixedText(1.0 / value, 0));
        case Label::Times: return format("×{}", numberText(value));
        case Label::Percent: return format("{} %", fixedText(100.0 * value, 0));
        case Label::Plain: break;
    }
    return numberText(value);
}

std::span<const Map> allMaps() { return kMaps; }

}  // namespace plumb::stability
