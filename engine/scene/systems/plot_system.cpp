#include "scene/systems/plot_system.hpp"

#include <algorithm>
#include <utility>

#include "ecs/world.hpp"
#include "physics/measure/measures.hpp"
#include "physics/model/bodies.hpp"
#include "physics/simulation.hpp"
#include "scene/components/bodies/ghost.hpp"
#include "scene/components/drawing/plot.hpp"
#include "scene/lab.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {

namespace {

constexpr double kMillimetres = 1000.0;  // in a metre
constexpr float kSamplesPerSecond = 60.0f;

/// Returns the current value of a plot's quantity in a physics world.
double measure(const Plot& plot, const PhysicsState& state, const physics::World& world) {
    const physics::BodyId target = bodyOf(state, plot.target);
    const bool lives = target && physics::alive(world, target);
    switch (plot.measure) {
        case PlotMeasure::Energy: return physics::energyOf(world);
        case PlotMeasure::Overlap:
            return static_cast<double>(physics::deepestOverlapOf(world)) * kMillimetres;
        case PlotMeasure::X: return lives ? physics::positionOf(world, target).x : 0.0;
        case PlotMeasure::Y: return lives ? -physics::positionOf(world, target).y : 0.0;
        case PlotMeasure::Distance: return physics::largestDistanceOf(world, state.world) * kMillimetres;
    }
    return 0.0;
}

PlotPast::Curve& curveOf(PlotPast& past, EntityId plot, EntityId source) {
    for (PlotPast::Curve& curve : past.curves) {
        if (curve.plot == plot && curve.source == source) return curve;
    }
    PlotPast::Curve& added = past.curves.emplace_back();
    added.plot = plot, added.source = source;
    return added;
}

/// Appends the value of a tick to curves of a plot.
struct Pen {
    const Plot& plot;
    const PhysicsState& state;
    std::uint64_t run;

    void draw(PlotPast::Curve& curve, const physics::World& world) const {
        if (curve.run != run) curve.values.clear(), curve.ticks = 0;
        curve.run = run;
        double value = measure(plot, state, world);
        if (curve.ticks++ == 0) curve.first = value;
        if (plot.measure == PlotMeasure::Energy && curve.first != 0.0) value /= curve.first;
        const auto most = static_cast<std::size_t>(std::max(plot.seconds, 1.0f) * kSamplesPerSecond) + 1;
        if (curve.values.size() >= most)
            curve.values.erase(curve.values.begin(),
                               curve.values.end() - static_cast<std::ptrdiff_t>(most) + 1);
        curve.values.push_back(static_cast<float>(value));
        // Compare hashes, which are expensive, only if all positions are equal.
        curve.same = plot.measure == PlotMeasure::Distance && value == 0.0 &&
                     physics::hashOf(world) == physics::hashOf(state.world);
    }
};

}  // namespace

void PlotSystem::update(World& world, float) {
    if (world.count<Plot>() == 0) {
        if (auto* left = world.findResource<PlotPast>(); left != nullptr) left->curves.clear();
        return;
    }
    const auto* state = world.findResource<PhysicsState>();
    if (state == nullptr) return;
    auto& past = world.resource<PlotPast>();
    std::erase_if(past.curves, [&](const PlotPast::Curve& curve) {
        return !world.has<Plot>(curve.plot) || (curve.source && !world.has<Ghost>(curve.source));
    });
    const auto* lab = world.findResource<Lab>();
    const auto* ghosts = world.findResource<GhostWorlds>();
    for (auto [entity, plot] : std::as_const(world).query<const Plot>()) {
        const Pen pen{plot, *state, lab != nullptr ? lab->run : 0};
        pen.draw(curveOf(past, entity, {}), state->world);
        if (ghosts == nullptr) continue;
        for (const GhostWorlds::One& ghost : ghosts->all)
            pen.draw(curveOf(past, entity, ghost.ghost), ghost.world);
    }
}

}  // namespace plumb
