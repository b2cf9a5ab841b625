#include <array>

#include "tests/accuracy/report/scene_texts.hpp"

// Texts of the scenes with exact results. All numbers were measured with ./plumb accuracy.

namespace plumb::accuracy {

namespace {

constexpr auto kExact = std::to_array<SceneText>({
    {.name = "freefall",
     .number = 1,
     .title = "Free fall",
     .answer = "A ball has fallen ½ g t² after 2 s.",
     .shows = "Constant acceleration is integrated exactly, so one substep is as good as 64: the error is "
              "hundredths of a millimeter. Engines that multiply the new velocity by the step fall too far, "
              "by 167 mm here.",
     .choose = "Anything; substeps make no difference.",
     .why = "More substeps do not reduce the error: the method is exact. What remains is the rounding of "
            "velocities to single precision, once in each substep."},
    {.name = "projectile",
     .number = 2,
     .title = "Projectile",
     .answer = "A thrown ball is on its parabola after 2 s.",
     .shows = "As in free fall the path is exact at every quality, so a jump or a shot lands "
              "where the formula says.",
     .choose = "Anything; aim with the formula.",
     .why = "As in free fall: only rounding remains."},
    {.name = "drag",
     .number = 3,
     .title = "Throw with linear drag",
     .answer = "v(t) = v₀ e^(-kt) in addition to gravity, for 2 s.",
     .shows = "Drag is solved in closed form in each substep, so it is exact too. Engines that subtract it "
              "step by step are wrong by 66 mm.",
     .choose = "Anything.",
     .why = "Substeps do not reduce it: the method is exact, and the rounding of the factor e^(-kh) adds up "
            "over more substeps."},
    {.name = "spring05",
     .number = 4,
     .title = "Spring of 0.5 Hz",
     .answer = "cos ωt; error: the largest deviation in 10 s.",
     .shows = "A slow spring shows the four integrators as textbooks do. With Runge-Kutta 4 only rounding "
              "remains at once, Verlet improves four times with each doubling, the two Euler schemes twice.",
     .choose = "Runge-Kutta 4, even with one substep.",
     .order = 1.0},
    {.name = "spring2",
     .number = 4,
     .title = "Spring of 2 Hz",
     .answer = "cos ωt; error: the largest deviation in 10 s.",
     .shows = "Twenty periods: the default, semi-implicit Euler, lags by 40 mm and never loses energy; "
              "Runge-Kutta 4 with the same four substeps is accurate to a tenth of a micrometer. Explicit "
              "Euler gains energy in every period, until the maximum speed limits it.",
     .choose = "Runge-Kutta 4 if the motion has to be accurate; the default if it only has to look like a "
               "spring.",
     .order = 1.0,
     .why = "The default's order is above 1 at few substeps, as a second-order phase lag is added. The "
            "energy that explicit Euler gains multiplies from period to period, so its error falls faster "
            "than a power while it is huge. Runge-Kutta 4 has only two points above its floor."},
    {.name = "spring5",
     .number = 4,
     .title = "Spring of 5 Hz",
     .answer = "cos ωt; error: the largest deviation in 10 s.",
     .shows = "With 12 steps per period, one substep of Euler or Verlet conserves energy but is out of phase "
              "by half a period. Runge-Kutta 4 is the best at every number of substeps, though with one it "
              "loses 15 % of the energy.",
     .choose = "Runge-Kutta 4 with two substeps or more.",
     .order = 1.0,
     .why = "An error of two meters is the other end of the oscillation and cannot grow; below it errors "
            "follow a power. At 16 substeps the default still has its additional phase lag of second order."},
    {.name = "spring10",
     .number = 4,
     .title = "Spring of 10 Hz",
     .answer = "cos ωt; error: the largest deviation in 10 s.",
     .shows = "Six steps per period are too few for any scheme with one substep: Runge-Kutta 4 loses all of "
              "the energy, semi-implicit Euler and Verlet swing out of phase, explicit Euler ends at the "
              "maximum speed. From four substeps on Runge-Kutta 4 is the best again.",
     .choose = "Quality 2 or more and Runge-Kutta 4; Verlet if there must be few substeps, because it "
               "conserves energy.",
     .order = 1.0,
     .why = "Up to 4 substeps all except Runge-Kutta 4 are out of phase by half a period, which no power "
            "describes; above that the default's phase lag of second order is the larger part of its error. "
            "Explicit Euler is limited by the maximum speed."},
    {.name = "underdamped",
     .number = 5,
     .title = "Damping of a tenth of critical",
     .answer = "Decaying oscillation of 1 Hz; error: the largest deviation in 5 s.",
     .shows = "Damping reduces errors too: they decay with the motion itself. The order is that of the "
              "undamped spring.",
     .choose = "The default; Runge-Kutta 4 if it has to be accurate.",
     .order = 1.0},
    {.name = "critical",
     .number = 5,
     .title = "Critical damping",
     .answer = "It returns as fast as possible without overshoot; error: the largest deviation in 5 s.",
     .shows = "The usual setting of cameras and doors. All integrators are stable here, and "
              "the error of the default halves with each doubling.",
     .choose = "The default.",
     .order = 1.0},
    {.name = "overdamped",
     .number = 5,
     .title = "Damping of three times critical",
     .answer = "It returns slowly; error: the largest deviation in 5 s.",
     .shows = "A stiff damper and a slow return. No scheme gains energy; the default is wrong by 4 mm of a "
              "meter.",
     .choose = "The default.",
     .order = 1.0},
    {.name = "resonance",
     .number = 6,
     .title = "Driven at resonance",
     .answer = "It swings to F / (2ζk) once it has settled, after 40 s.",
     .shows = "The amplitude of a driven spring is accurate to hundredths of a percent, except with explicit "
              "Euler, which adds energy: 35 % too large at four substeps. The force is that of the middle of "
              "each step, constant over the step; the exact answer includes the 0.05 % by which that is "
              "weaker than a smooth force.",
     .choose = "Anything; apply the force of the step's middle.",
     .order = 1.0,
     .why = "The first-order part of the error shifts the phase and not the amplitude, so the error of the "
            "amplitude falls faster and soon reaches rounding."},
    {.name = "pendulum",
     .number = 7,
     .title = "Pendulum, released horizontally",
     .answer = "It returns to the same height for 10 s; error: the fraction of it that is lost.",
     .shows = "With joint trees the arm is solved exactly in each substep: the default loses 0.004 % of its "
              "height. Iteratively solved joints lose 0.9 %, and engines without substeps lose half of the "
              "height.",
     .choose = "Leave direct joints on; quality 1 is enough.",
     .order = 2.0,
     .why = "The energy error falls by 8 with each doubling, one order better than the scheme's second, "
            "until the rounding of single precision at 0.001 %."},
    {.name = "pendulum90",
     .number = 8,
     .title = "Pendulum at 90 degrees",
     .answer = "Its period is 4 K(sin θ/2) √(L/g).",
     .shows = "Clocks are easy: the default's period is accurate to 0.002 %.",
     .choose = "Leave direct joints on; any quality.",
     .order = 2.0,
     .why = "From 4 substeps on errors are below a thousandth of a percent, where rounding and the "
            "interpolation of time between two steps contribute."},
    {.name = "pendulum170",
     .number = 8,
     .title = "Pendulum at 170 degrees",
     .answer = "Its period is 4 K(sin θ/2) √(L/g).",
     .shows = "It nearly stops upside down, so lost energy shows in its period: 4.6 % with one substep, 0.04 "
              "% with four. Engines that lose energy are wrong by half.",
     .choose = "Quality 2 with direct joints.",
     .order = 2.0,
     .why = "As with the height of the pendulum released horizontally, it falls by 8 to 10 with each "
            "doubling, one order better than the scheme's second."},
    {.name = "doublependulum",
     .number = 9,
     .title = "Double pendulum",
     .answer = "The position of a solution with a step of 20 µs after 2 s.",
     .shows = "Two discs on arms, released horizontally. The default is wrong by 0.2 mm after 2 s and "
              "conserves energy to a thousandth of a percent.",
     .choose = "Leave direct joints on; quality 2.",
     .order = 2.0,
     .why = "Second order down to 0.04 mm; from 8 substeps on rounding dominates, and chaos amplifies it."},
    {.name = "orbit",
     .number = 10,
     .title = "Two bodies around each other",
     .answer = "After 100 revolutions they are where they began.",
     .shows = "The default conserves energy within a percent, but its position is wrong by 0.8 m after 100 "
              "revolutions. Runge-Kutta 4 reaches 17 mm with two substeps, Verlet 19 mm with 16. Explicit "
              "Euler flies apart.",
     .choose = "Runge-Kutta 4 with two substeps.",
     .order = 1.0,
     .why = "An orbit is only 3 m wide, so errors of that size cannot grow; below 0.1 m rounding "
            "accumulates over 200 s, which is why 64 substeps are no better than 16."},
    {.name = "incline",
     .number = 11,
     .title = "Sliding down a slope",
     .answer = "s = ½ g (sin θ - µ cos θ) t² for 3 s.",
     .shows = "Friction is accurate to a hundred-thousandth: the displacement is integrated as in free fall.",
     .choose = "Anything.",
     .why = "Below 0.001 % only rounding remains at all qualities."},
    {.name = "threshold",
     .number = 12,
     .title = "To slide or to stick",
     .answer = "A box sticks if and only if tan θ ≤ µ; error: the slope furthest from that limit with the "
               "wrong result.",
     .shows = "Twelve slopes within 5 % of the limit, the nearest by 0.1 %: every box behaves correctly at "
              "every quality.",
     .choose = "Anything.",
     .why = "There is no error at any quality, so nothing decreases."},
    {.name = "rolling",
     .number = 13,
     .title = "A disc that slides and then rolls",
     .answer = "It rolls with v = ⅔ v₀ from t = v₀ / (3µg) on.",
     .shows = "The change from sliding to rolling is found within a step: speed and path are "
              "right to thousandths of a percent.",
     .choose = "Anything.",
     .why = "Only rounding remains with one substep already."},
    {.name = "bounces",
     .number = 14,
     .title = "Ten bounces without loss",
     .answer = "A ball always returns to the same height; it must never gain.",
     .shows = "It returns to thousandths of a percent of its height at every quality; gains with many "
              "substeps are rounding. An engine that ignores the time of impact gains 3 % in ten bounces.",
     .choose = "Anything.",
     .why = "Only rounding remains with one substep already; each further substep rounds once more."},
    {.name = "bounces09",
     .number = 14,
     .title = "Ten bounces that keep 0.9 of the speed",
     .answer = "The nth height is 0.9²ⁿ of the first.",
     .shows =
         "The last bounces are a quarter of a meter high and take few steps. The time of impact within a "
         "step and the overlap make no difference: heights are accurate to thousandths of a percent.",
     .choose = "Anything.",
     .why = "Only rounding remains with one substep already; each further substep rounds once more."},
    {.name = "bounces05",
     .number = 14,
     .title = "Three bounces that keep half of the speed",
     .answer = "The nth height is 0.25ⁿ of the first.",
     .shows =
         "The third bounce is 31 mm high and lasts 9 steps, and is accurate to thousandths of a percent.",
     .choose = "Anything.",
     .why = "Only rounding remains with one substep already; each further substep rounds once more."},
    {.name = "collisions",
     .number = 15,
     .title = "Head-on collisions",
     .answer = "Momentum and energy determine both velocities, for mass ratios from 1 to 100.",
     .shows = "Velocities are accurate to a millionth of a percent. Momentum drifts by rounding alone, a few "
              "parts in ten million; with 16 substeps and more that is above the goal of a millionth.",
     .choose = "The default.",
     .why = "The method is exact; free bodies are rounded once in each substep, so more substeps are "
            "slightly worse."},
    {.name = "cradle",
     .number = 16,
     .title = "Newton's cradle of five",
     .answer = "One ball arrives, one ball leaves.",
     .shows =
         "The impact propagates through balls that touch: the last one leaves with the full velocity, at "
         "any quality. Engines that solve all contacts at once distribute it among them.",
     .choose = "The default.",
     .why = "Only rounding remains with one substep."},
    {.name = "oblique",
     .number = 17,
     .title = "Oblique impact of two discs",
     .answer = "The discs exchange their velocities along the line of centers and keep those across it.",
     .shows = "The direction at the time of impact is used, not that at the end of the step: velocities are "
              "accurate to a millionth, where other engines are wrong by 4 %.",
     .choose = "The default.",
     .why = "Only rounding remains with one substep."},
    {.name = "stack20",
     .number = 18,
     .title = "Stack of 20 crates",
     .answer = "The top stays at 19.5 m for 10 s; each level carries what is above it.",
     .shows = "A contact is a stiff spring, which a load compresses: 65 mm over 20 crates at the default. "
              "Each doubling of the substeps makes it four times stiffer, a straight line down. From two "
              "substeps on the forces are accurate to a hundredth of a percent.",
     .choose = "Quality 4 for high stacks, or automatic quality, which detects them.",
     .order = 2.0},
    {.name = "heavy100",
     .number = 19,
     .title = "A crate of 100 kg on two of 1 kg",
     .answer = "It stays at 2.5 m for 10 s.",
     .shows = "The heavy crate compresses the contacts of the light ones: 56 mm at the default, a quarter "
              "with each doubling. One substep cannot hold it.",
     .choose = "Automatic quality, or quality 5 for these bodies.",
     .order = 2.0},
    {.name = "heavy1000",
     .number = 19,
     .title = "A crate of 1000 kg on two of 1 kg",
     .answer = "It stays at 2.5 m for 10 s.",
     .shows =
         "At the default the light crates are pushed out and the heavy one falls. From 16 substeps on it "
         "stands, and sinks in by 34 mm, then by a quarter of that with each doubling.",
     .choose = "Automatic quality, or quality 5 for these bodies. Better: avoid such mass ratios.",
     .order = 2.0},
    {.name = "chain100",
     .number = 20,
     .title = "Chain of 20 with a ball of 100 links",
     .answer = "The ball hangs 10.5 m below the pin for 10 s.",
     .shows = "Joints that form a tree are solved all at once, so the chain is rigid at any quality: "
              "micrometers. Iteratively solved joints are wrong by decimeters.",
     .choose = "Leave direct joints on; any quality.",
     .order = 2.0,
     .why = "Second order down to 0.0003 mm, the rounding of positions within a link."},
    {.name = "chain1000",
     .number = 20,
     .title = "Chain of 20 with a ball of 1000 links",
     .answer = "The ball hangs 10.5 m below the pin for 10 s.",
     .shows = "Ten times the load stretches it ten times as far: 0.004 mm. Without direct joints, and "
              "in other engines, the chain tears or stretches by meters.",
     .choose = "Leave direct joints on; any quality.",
     .order = 2.0,
     .why = "Second order down to 0.0003 mm, which is rounding."},
    {.name = "catenary",
     .number = 21,
     .title = "Chain between two posts",
     .answer = "Equal rods hang where their forces balance, close to y = a cosh(x/a).",
     .shows = "Released as a V and slowed by drag, it comes to rest within hundredths of a millimeter of the "
              "exact polygon. The polygon of 40 rods differs from the smooth curve by 0.05 % of the sag.",
     .choose = "Leave direct joints on; any quality.",
     .order = 2.0,
     .why = "Two substeps have a quarter of the error of one; then it is below 1/100 of a millimeter, where "
            "rounding dominates."},
    {.name = "ladder",
     .number = 22,
     .title = "Leaning ladder",
     .answer =
         "It slips if cot α > 2µ + thickness / length; error: the one furthest from that limit with the "
         "wrong result.",
     .shows = "Twelve ladders within 10 % of the limit, the nearest by 0.2 %: all that should "
              "slip do, and no other, at every quality.",
     .choose = "Anything.",
     .why = "There is no error at any quality, so nothing decreases."},
    {.name = "stonearch",
     .number = 23,
     .title = "Semicircular arch of stones",
     .answer =
         "It stands if and only if thickness / radius > 0.1075; error: the one furthest from that limit "
         "with the wrong result.",
     .shows =
         "The hardest scene of all: at the limit the line of thrust touches the stones' edges in five "
         "places, where soft contacts yield. With 32 substeps arches 2 % above stand and 2 % below fall; "
         "with fewer, some that are 10 or 20 % thicker than they need to be come down.",
     .choose = "Quality 5 for arches near the limit; thicker stones otherwise.",
     .why = "Each of eight arches stands or falls, so the figure changes in jumps."},
    {.name = "bullet",
     .number = 24,
     .title = "Bullets at a thin wall",
     .answer =
         "At 10 to 1000 m/s none passes a wall of 1 cm; error: the time of a hit, from the later position.",
     .shows = "No bullet passes, whatever its speed, and each leaves the wall as after a bounce at the exact "
              "time: it continues for the rest of the step in which it hits.",
     .choose = "Any quality stops bullets, at the correct time.",
     .why = "Sweeps happen once per step, so substeps change nothing."},
});

}  // namespace

std::span<const SceneText> exactTexts() { return kExact; }

}  // namespace plumb::accuracy
