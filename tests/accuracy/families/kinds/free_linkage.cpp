// Linkages without motors that swing under gravity: four-bar linkages, parallelograms and Jansen legs, which
// form loops with the ground; multiple pendulums, pantographs and scissors, which hang from the ground.
//
// Rigid rods and hinges without friction conserve energy, and semi-implicit Euler with 4 substeps of 4 ms
// (quality 2) does so on average. The allowed loss in 8 s is a tenth of the maximum kinetic energy, which
// makes the speed 5 % lower. Linkages that could fold flat have a limit at a hinge, which dissipates
// energy at every stop; they have no energy goal.
//
// Positions with all rods of a loop on one line are avoided, as the loop can change its branch there. A
// four-bar linkage reaches one only if its shortest and longest rods together are as long as both others. A
// parallelogram always could; it starts at rest below the height of such a position.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"
#include "tests/accuracy/families/mechanism.hpp"

namespace plumb::families {

namespace {

/// Draws random densities of rods, 1 to 10^spread times the minimum.
struct Densities {
    Random& random;
    float minimum = 1.0f;
    float spread = 1.0f;  ///< maximum ratio as a power of 10
    float operator()() { return minimum * std::pow(10.0f, spread * random.unit()); }
};

Vec2 arm(float length, float angle) { return {length * cosine(angle), length * sine(angle)}; }

void fourBar(Mechanism& made, Random& random, Densities& density) {
    std::array<float, 4> sides{};  // crank, coupler, rocker, ground
    float angle = 0.0f;
    while (true) {
        for (float& side : sides) side = random.between(0.4f, 2.0f);
        angle = random.between(0.0f, kTau);
        std::array<float, 4> sorted = sides;
        std::sort(sorted.begin(), sorted.end());
        const float excess = sorted[0] + sorted[3] - sorted[1] - sorted[2];
        const float across = distance(arm(sides[0], angle), {sides[3], 0.0f});
        const bool closes =
            across < 0.95f * (sides[1] + sides[2]) && across > 1.05f * std::fabs(sides[1] - sides[2]);
        if (closes && std::fabs(excess) > 0.2f * sorted[0]) break;
    }
    const std::size_t left = made.point({}), right = made.point({sides[3], 0.0f});
    const std::size_t pin = made.point(arm(sides[0], angle));
    const std::size_t joint = made.point(knee(made.points[pin], sides[1], made.points[right], sides[2]));
    made.grounded = {left, right};
    made.rod({left, pin}, density());
    made.rod({pin, joint}, density());
    made.rod({joint, right}, density());
}

void parallelogram(Mechanism& made, Random& random, Densities& density) {
    const float base = random.between(1.0f, 3.0f);
    const Vec2 swing = arm(random.between(0.5f, 2.0f), random.between(-kPi + 0.4f, -0.4f));
    const std::size_t left = made.point({}), right = made.point({base, 0.0f});
    const std::size_t leftEnd = made.point(swing), rightEnd = made.point(made.points[right] + swing);
    made.grounded = {left, right};
    made.rod({left, leftEnd}, density());
    made.rod({right, rightEnd}, density());
    made.rod({leftEnd, rightEnd}, density());
}

/// Adds the leg of T. Jansen's walking machine with lengths varied by 2 %: 11 rods in five loops.
void jansenLeg(Mechanism& made, Random& random, Densities& density) {
    const auto side = [&](float length) { return 0.02f * length * random.between(0.98f, 1.02f); };
    const std::size_t axle = made.point({}), fixed = made.point({-side(38.0f), -side(7.8f)});
    const std::size_t crank = made.point(arm(side(15.0f), random.between(0.0f, kTau)));
    const Vec2 hub = made.points[fixed], pin = made.points[crank];
    const std::size_t top = made.point(knee(hub, side(41.5f), pin, side(50.0f)));
    const std::size_t low = made.point(knee(pin, side(61.9f), hub, side(39.3f)));
    const std::size_t back = made.point(knee(hub, side(40.1f), made.points[top], side(55.8f)));
    const std::size_t heel = made.point(knee(made.points[low], side(36.7f), made.points[back], side(39.4f)));
    const std::size_t foot = made.point(knee(made.points[low], side(49.0f), made.points[heel], side(65.7f)));
    made.grounded = {axle, fixed};
    made.rod({axle, crank}, density());
    for (const auto& [a, b] : {std::pair{crank, top},
                               {fixed, top},
                               {fixed, back},
                               {top, back},
                               {crank, low},
                               {fixed, low},
                               {back, heel},
                               {low, heel},
                               {low, foot},
                               {heel, foot}})
        made.rod({a, b}, density());
}

void pendulums(Mechanism& made, Random& random, Densities& density) {
    std::size_t from = made.point({});
    made.grounded = {from};
    const int rods = 2 + static_cast<int>(random.below(4));
    for (int i = 0; i < rods; ++i) {
        const std::size_t to =
            made.point(made.points[from] + arm(random.between(0.4f, 1.2f), random.between(-kPi, 0.3f)));
        made.rod({from, to}, density());
        from = to;
    }
}

/// Adds a pantograph: a parallelogram with two extended arms.
void pantograph(Mechanism& made, Random& random, Densities& density) {
    const float angle = random.between(-2.2f, -0.9f), opening = random.between(0.6f, 1.2f);
    const float upper = random.between(1.0f, 2.0f), lower = random.between(1.0f, 2.0f);
    const float part = random.between(0.3f, 0.7f);
    const std::size_t hub = made.point({}), elbow = made.point(arm(upper, angle));
    const Vec2 along = arm(1.0f, angle), back = arm(1.0f, angle + opening);
    const std::size_t hand = made.point(made.points[elbow] + lower * back);
    const std::size_t onUpper = made.point(part * upper * along);
    const std::size_t onLower = made.point(made.points[elbow] + (1.0f - part) * lower * back);
    const std::size_t inner = made.point(made.points[onUpper] + (1.0f - part) * lower * back);
    made.grounded = {hub};
    made.rod({hub, onUpper, elbow}, density());
    made.rod({elbow, onLower, hand}, density());
    made.rod({onUpper, inner}, density());
    made.rod({onLower, inner}, density());
}

/// Adds a scissor mechanism: pairs of crossed rods, one below the other.
void scissors(Mechanism& made, Random& random, Densities& density) {
    const int stages = 2 + static_cast<int>(random.below(4));
    const float width = random.between(0.3f, 0.7f), height = random.between(0.3f, 0.7f);
    std::size_t left = made.point({}), right = made.point({2.0f * width, 0.0f});
    made.grounded = {left};
    for (int i = 0; i < stages; ++i) {
        const float y = -2.0f * height * static_cast<float>(i + 1);
        const std::size_t middle = made.point({width, y + height});
        const std::size_t lowLeft = made.point({0.0f, y}), lowRight = made.point({2.0f * width, y});
        made.rod({left, middle, lowRight}, density());
        made.rod({right, middle, lowLeft}, density());
        left = lowLeft;
        right = lowRight;
    }
}

/// Limits the hinge between two rods, so that no loop can fold
/// flat. The angle of this hinge determines the shape of all loops.
void limit(Blueprint& plan, std::uint32_t a, std::uint32_t b, float by) {
    for (JointSetup& joint : plan.joints) {
        if (joint.a.index != a || joint.b.index != b) continue;
        joint.limited = true;
        joint.lower = -by;
        joint.upper = by;
    }
}

/// Records the energy of the rods before each step, in any engine.
struct EnergyBook {
    struct Body {
        std::uint32_t body;
        double mass, inertia;
    };
    std::vector<Body> bodies;
    double first = 0.0, highest = 0.0;  ///< energy at the start, maximum kinetic energy, J

