// An arch of stones without mortar between two abutments, with a load on its keystone.
//
// Every arch is statically stable. A horizontal thrust H at height c of the crown section pushes the right
// half of the arch. With the weights w (at x) between the crown and a joint, the joint carries the force
// (H, -sum w), which crosses it at a distance e from its middle:
//   e (n.x V + n.y H) = c H + sum w x - p.x V - p.y H,   V = sum w, p the joint's middle, n its direction.
// The arch stands if for some H and c all e are within the stones and all forces within
// the friction cones. Source: J. Heyman, The Stone Skeleton, 1966. For a semicircle
// under its own weight this gives the known minimum thickness of 0.1075 radii. All arches
// have at least 1.15 times the minimum thickness and 1.25 times the minimum friction.
//
// Contacts may overlap by the slop of 5 mm. This shortens stones of 0.5 m by 1 % and lowers the crown by up
// to 3 % of half the span, so no arch is thinner than 5 % of half the span.

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

constexpr double kMinExcess = 1.15;     // minimum ratio of thickness to the minimum stable thickness
constexpr double kFrictionUsed = 0.8;   // maximum ratio of required to available friction
constexpr double kMinThickness = 0.05;  // minimum thickness, ratio to half the span

struct Joint {  // the face between two stones
    Vec2 middle;
    Vec2 outwards;  // unit direction from the inner to the outer end
};

/// Computes the joints of a circular arch of half span 1, from left to right.
std::vector<Joint> circleOf(int stones, float halfAngle) {
    std::vector<Joint> joints;
    const float radius = 1.0f / sine(halfAngle);
    for (int i = 0; i <= stones; ++i) {
        const float angle = halfAngle * (2.0f * static_cast<float>(i) / static_cast<float>(stones) - 1.0f);
        const Vec2 outwards{sine(angle), cosine(angle)};
        joints.push_back({radius * outwards - Vec2{0.0f, radius * cosine(halfAngle)}, outwards});
    }
    return joints;
}

/// Computes the joints of a catenary arch of half span 1, from left to right.
/// @param steepness  ratio of half the span to the radius of curvature at the crown
std::vector<Joint> catenaryOf(int stones, float steepness) {
    std::vector<Joint> joints;
    const float crown = 1.0f / steepness, half = crown * std::sinh(steepness);
    for (int i = 0; i <= stones; ++i) {
        const float along = half * (2.0f * static_cast<float>(i) / static_cast<float>(stones) - 1.0f);
        const Vec2 middle{crown * std::asinh(along / crown),
                          std::sqrt(crown * crown + half * half) - std::sqrt(crown * crown + along * along)};
        joints.push_back({middle, normalized(Vec2{along / crown, 1.0f})});
    }
    return joints;
}

struct Stone {
    std::array<Vec2, 4> corners;
    Vec2 centroid;
    float area = 0.0f;
};

Stone stoneBetween(const Joint& a, const Joint& b, float thickness) {
    const Vec2 riseA = 0.5f * thickness * a.outwards, riseB = 0.5f * thickness * b.outwards;
    Stone stone{{a.middle - riseA, b.middle - riseB, b.middle + riseB, a.middle + riseA}};
    for (std::size_t i = 1; i + 1 < stone.corners.size(); ++i) {
        const Vec2 first = stone.corners[0], second = stone.corners[i], third = stone.corners[i + 1];
        const float area = 0.5f * cross(second - first, third - first);
        stone.area += area;
        stone.centroid += (area / 3.0f) * (first + second + third);
    }
    stone.centroid *= 1.0f / stone.area;
    return stone;
}

struct Arch {
    std::vector<Joint> joints;
    float thickness = 0.1f;
    float friction = 0.6f;
    float load = 0.0f;  ///< weight of the load on the keystone, as the area of stone of this weight, m2

    [[nodiscard]] std::size_t stones() const { return joints.size() - 1; }
    [[nodiscard]] Stone stone(std::size_t i) const {
        return stoneBetween(joints[i], joints[i + 1], thickness);
    }
};

/// True if the line of thrust, for a thrust H at a height at the crown, stays
/// within the stones if only the fraction `part` of their thickness is used.
bool holds(const Arch& arch, const std::vector<Stone>& stones, double thrust, double height, double part) {
    const std::size_t key = arch.stones() / 2;
    // The right half of the keystone with half of the load.
    double weight = 0.5 * static_cast<double>(stones[key].area + arch.load);
    const auto reach = static_cast<double>(arch.joints[key + 1].middle.x);
    double moment = 0.5 * reach * static_cast<double>(0.5f * stones[key].area + 0.6f * arch.load);
    for (std::size_t i = key + 1; i <= arch.stones(); ++i) {
        const Joint& joint = arch.joints[i];
        const auto x = static_cast<double>(joint.middle.x), y = static_cast<double>(joint.middle.y);
        const auto outX = static_cast<double>(joint.outwards.x), outY = static_cast<double>(joint.outwards.y);
        const double push = outX * weight + outY * thrust, shear = outX * thrust - outY * weight;
        const double off = (height * thrust + moment - x * weight - y * thrust) / push;
        if (std::fabs(off) > 0.5 * part * static_cast<double>(arch.thickness)) return false;
        if (std::fabs(shear) > kFrictionUsed * static_cast<double>(arch.friction) * push) return false;
        if (i == arch.stones()) break;
        weight += static_cast<double>(stones[i].area);
        moment += static_cast<double>(stones[i].area) * static_cast<double>(stones[i].centroid.x);
    }
    return true;
}

