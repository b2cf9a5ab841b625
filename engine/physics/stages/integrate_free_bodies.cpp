#include <algorithm>

#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

/// The bodies of a group that are integrated together, and the context for field evaluation.
struct Flight {
    const World& world;
    const SmoothForces& forces;
    std::span<FreeBody> flyers;
    float h;
    bool dragInside;  // drag is evaluated together with the other forces
};

BodyState stateInFlight(const FieldView& view, std::uint32_t body) {
    const Flight& flight = *static_cast<const Flight*>(view.flight);
    const std::int32_t number = flight.forces.flyerOf[body];
    if (number >= 0) {
        const FreeBody* flyer = &flight.forces.flyers[static_cast<std::size_t>(number)];
        if (flyer >= flight.flyers.data() && flyer < flight.flyers.data() + flight.flyers.size())
            return flyer->trial;
    }
    return stateAfter(view.world, body, view.elapsed);
}

bool dragIsInside(const Flight& flight, const FreeBody& flyer) {
    // Only slow drag; other drag is integrated exactly by dragHalfway().
    return flight.dragInside && flyer.linearDrag * flight.h < 0.5f && flyer.angularDrag * flight.h < 0.5f;
}

/// Computes the accelerations of all bodies in their trial states.
void evaluate(const Flight& flight, int which, float elapsed) {
    const FieldView view{flight.world, flight.h, flight.forces.springScales, stateInFlight, &flight, elapsed};
    for (FreeBody& flyer : flight.flyers) {
        Acceleration& at = flyer.at[which];
        at = accelerationAt(view, flight.forces.fieldsOf(flyer.slot), flyer.body, flyer.trial, flyer.steady);
        if (!dragIsInside(flight, flyer)) continue;
        at.linear -= flyer.linearDrag * flyer.trial.velocity;
        at.angular -= flyer.angularDrag * flyer.trial.angularVelocity;
    }
}

Acceleration velocityOf(const BodyState& state) { return {state.velocity, state.angularVelocity}; }

/// Sets the trial state: `now`, advanced by a displacement and a change of velocity.
void tryOut(const Flight& flight, FreeBody& flyer, const Acceleration& displacement,
            const Acceleration& gained) {
    const Rot start = flight.world.bodies.pose[flyer.body].rotation;
    const float angle = flyer.turned + displacement.angular;
    flyer.trial.centre = flyer.now.centre + displacement.linear;
    flyer.trial.rotation = angle == 0.0f ? start : normalized(rotFromAngle(angle) * start);
    flyer.trial.velocity = flyer.now.velocity + gained.linear;
    flyer.trial.angularVelocity = flyer.now.angularVelocity + gained.angular;
}

/// Sets the new state: `now`, advanced by a displacement and a change of velocity.
void take(const Flight& flight, FreeBody& flyer, const Acceleration& displacement,
          const Acceleration& gained) {
    tryOut(flight, flyer, displacement, gained);
    flyer.turned += displacement.angular;
    flyer.now = flyer.trial;
}

/// Returns the error of first-order schemes in the displacement under constant acceleration, h^2 a / 2. 0
/// with other accelerations: if a field balances the constant one, the correction would prevent rest.
Acceleration missed(const FreeBody& flyer, float h) {
    return flyer.isSteady ? (0.5f * h * h) * flyer.steady : Acceleration{};
}

/// x1 = x0 + h v0, v1 = v0 + h a(x0, v0). Adds energy to every oscillation; for teaching.
void explicitEuler(const Flight& flight, float elapsed) {
    const float h = flight.h;
    evaluate(flight, 0, elapsed);
    for (FreeBody& f : flight.flyers)
        take(flight, f, h * velocityOf(f.now) + missed(f, h), h * (f.at[0] + f.steady));
}

/// v1 = v0 + h a(x0, v0), x1 = x0 + h v1: symplectic.
void semiImplicitEuler(const Flight& flight, float elapsed) {
    const float h = flight.h;
    evaluate(flight, 0, elapsed);
    for (FreeBody& f : flight.flyers) {
        const Acceleration gained = h * (f.at[0] + f.steady);
        take(flight, f, h * (velocityOf(f.now) + gained) - missed(f, h), gained);
    }
}

/// x1 = x0 + h v0 + h^2/2 a0, v1 = v0 + h/2 (a0 + a1): symplectic, second order.
void velocityVerlet(const Flight& flight, float elapsed) {
    const float h = flight.h;
    const auto displacement = [h](const FreeBody& f) {
        return h * velocityOf(f.now) + (0.5f * h * h) * (f.at[0] + f.steady);
    };
    evaluate(flight, 0, elapsed);
    for (FreeBody& f : flight.flyers) tryOut(flight, f, displacement(f), h * (f.at[0] + f.steady));
    evaluate(flight, 1, elapsed + h);
    for (FreeBody& f : flight.flyers)
        take(flight, f, displacement(f), (0.5f * h) * (f.at[0] + f.steady + f.at[1] + f.steady));
}

