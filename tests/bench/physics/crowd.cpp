#include "tests/bench/physics/crowd.hpp"

#include <array>
#include <cmath>

#include "math/portable.hpp"

namespace plumb::scenes {

namespace {

using enum physics::ProxyMotion;

constexpr float kStepsPerSecond = 60.0f;
constexpr float kMargin = 0.05f;  // m by which bounds are enlarged
constexpr float kFilled = 0.4f;   // ratio of the area covered by boxes
constexpr float kHalf = 0.25f;    // m: half of the side of a usual box
constexpr float kWalk = 2.0f;     // m/s: usual speed
constexpr float kDash = 40.0f;    // m/s: so fast that a box leaves its enlarged bounds in each step

bool contains(const AABB& outer, const AABB& inner) {
    return outer.min.x <= inner.min.x && outer.min.y <= inner.min.y && inner.max.x <= outer.max.x &&
           inner.max.y <= outer.max.y;
}

/// Reverses a displacement that leads out of the range from 0 to `size`.
void reverseAtEdge(float position, float size, float& displacement) {
    if (position < 0.0f) displacement = std::fabs(displacement);
    if (position > size) displacement = -std::fabs(displacement);
}

Vec2 someHalf(Random& random) {
    return {kHalf * random.between(0.6f, 1.4f), kHalf * random.between(0.6f, 1.4f)};
}

/// Returns the side of a square of which `boxes` usual boxes cover the ratio kFilled, m.
float sideFor(std::uint32_t boxes) {
    return std::sqrt(static_cast<float>(boxes) * 4.0f * kHalf * kHalf / kFilled);
}
Crowd squareFor(std::uint32_t boxes) { return Crowd{{sideFor(boxes), sideFor(boxes)}}; }

Crowd lineFor(std::uint32_t boxes) { return Crowd{{sideFor(boxes) * sideFor(boxes), 1.0f}}; }

/// Adds moving boxes at random positions.
Crowd filled(Crowd crowd, std::uint32_t boxes, float speed) {
    for (std::uint32_t i = 0; i < boxes; ++i)
        crowd.add(crowd.anywhere(), someHalf(crowd.random()), Awake, speed);
    return crowd;
}

Crowd makeUniform(std::uint32_t boxes) { return filled(squareFor(boxes), boxes, kWalk); }
Crowd makeFast(std::uint32_t boxes) { return filled(squareFor(boxes), boxes, kDash); }

Crowd makeClustered(std::uint32_t boxes) {
    constexpr std::uint32_t kClusters = 8;
    const float radius = 0.5f * sideFor(boxes / kClusters + 1);
    Crowd crowd{{40.0f * radius, 40.0f * radius}};
    std::array<Vec2, kClusters> middles;
    for (Vec2& middle : middles) middle = crowd.anywhere();
    Random& random = crowd.random();
    const auto offset = [&] { return radius * (random.unit() + random.unit() + random.unit() - 1.5f); };
    for (std::uint32_t i = 0; i < boxes; ++i)
        crowd.add(middles[i % kClusters] + Vec2{offset(), offset()}, someHalf(random), Awake, kWalk);
    return crowd;
}

Crowd makeOneSize(std::uint32_t boxes) {
    const auto columns = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<float>(boxes))));
    const float pitch = 2.1f * kHalf;
    Crowd crowd{{pitch * static_cast<float>(columns + 1), pitch * static_cast<float>(columns + 1)}};
    for (std::uint32_t i = 0; i < boxes; ++i) {
        const Vec2 cell{static_cast<float>(i % columns + 1), static_cast<float>(i / columns + 1)};
        crowd.add(pitch * cell, {kHalf, kHalf}, Awake, kWalk);
    }
    return crowd;
}

/// Returns a crowd of boxes of 0.1 m to 20 m, most of them small.
Crowd makeMixedSizes(std::uint32_t boxes) {
    std::vector<Vec2> halves;
    Random random = Random::seeded(2);
    float area = 0.0f;
    for (std::uint32_t i = 0; i < boxes; ++i) {
        const float part = random.unit();
        const float half = 0.05f * exponential(5.3f * part * part * part);
        halves.push_back({half * random.between(0.6f, 1.4f), half * random.between(0.6f, 1.4f)});
        area += 4.0f * halves.back().x * halves.back().y;
    }
    const float side = std::sqrt(area / kFilled);
    Crowd crowd{{side, side}};
    for (const Vec2 half : halves) crowd.add(crowd.anywhere(), half, Awake, kWalk);
    return crowd;
}

