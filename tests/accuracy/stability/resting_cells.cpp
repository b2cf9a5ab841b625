#include <algorithm>
#include <array>
#include <cmath>

#include "tests/accuracy/stability/lab.hpp"
#include "tests/accuracy/stability/maps.hpp"

// Scenes of the stability map with bodies that should stay in place; their displacement is the error.

namespace plumb::stability {

namespace {

constexpr double kSeconds = 10.0;
constexpr int kTen = 10;  // default number of boxes

Vec2 at(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

Outline square(double side) { return scenes::box(at(0.5 * side, 0.5 * side)); }

/// Simulates a stack of equal boxes; the top one has `ratio` times the mass of the others.
Figures stack(const Terms& terms, int count, double ratio = 1.0, double size = 1.0) {
    Lab lab{terms, {.size = size, .extent = count * size}};
    lab.floor({}, 200.0 * size);
    BodyHandle top;
    for (int i = 0; i < count; ++i) top = lab.add(square(size), at(0.0, (i + 0.5) * size));
    if (ratio != 1.0) lab.setMass(top, ratio * size * size);
    lab.run(kSeconds);
    return lab.figures();
}

/// Simulates a box of a size on a box of 1 m or, if it is larger, on two boxes under its ends.
Figures sizes(double quality, double size, bool equalMass) {
    const double smallest = std::min(size, 1.0);
    Lab lab{{.quality = quality}, {.size = smallest, .extent = 1.0 + size}};
    lab.floor({}, 2000.0);
    for (const double side : {-1.0, 1.0}) {
        if (size <= 1.0 && side > 0.0) continue;
        lab.add(square(1.0), at(size <= 1.0 ? 0.0 : side * std::max(0.4 * size, 0.6), 0.5));
    }
    const BodyHandle other = lab.add(square(size), at(0.0, 1.0 + 0.5 * size));
    if (equalMass) lab.setMass(other, 1.0);
    lab.run(kSeconds);
    return lab.figures();
}

}  // namespace

Figures heavyOnTop(double quality, double ratio) { return stack({.quality = quality}, 3, ratio); }

Figures heavyOnStack(double count, double ratio) {
    return stack({.quality = -1.0}, static_cast<int>(count), ratio);
}

Figures stackOf(double quality, double count) { return stack({.quality = quality}, static_cast<int>(count)); }

Figures stackAtStep(double quality, double step) { return stack({.quality = quality, .step = step}, kTen); }

Figures tallAtStep(double step, double count) {
    return stack({.quality = -1.0, .step = step}, static_cast<int>(count));
}

Figures stackInGravity(double quality, double times) {
    return stack({.quality = quality, .gravity = times * kGravity}, kTen);
}

Figures sizesAtDensity(double quality, double size) { return sizes(quality, size, false); }
Figures sizesAtMass(double quality, double size) { return sizes(quality, size, true); }

Figures stackAtScale(double quality, double size) { return stack({.quality = quality}, 5, 1.0, size); }

Figures stackFarAway(double quality, double distance) {
    return stack({.quality = quality, .origin = distance}, kTen);
}

Figures thinPlates(double quality, double thickness) {
    constexpr int kPlates = 5;
    Lab lab{{.quality = quality}, {.size = thickness, .extent = kPlates * thickness}};
    lab.floor();
    for (int i = 0; i < kPlates; ++i)
        lab.add(scenes::box(at(0.5, 0.5 * thickness)), at(0.0, (i + 0.5) * thickness));
    lab.run(kSeconds);
    return lab.figures();
}

Figures slivers(double quality, double thickness) {
    constexpr int kSlivers = 8;
    Lab lab{{.quality = quality}, {.size = thickness, .extent = 6.0, .rests = false}};
    lab.floor();
    const std::array<Vec2, 3> corners{at(-0.5, 0.0), at(0.5, 0.0), at(0.1, thickness)};
    for (int i = 0; i < kSlivers; ++i)
        lab.add(scenes::polygon(corners), at(0.1 * (i % 3), 0.7 + 0.6 * i), {}, 0.8 * i);
    lab.run(kSeconds);
    return lab.figures();
}

}  // namespace plumb::stability