/// Classical scheme of W. Kutta, 1901: fourth order. Loses energy of oscillations too fast for the step.
void rungeKutta(const Flight& flight, float elapsed) {
    const float h = flight.h;
    constexpr std::array<float, 4> kAt{0.0f, 0.5f, 0.5f, 1.0f};
    for (int i = 0; i < 4; ++i) {
        const float part = kAt[static_cast<std::size_t>(i)] * h;
        for (FreeBody& f : flight.flyers) {
            // `trial` has the velocity of the previous stage.
            if (i > 0) tryOut(flight, f, part * velocityOf(f.trial), part * (f.at[i - 1] + f.steady));
        }
        evaluate(flight, i, elapsed + part);
    }
    for (FreeBody& f : flight.flyers) {
        const Acceleration first = f.at[0] + f.at[1] + f.at[2] + 3.0f * f.steady;
        const Acceleration all = f.at[0] + 2.0f * (f.at[1] + f.at[2]) + f.at[3] + 6.0f * f.steady;
        take(flight, f, h * velocityOf(f.now) + (h * h / 6.0f) * first, (h / 6.0f) * all);
    }
}

using Integrator = void (*)(const Flight& flight, float elapsed);
constexpr std::array<Integrator, static_cast<std::size_t>(IntegratorKind::Count)> kIntegrators{
    explicitEuler, semiImplicitEuler, velocityVerlet, rungeKutta};

void dragHalfway(const Flight& flight) {
    for (FreeBody& f : flight.flyers) {
        if ((f.linearDrag == 0.0f && f.angularDrag == 0.0f) || dragIsInside(flight, f)) continue;
        f.now.velocity *= exponential(-0.5f * flight.h * f.linearDrag);
        f.now.angularVelocity *= exponential(-0.5f * flight.h * f.angularDrag);
    }
}

/// Advances bodies of a group through all substeps, together, as they may attract each other. Every scheme is
/// exact under steady acceleration alone. Drag is split off and also exact (G. Strang, 1968); only
/// Runge-Kutta evaluates slow drag with the other forces. Source: E. Hairer, C. Lubich, G. Wanner, "Geometric
/// Numerical Integration", 2006, I.1.
void integrate(const StepContext& step, const SolveGroup& group, std::span<FreeBody> flyers) {
    const auto kind = static_cast<std::size_t>(step.world.settings.integrator);
    const Integrator oneStep = kIntegrators[kind < kIntegrators.size() ? kind : 1];
    const float h = step.dt / static_cast<float>(group.substeps);
    const Flight flight{step.world, step.work.smooth, flyers, h, oneStep == rungeKutta};
    for (int n = 0; n < group.substeps; ++n) {
        dragHalfway(flight);
        for (FreeBody& f : flyers) f.trial = f.now;
        oneStep(flight, h * static_cast<float>(n));
        dragHalfway(flight);
    }
}

/// Replaces the solver's result for a flyer, which does not include fields, by the integrated state.
void land(const World& world, Workspace& work, const FreeBody& flyer) {
    const Vec2 displacement = flyer.now.centre - world.bodies.pose[flyer.body].centre;
    const SinCos rotation = sinCos(flyer.turned);
    // cosine - 1, without cancellation near 0.
    const float versine =
        rotation.cos > 0.0f ? -rotation.sin * rotation.sin / (1.0f + rotation.cos) : rotation.cos - 1.0f;
    work.deltaPosition[flyer.slot] = {displacement.x, displacement.y, rotation.sin, versine};
    Float4& velocity = work.velocity[flyer.slot];
    velocity.x = flyer.now.velocity.x;
    velocity.y = flyer.now.velocity.y;
    velocity.z = flyer.now.angularVelocity;
}

}  // namespace

void integrateFreeBodies(StepContext& step) {
    SmoothForces& smooth = step.work.smooth;
    const auto slotBefore = [](const FreeBody& flyer, std::int32_t slot) {
        return static_cast<std::int32_t>(flyer.slot) < slot;
    };
    for (const SolveGroup& group : step.work.groups) {
        const auto begin =
            std::lower_bound(smooth.flyers.begin(), smooth.flyers.end(), group.begin, slotBefore);
        const auto end = std::lower_bound(begin, smooth.flyers.end(), group.end, slotBefore);
        if (begin != end) integrate(step, group, {&*begin, static_cast<std::size_t>(end - begin)});
    }
    for (const FreeBody& flyer : smooth.flyers) land(step.world, step.work, flyer);
}

}  // namespace plumb::physics
