#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/random.hpp"
#include "physics/broadphase/broad_phase.hpp"

namespace plumb::scenes {

/// Moving boxes as input of a broad phase: bounds with a
/// margin, which change when a box leaves them. Deterministic.
class Crowd {
public:
    explicit Crowd(Vec2 size) : size_{size} {}

    /// Adds a box. @param half  half of its size, m @param speed  m/s, in a random direction
    void add(Vec2 position, Vec2 half, physics::ProxyMotion motion, float speed = 0.0f);
    /// Sets the number of static boxes that each step removes and adds again elsewhere.
    void streamIn(std::uint32_t count) { streaming_ = count; }
    void step();

    [[nodiscard]] physics::Proxies proxies() const { return {bounds_, filters_, motions_}; }
    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(boxes_.size()); }
    /// Proxies whose bounds or motion changed in the last step.
    [[nodiscard]] std::span<const std::uint32_t> changed() const { return changed_; }
    /// Proxies whose overlapping pairs must be searched again; indices of boxes.
    [[nodiscard]] std::span<const std::uint32_t> moved() const { return moved_; }
    [[nodiscard]] std::span<const std::uint8_t> isMoved() const { return isMoved_; }
    [[nodiscard]] Random& random() { return random_; }
    /// Returns a random position in the area, m.
    [[nodiscard]] Vec2 anywhere();

private:
    struct Box {
        Vec2 position;      ///< center, m
        Vec2 half;          ///< half of the size, m
        Vec2 displacement;  ///< m per step
    };

    void note(std::uint32_t box, bool looks);  ///< marks a box as changed; `looks`: as moved too
    void stream();

    Vec2 size_;  ///< size of the area, m
    Random random_ = Random::seeded(1);
    std::uint32_t streaming_ = 0;
    std::vector<Box> boxes_;
    std::vector<std::uint32_t> movers_;
    std::vector<std::uint32_t> away_;  ///< boxes removed in the last step, to be added again in the next
    std::vector<AABB> bounds_;
    std::vector<physics::Filter> filters_;
    std::vector<physics::ProxyMotion> motions_;
    std::vector<std::uint32_t> changed_;
    std::vector<std::uint32_t> moved_;
    std::vector<std::uint8_t> isMoved_;
};

struct CrowdKind {
    std::string_view name;
    Crowd (*make)(std::uint32_t boxes);
};

/// Returns the kinds of crowds: different distributions and motions of the boxes.
std::span<const CrowdKind> crowdKinds();

}  // namespace plumb::scenes
