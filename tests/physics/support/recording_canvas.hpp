#pragma once

#include <map>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "physics/debug_draw.hpp"

namespace plumb::physics {

struct Stroke {
    DebugRole role;
    char kind;                 // 'l': line, 'c': circle, 'p': polygon, 'a': arrow
    std::vector<Vec2> points;  // m; a circle has its center and {radius, 0}
};

/// Records and counts strokes by role and kind, and checks that all their points are finite.
class Recording final : public DebugCanvas {
public:
    void line(Vec2 from, Vec2 to, DebugInk ink) override { note(ink.role, 'l', {from, to}); }
    void circle(Vec2 centre, float radius, DebugInk ink) override {
        note(ink.role, 'c', {centre, {radius, 0.0f}});
    }
    void polygon(std::span<const Vec2> corners, DebugInk ink) override {
        note(ink.role, 'p', {corners.begin(), corners.end()});
        if (ink.role == DebugRole::Island) islands.push_back(ink.island);
    }
    void arrow(Vec2 from, Vec2 to, DebugInk ink) override {
        note(ink.role, 'a', {from, to});
        arrows.push_back(length(to - from));
    }

    [[nodiscard]] std::size_t count(DebugRole role, char kind) const {
        const auto found = counts_.find({role, kind});
        return found != counts_.end() ? found->second : 0;
    }
    [[nodiscard]] std::size_t count() const {
        std::size_t all = 0;
        for (const auto& [key, number] : counts_) all += number;
        return all;
    }
    std::vector<Vec2> last;     // points of the last stroke
    std::vector<float> arrows;  // lengths of all arrows, m
    std::vector<Stroke> strokes;
    std::vector<std::uint32_t> islands;  // island index of each polygon with DebugRole::Island

private:
    void note(DebugRole role, char kind, std::vector<Vec2> points) {
        for (const Vec2 point : points) EXPECT_TRUE(isFinite(point));
        strokes.push_back({role, kind, points});
        last = std::move(points);
        ++counts_[{role, kind}];
    }

    std::map<std::pair<DebugRole, char>, std::size_t> counts_;
};

inline Recording drawn(World& world, std::uint32_t parts, WorldPosition origin = {}) {
    Recording recording;
    debugDraw(world, recording, {.parts = parts, .origin = origin, .lastStep = lastStepOf(world)});
    return recording;
}

/// Draws only the given bodies.
inline Recording drawnOf(World& world, std::uint32_t parts, std::span<const BodyId> bodies) {
    std::vector<std::uint8_t> selected(world.bodies.size());
    for (const BodyId body : bodies) selected[body.index] = 1;
    Recording recording;
    debugDraw(world, recording,
              {.parts = parts, .lastStep = lastStepOf(world), .selectedOnly = true, .bodies = selected});
    return recording;
}

inline std::vector<Stroke> strokesOf(const Recording& recording, DebugRole role) {
    std::vector<Stroke> found;
    for (const Stroke& stroke : recording.strokes) {
        if (stroke.role == role) found.push_back(stroke);
    }
    return found;
}

}  // namespace plumb::physics