Crowd makeMostlyStill(std::uint32_t boxes) {
    Crowd crowd = squareFor(boxes);
    for (std::uint32_t i = 0; i < boxes; ++i) {
        const physics::ProxyMotion motion = i % 50 == 0 ? Awake : i % 2 == 0 ? Asleep : Static;
        crowd.add(crowd.anywhere(), someHalf(crowd.random()), motion, kWalk);
    }
    return crowd;
}

Crowd makeLine(std::uint32_t boxes) { return filled(lineFor(boxes), boxes, kWalk); }
Crowd makeFastLine(std::uint32_t boxes) { return filled(lineFor(boxes), boxes, kDash); }

/// Returns a heap at rest: only one box in 20 moves.
Crowd makePile(std::uint32_t boxes) {
    const float side = std::sqrt(static_cast<float>(boxes)) * 1.9f * kHalf;
    Crowd crowd{{side, side}};
    for (std::uint32_t i = 0; i < boxes; ++i)
        crowd.add(crowd.anywhere(), someHalf(crowd.random()), Awake, i % 20 == 0 ? kWalk : 0.0f);
    return crowd;
}

/// Returns static boxes of which 1 % per step are removed and added elsewhere, as when parts of a level are
/// loaded and unloaded.
Crowd makeStreaming(std::uint32_t boxes) {
    Crowd crowd = squareFor(boxes);
    for (std::uint32_t i = 0; i < boxes; ++i)
        crowd.add(crowd.anywhere(), someHalf(crowd.random()), i % 500 == 0 ? Awake : Static, kWalk);
    crowd.streamIn(boxes / 100);
    return crowd;
}

constexpr std::array kKinds{
    CrowdKind{"uniform", &makeUniform},
    CrowdKind{"clustered", &makeClustered},
    CrowdKind{"one size", &makeOneSize},
    CrowdKind{"mixed sizes", &makeMixedSizes},
    CrowdKind{"mostly still", &makeMostlyStill},
    CrowdKind{"all fast", &makeFast},
    CrowdKind{"one line", &makeLine},
    CrowdKind{"one fast line", &makeFastLine},
    CrowdKind{"a pile", &makePile},
    CrowdKind{"coming and going", &makeStreaming},
};

}  // namespace

std::span<const CrowdKind> crowdKinds() { return kKinds; }

Vec2 Crowd::anywhere() { return {size_.x * random_.unit(), size_.y * random_.unit()}; }

void Crowd::note(std::uint32_t box, bool looks) {
    if (isMoved_[box] != 0) return;
    changed_.push_back(box);
    if (!looks) return;
    moved_.push_back(box);
    isMoved_[box] = 1;
}

void Crowd::add(Vec2 position, Vec2 half, physics::ProxyMotion motion, float speed) {
    const std::uint32_t id = size();
    const SinCos direction = sinCos(random_.between(-kPi, kPi));
    const float pace = motion == Awake ? speed / kStepsPerSecond : 0.0f;
    boxes_.push_back({position, half, pace * Vec2{direction.cos, direction.sin}});
    if (pace > 0.0f) movers_.push_back(id);
    bounds_.push_back(grown({position - half, position + half}, kMargin));
    filters_.push_back({.body = id});
    motions_.push_back(motion);
    isMoved_.push_back(0);
    note(id, true);
}

/// Adds the boxes removed in the previous step at other positions, and removes others.
void Crowd::stream() {
    for (const std::uint32_t id : away_) {
        Box& box = boxes_[id];
        box.position = anywhere();
        bounds_[id] = grown({box.position - box.half, box.position + box.half}, kMargin);
        motions_[id] = Static;
        note(id, true);
    }
    away_.clear();
    while (away_.size() < streaming_) {
        const std::uint32_t id = random_.below(size());
        if (motions_[id] != Static || isMoved_[id] != 0) continue;
        motions_[id] = Gone;
        away_.push_back(id);
        note(id, false);
    }
}

void Crowd::step() {
    for (const std::uint32_t id : moved_) isMoved_[id] = 0;
    changed_.clear();
    moved_.clear();
    stream();
    for (const std::uint32_t id : movers_) {
        Box& box = boxes_[id];
        box.position += box.displacement;
        reverseAtEdge(box.position.x, size_.x, box.displacement.x);
        reverseAtEdge(box.position.y, size_.y, box.displacement.y);
        const AABB tight{box.position - box.half, box.position + box.half};
        if (contains(bounds_[id], tight)) continue;
        bounds_[id] = grown(tight, kMargin);
        note(id, true);
    }
}

}  // namespace plumb::scenes
