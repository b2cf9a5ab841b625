#include "tests/accuracy/reference/run.hpp"

#include <algorithm>
#include <cmath>

#include "core/clock.hpp"
#include "core/text.hpp"
#include "tests/accuracy/reference/group_step.hpp"
#include "tests/accuracy/reference/groups.hpp"

namespace plumb::reference {

namespace {

RunState startOf(const Scene& scene) {
    RunState state;
    state.poses = scene.poses;
    state.velocities = scene.velocities;
    for (const Body& body : scene.bodies)
        state.accelerations.push_back({body.acceleration.x, body.acceleration.y, 0.0});
    state.lawForces.resize(scene.laws.size());
    state.lawPushes.resize(scene.laws.size());
    return state;
}

bool isFinite(const RunState& state) {
    return std::all_of(state.poses.begin(), state.poses.end(),
                       [](Triple pose) { return std::isfinite(pose.x + pose.y + pose.turn); });
}

}  // namespace

RunState runScene(const Scene& scene, double seconds, double h, double deadline) {
    RunState state = startOf(scene);
    GroupStep step{scene, state};
    for (const Group& group : findGroups(scene, state, h)) step.begin(group);
    const long steps = std::max(1L, std::lround(std::ceil(seconds / h - 1.0e-6)));
    const double length = seconds / static_cast<double>(steps);
    std::vector<Press> found;
    for (long i = 0; i < steps && state.trouble.empty(); ++i) {
        if (wallSeconds() > deadline) {
            state.trouble = format("the time limit was reached after {} of {} steps", i, steps);
            break;
        }
        found.clear();
        for (const Group& group : findGroups(scene, state, length))
            step.advance(group, length, state.presses, found);
        state.presses = found;
        std::sort(state.presses.begin(), state.presses.end(),
                  [](const Press& a, const Press& b) { return a.touch.key < b.touch.key; });
        for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
            if (!scene.bodies[b].isPushed)
                state.poses[b] = scene.poses[b] + (static_cast<double>(i + 1) * length) * state.velocities[b];
        }
        if (!isFinite(state) && state.trouble.empty()) state.trouble = "a position or velocity is not finite";
    }
    return state;
}

}  // namespace plumb::reference