bool stands(const Arch& arch, double part) {
    constexpr int kTried = 48;  // number of thrusts and of heights tried; more find no thinner arch
    std::vector<Stone> stones;
    double weight = static_cast<double>(arch.load);
    for (std::size_t i = 0; i < arch.stones(); ++i) {
        stones.push_back(arch.stone(i));
        weight += static_cast<double>(stones.back().area);
    }
    const auto crown = static_cast<double>(arch.joints[arch.stones() / 2].middle.y);
    const auto thickness = static_cast<double>(arch.thickness);
    for (int i = 0; i < kTried; ++i) {
        const double thrust = 0.05 * weight * std::pow(60.0, static_cast<double>(i) / (kTried - 1));
        for (int j = 0; j < kTried; ++j) {
            const double height = crown + thickness * (2.0 * j / (kTried - 1) - 1.0);
            if (holds(arch, stones, thrust, height, part)) return true;
        }
    }
    return false;
}

/// Sets the thickness to `excess` times the minimum stable thickness.
/// @return false if no thickness is stable
bool thicken(Arch& arch, float excess) {
    constexpr float kThickest = 0.5f, kFiner = 1.05f;
    arch.thickness = static_cast<float>(kMinThickness);
    while (arch.thickness < kThickest && !stands(arch, 1.0)) arch.thickness *= kFiner;
    arch.thickness *= excess;
    while (arch.thickness < kThickest && !stands(arch, 1.0 / kMinExcess)) arch.thickness *= kFiner;
    return arch.thickness < kThickest;
}

}  // namespace

Blueprint makeMasonryArch(Random& random) {
    const float half = random.between(3.0f, 12.0f);  // half the span, m
    const bool circular = random.below(2) == 0;
    const float shape = circular ? random.between(0.9f, 0.5f * kPi) : random.between(0.8f, 2.0f);
    // Stones are at least 0.5 m long; the shortest arch has a length of 2.3 half spans.
    const auto maxStones = static_cast<std::uint32_t>(std::min(2.3f * half / 0.5f, 25.0f));
    const int stones = 7 + 2 * static_cast<int>(random.below((maxStones - 5) / 2));
    const float density = random.between(1.0f, 50.0f), excess = random.between(1.15f, 2.0f);
    Arch arch{circular ? circleOf(stones, shape) : catenaryOf(stones, shape)};
    arch.friction = random.between(0.5f, 1.0f);
    const float share = random.between(0.0f, 0.3f);  // ratio of load to the weight of the stones
    for (float part = share;; part = 0.7f * part - 0.01f) {
        arch.load = 0.0f;
        for (std::size_t i = 0; i < arch.stones(); ++i)
            arch.load += std::max(part, 0.0f) * arch.stone(i).area;
        if (thicken(arch, excess)) break;
        if (part < 0.0f) arch.friction += 0.1f;
    }
    for (Joint& joint : arch.joints) joint.middle *= half;
    arch.thickness *= half;

    Blueprint plan;
    const Material stuff{.density = density, .friction = arch.friction};
    std::vector<std::uint32_t> bodies;
    const auto lay = [&](const Stone& stone, Motion motion) {
        std::array<Vec2, 4> corners = stone.corners;
        for (Vec2& corner : corners) corner -= stone.centroid;
        return plan.add({.motion = motion, .position = stone.centroid}, scenes::polygon(corners), stuff);
    };
    for (const std::size_t foot : {std::size_t{0}, arch.stones()}) {
        Joint outer = arch.joints[foot];
        const Vec2 along{outer.outwards.y, -outer.outwards.x};
        outer.middle += (foot == 0 ? -1.0f : 1.0f) * along;
        lay(foot == 0 ? stoneBetween(outer, arch.joints[foot], 2.0f * arch.thickness)
                      : stoneBetween(arch.joints[foot], outer, 2.0f * arch.thickness),
            Motion::Static);
    }
    for (std::size_t i = 0; i < arch.stones(); ++i) bodies.push_back(lay(arch.stone(i), Motion::Dynamic));
    const Stone key = arch.stone(arch.stones() / 2);
    const float width = 0.3f * (key.corners[2].x - key.corners[3].x);  // half the width of the load, m
    if (arch.load > 0.0f) {
        BodyPlan load;
        load.setup.position = {0.0f, key.corners[2].y + 0.5f * width};
        load.shapes.push_back({scenes::box({width, 0.5f * width}), stuff});
        load.mass = density * arch.load * half * half;
        bodies.push_back(plan.add(load));
    }
    plan.goals.push_back(staysWithin(bodies, 0.08 * static_cast<double>(half)));
    plan.goals.push_back(sleeps());
    return plan;
}

}  // namespace plumb::families
