#include <algorithm>

#include "math/portable.hpp"
#include "physics/effects/integrators.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

/// Writes where a flyer is over what the solver, which did not know of its fields, has made of it.
void land(const World& world, Workspace& work, const Flyer& flyer) {
    const Vec2 displacement = flyer.now.centre - world.bodies.pose[flyer.body].centre;
    const SinCos turn = sinCos(flyer.turned);
    // cosine - 1 without the loss of digits near 0.
    const float versine = turn.cos > 0.0f ? -turn.sin * turn.sin / (1.0f + turn.cos) : turn.cos - 1.0f;
    work.deltaPosition[flyer.slot] = {displacement.x, displacement.y, turn.sin, versine};
    Float4& velocity = work.velocity[flyer.slot];
    velocity.x = flyer.now.velocity.x;
    velocity.y = flyer.now.velocity.y;
    velocity.z = flyer.now.angularVelocity;
}

}  // namespace

void integrateFlyers(StepContext& step) {
    SmoothForces& smooth = step.work.smooth;
    const auto slotBefore = [](const Flyer& flyer, std::int32_t slot) {
        return static_cast<std::int32_t>(flyer.slot) < slot;
    };
    for (const SolveGroup& group : step.work.groups) {
        const auto begin =
            std::lower_bound(smooth.flyers.begin(), smooth.flyers.end(), group.begin, slotBefore);
        const auto end = std::lower_bound(begin, smooth.flyers.end(), group.end, slotBefore);
        if (begin == end) continue;
        integrate(step.world, smooth, std::span<Flyer>{begin, end}, step.world.settings.integrator,
                  step.dt / static_cast<float>(group.substeps), group.substeps);
    }
    for (const Flyer& flyer : smooth.flyers) land(step.world, step.work, flyer);
}

}  // namespace plumb::physics
