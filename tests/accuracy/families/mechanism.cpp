#include "tests/accuracy/families/mechanism.hpp"

#include <algorithm>
#include <cmath>

#include "math/portable.hpp"

namespace plumb::families {

std::size_t Mechanism::point(Vec2 at) {
    points.push_back(at);
    return points.size() - 1;
}

void Mechanism::rod(std::vector<std::size_t> along, float density) {
    rods.push_back({std::move(along), density});
}

std::uint32_t Mechanism::addTo(Blueprint& plan) const {
    const std::uint32_t ground = plan.addAnchor({});
    const std::uint32_t first = ground + 1;
    for (const Rod& rod : rods) addRod(plan, start(rod), end(rod), width, rod.density);
    for (std::size_t point = 0; point < points.size(); ++point) {
        std::vector<std::uint32_t> meeting;
        if (std::find(grounded.begin(), grounded.end(), point) != grounded.end()) meeting.push_back(ground);
        for (std::size_t i = 0; i < rods.size(); ++i) {
            const auto& along = rods[i].points;
            if (std::find(along.begin(), along.end(), point) != along.end())
                meeting.push_back(first + static_cast<std::uint32_t>(i));
        }
        for (std::size_t i = 1; i < meeting.size(); ++i) plan.join(meeting[0], meeting[i], points[point]);
    }
    return first;
}

Vec2 knee(Vec2 a, float reachA, Vec2 b, float reachB) {
    const Vec2 span = b - a;
    const float distance = length(span);
    const float along = (distance * distance + reachA * reachA - reachB * reachB) / (2.0f * distance);
    const float out = std::sqrt(std::max(reachA * reachA - along * along, 0.0f));
    const Vec2 direction = (1.0f / distance) * span;
    return a + along * direction + out * Vec2{-direction.y, direction.x};
}

std::uint32_t addRod(Blueprint& plan, Vec2 from, Vec2 to, float width, float density) {
    const Vec2 span = to - from;
    return plan.addDynamic(scenes::box({0.5f * length(span), 0.5f * width}), from + 0.5f * span,
                           {.density = density, .mask = 0}, arcTangent(span.y, span.x));
}

}  // namespace plumb::families