    [[nodiscard]] double motion(const Stage& stage) const {
        double sum = 0.0;
        for (const Body& rod : bodies) {
            if (!takesPart(stage, rod.body)) continue;
            const auto speed = static_cast<double>(lengthSquared(stage.velocityOf(rod.body)));
            const auto spin = static_cast<double>(stage.spinOf(rod.body));
            sum += 0.5 * (rod.mass * speed + rod.inertia * spin * spin);
        }
        return sum;
    }
    [[nodiscard]] double height(const Stage& stage) const {
        double sum = 0.0;
        for (const Body& rod : bodies)
            if (takesPart(stage, rod.body)) sum += 10.0 * rod.mass * stage.positionOf(rod.body).y;
        return sum;
    }
    void look(const Stage& stage, int step) {
        const double now = motion(stage);
        if (step == 0) first = now + height(stage);
        highest = step == 0 ? now : std::max(highest, now);
    }
};

Goal keepsEnergy(const std::shared_ptr<EnergyBook>& book, double share) {
    return {"keeps its energy",
            [book](const Stage& stage) {
                const double now = book->motion(stage) + book->height(stage);
                return book->highest > 0.0 ? std::fabs(now - book->first) / book->highest : 0.0;
            },
            share};
}

}  // namespace

Blueprint makeFreeLinkage(Random& random) {
    Blueprint plan;
    plan.seconds = 8.0;
    Mechanism made;
    made.width = random.between(0.05f, 0.15f);
    Densities density{random, random.between(1.0f, 50.0f), random.unit()};
    const auto kind = random.below(6);
    switch (kind) {
        case 0: fourBar(made, random, density); break;
        case 1: parallelogram(made, random, density); break;
        case 2: jansenLeg(made, random, density); break;
        case 3: pendulums(made, random, density); break;
        case 4: pantograph(made, random, density); break;
        default: scissors(made, random, density);
    }
    const std::uint32_t first = made.addTo(plan);
    if (kind == 4) limit(plan, first, first + 1, 0.4f);
    if (kind == 5) limit(plan, first, first + 1, 0.5f);
    auto book = std::make_shared<EnergyBook>();
    float shortest = 1.0e9f;
    for (std::size_t i = 0; i < made.rods.size(); ++i) {
        const float length = made.length(made.rods[i]), mass = made.rods[i].density * length * made.width;
        const float inertia = mass / 12.0f * (length * length + made.width * made.width);
        book->bodies.push_back(
            {first + static_cast<std::uint32_t>(i), static_cast<double>(mass), static_cast<double>(inertia)});
        shortest = std::min(shortest, length);
    }
    plan.drive = [book](Stage& stage, int step) { book->look(stage, step); };
    plan.goals.push_back(keepsJoints(0.02 * static_cast<double>(shortest)));
    if (kind < 4) plan.goals.push_back(keepsEnergy(book, 0.1));
    return plan;
}

}  // namespace plumb::families
