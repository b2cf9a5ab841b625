#include "physics/effects/integrators.hpp"

#include <array>

#include "math/portable.hpp"
#include "physics/effects/forces.hpp"

namespace plumb::physics {

namespace {

/// The bodies of a group that are integrated together, and what fields may ask of them.
struct Flight {
    const World& world;
    const SmoothForces& forces;
    std::span<Flyer> flyers;
    float h;
    bool dragInside;  // drag is evaluated with the other forces
};

BodyState stateInFlight(const FieldView& view, std::uint32_t body) {
    const Flight& flight = *static_cast<const Flight*>(view.flight);
    const std::int32_t number = flight.forces.flyerOf[body];
    if (number >= 0) {
        const Flyer* flyer = &flight.forces.flyers[static_cast<std::size_t>(number)];
        if (flyer >= flight.flyers.data() && flyer < flight.flyers.data() + flight.flyers.size()) {
            return flyer->trial;
        }
    }
    BodyState state = stateAtStart(view.world, body);
    state.centre = state.centre + view.elapsed * state.velocity;
    return state;
}

bool dragIsInside(const Flight& flight, const Flyer& flyer) {
    // Only drag that is slow for the step; all other drag is integrated exactly beside it (dragHalfway).
    return flight.dragInside && flyer.linearDrag * flight.h < 0.5f && flyer.angularDrag * flight.h < 0.5f;
}

/// Accelerations of all bodies in their trial states.
void evaluate(const Flight& flight, int which, float elapsed) {
    const FieldView view{flight.world, flight.h, stateInFlight, &flight, elapsed, false};
    for (Flyer& flyer : flight.flyers) {
        Acceleration& at = flyer.at[which];
        at = accelerationAt(view, flight.forces.fieldsOf(flyer.slot), flyer.body, flyer.trial);
        if (!dragIsInside(flight, flyer)) continue;
        at.linear -= flyer.linearDrag * flyer.trial.velocity;
        at.angular -= flyer.angularDrag * flyer.trial.angularVelocity;
    }
}

Rot turnedBy(const World& world, const Flyer& flyer, float angle) {
    const Rot start = world.bodies.pose[flyer.body].rotation;
    return angle == 0.0f ? start : normalized(rotFromAngle(angle) * start);
}

/// Sets the trial state: `now`, advanced by a displacement, a rotation and a change of velocity.
void tryOut(const Flight& flight, Flyer& flyer, Vec2 displacement, float turn, const Acceleration& gained) {
    flyer.trial.centre = flyer.now.centre + displacement;
    flyer.trial.rotation = turnedBy(flight.world, flyer, flyer.turned + turn);
    flyer.trial.velocity = flyer.now.velocity + gained.linear;
    flyer.trial.angularVelocity = flyer.now.angularVelocity + gained.angular;
}

/// The same, as the new state.
void take(const Flight& flight, Flyer& flyer, Vec2 displacement, float turn, const Acceleration& gained) {
    tryOut(flight, flyer, displacement, turn, gained);
    flyer.turned += turn;
    flyer.now = flyer.trial;
}

Acceleration operator*(float s, const Acceleration& a) { return {s * a.linear, s * a.angular}; }
Acceleration operator+(Acceleration a, const Acceleration& b) { return a += b; }

/// What first-order schemes miss of the displacement under constant acceleration, h^2 a / 2. Only for bodies
/// on which nothing else acts: where a field balances the constant acceleration, it would prevent rest.
Acceleration missed(const Flyer& flyer, float h) {
    return flyer.isSteady ? (0.5f * h * h) * flyer.steady : Acceleration{};
}

/// x1 = x0 + h v0, v1 = v0 + h a(x0, v0). Gains energy in every oscillation: for teaching.
void explicitEuler(const Flight& flight, float elapsed) {
    const float h = flight.h;
    evaluate(flight, 0, elapsed);
    for (Flyer& f : flight.flyers) {
        const Acceleration more = missed(f, h);
        take(flight, f, h * f.now.velocity + more.linear, h * f.now.angularVelocity + more.angular,
             h * (f.at[0] + f.steady));
    }
}

/// v1 = v0 + h a(x0, v0), x1 = x0 + h v1: symplectic.
void semiImplicitEuler(const Flight& flight, float elapsed) {
    const float h = flight.h;
    evaluate(flight, 0, elapsed);
    for (Flyer& f : flight.flyers) {
        const Acceleration gained = h * (f.at[0] + f.steady);
        const Acceleration less = missed(f, h);
        take(flight, f, h * (f.now.velocity + gained.linear) - less.linear,
             h * (f.now.angularVelocity + gained.angular) - less.angular, gained);
    }
}

/// x1 = x0 + h v0 + h^2/2 a0, v1 = v0 + h/2 (a0 + a1): symplectic, second order.
void velocityVerlet(const Flight& flight, float elapsed) {
    const float h = flight.h;
    evaluate(flight, 0, elapsed);
    for (Flyer& f : flight.flyers) {
        const Acceleration all = f.at[0] + f.steady;
        tryOut(flight, f, h * f.now.velocity + (0.5f * h * h) * all.linear,
               h * f.now.angularVelocity + 0.5f * h * h * all.angular, h * all);
    }
    evaluate(flight, 1, elapsed + h);
    for (Flyer& f : flight.flyers) {
        const Acceleration all = f.at[0] + f.steady;
        take(flight, f, h * f.now.velocity + (0.5f * h * h) * all.linear,
             h * f.now.angularVelocity + 0.5f * h * h * all.angular, (0.5f * h) * (all + f.at[1] + f.steady));
    }
}

/// Classical scheme of W. Kutta, 1901: fourth order. Loses the energy of oscillations that are too fast for
/// the step.
void rungeKutta(const Flight& flight, float elapsed) {
    const float h = flight.h;
    constexpr std::array<float, 4> kAt{0.0f, 0.5f, 0.5f, 1.0f};
    for (int i = 0; i < 4; ++i) {
        const float part = kAt[static_cast<std::size_t>(i)] * h;
        for (Flyer& f : flight.flyers) {
            if (i == 0) continue;
            // The velocity of the previous stage is that of `trial`.
            const Vec2 displacement = part * f.trial.velocity;
            const float turn = part * f.trial.angularVelocity;
            tryOut(flight, f, displacement, turn, part * (f.at[i - 1] + f.steady));
        }
        evaluate(flight, i, elapsed + part);
    }
    for (Flyer& f : flight.flyers) {
        const Acceleration first = f.at[0] + f.at[1] + f.at[2] + 3.0f * f.steady;
        const Acceleration all = f.at[0] + 2.0f * (f.at[1] + f.at[2]) + f.at[3] + 6.0f * f.steady;
        take(flight, f, h * f.now.velocity + (h * h / 6.0f) * first.linear,
             h * f.now.angularVelocity + h * h / 6.0f * first.angular, (h / 6.0f) * all);
    }
}

using Integrator = void (*)(const Flight& flight, float elapsed);
constexpr std::array<Integrator, static_cast<std::size_t>(IntegratorKind::Count)> kIntegrators{
    explicitEuler, semiImplicitEuler, velocityVerlet, rungeKutta};

/// Applies the drag of half a step.
void dragHalfway(const Flight& flight) {
    for (Flyer& f : flight.flyers) {
        if ((f.linearDrag <= 0.0f && f.angularDrag <= 0.0f) || dragIsInside(flight, f)) continue;
        f.now.velocity *= exponential(-0.5f * flight.h * f.linearDrag);
        f.now.angularVelocity *= exponential(-0.5f * flight.h * f.angularDrag);
    }
}

}  // namespace

void integrate(const World& world, SmoothForces& forces, std::span<Flyer> flyers, IntegratorKind kind,
               float h, int substeps) {
    const auto i = static_cast<std::size_t>(kind);
    const Integrator oneStep = kIntegrators[i < kIntegrators.size() ? i : 1];
    const Flight flight{world, forces, flyers, h, kind == IntegratorKind::Rk4};
    for (int n = 0; n < substeps; ++n) {
        dragHalfway(flight);
        for (Flyer& f : flyers) f.trial = f.now;
        oneStep(flight, h * static_cast<float>(n));
        dragHalfway(flight);
    }
}

}  // namespace plumb::physics
