#include <array>

#include "tests/accuracy/report/scene_texts.hpp"

// Of the scenes with exact answers. What is said of figures is what ./plumb accuracy found.

namespace plumb::accuracy {

namespace {

constexpr auto kExact = std::to_array<SceneText>({
    {.name = "freefall",
     .number = 1,
     .title = "Free fall",
     .answer = "A ball has fallen ½ g t² after 2 s.",
     .shows = "Steady acceleration is summed exactly, so one substep is as good as 64: "
              "hundredths of a millimetre are left. Engines that multiply the new speed by the "
              "step fall too far, by 167 mm here.",
     .choose = "Anything; nothing is bought with substeps.",
     .why = "It does not fall with substeps, as there is no error of the method. What is "
            "left is the rounding of speeds to single precision, and each further substep "
            "rounds once more."},
    {.name = "projectile",
     .number = 2,
     .title = "Projectile",
     .answer = "A thrown ball is on its parabola after 2 s.",
     .shows = "As in free fall the path is exact at every quality, so a jump or a shot lands "
              "where the formula says.",
     .choose = "Anything; aim with the formula.",
     .why = "As in free fall: only rounding is left."},
    {.name = "drag",
     .number = 3,
     .title = "Throw with linear drag",
     .answer = "v(t) = v₀ e^(-kt) with gravity beside it, for 2 s.",
     .shows = "Drag is solved by its own formula in each substep, so it is exact as well. "
              "Engines that take it off step by step are 66 mm out.",
     .choose = "Anything.",
     .why = "It does not fall: there is no error of the method, and the rounding of the "
            "factor e^(-kh) adds up over more substeps."},
    {.name = "spring05",
     .number = 4,
     .title = "Spring of 0.5 Hz",
     .answer = "cos ωt; the largest distance from it in 10 s.",
     .shows = "A slow spring shows the four integrators as textbooks do. Runge-Kutta 4 is down "
              "to rounding at once, Verlet gains four times with each doubling, the two Euler "
              "schemes twice.",
     .choose = "Runge-Kutta 4, even with one substep.",
     .order = 1.0},
    {.name = "spring2",
     .number = 4,
     .title = "Spring of 2 Hz",
     .answer = "cos ωt; the largest distance from it in 10 s.",
     .shows = "Twenty swings: the default, semi-implicit Euler, lags by 40 mm and never loses "
              "its energy; Runge-Kutta 4 with the same four substeps is exact to a tenth of a "
              "micrometre. Explicit Euler gains energy with every swing, until the world's "
              "speed limit stops it.",
     .choose = "Runge-Kutta 4 where the motion has to be right; the default where it only has "
               "to look like a spring.",
     .order = 1.0,
     .why = "The default is above 1 at few substeps, where a lag in time, of second order, "
            "comes on top. What explicit Euler gains multiplies from swing to swing, so its "
            "error falls faster than a power as long as it is huge. Runge-Kutta 4 has two "
            "points above its floor."},
    {.name = "spring5",
     .number = 4,
     .title = "Spring of 5 Hz",
     .answer = "cos ωt; the largest distance from it in 10 s.",
     .shows = "With 12 steps a swing, one substep of Euler or Verlet keeps the energy but is "
              "out of time by half a swing. Runge-Kutta 4 is the best at every number of "
              "substeps, though with one it loses 15 % of the energy.",
     .choose = "Runge-Kutta 4 with two substeps or more.",
     .order = 1.0,
     .why = "An error of two metres is the other end of the swing and cannot grow; powers "
            "begin below that. The default still has its lag of second order on top at 16 "
            "substeps."},
    {.name = "spring10",
     .number = 4,
     .title = "Spring of 10 Hz",
     .answer = "cos ωt; the largest distance from it in 10 s.",
     .shows = "Six steps a swing are too few for any scheme with one substep: Runge-Kutta 4 "
              "loses all of the energy, semi-implicit Euler and Verlet keep swinging out of "
              "time, explicit Euler ends at the speed limit. From four substeps on Runge-Kutta "
              "4 is the best again.",
     .choose = "Quality 2 or more and Runge-Kutta 4; Verlet where substeps must be few, as it "
               "keeps the energy.",
     .order = 1.0,
     .why = "Up to 4 substeps all but Runge-Kutta 4 are out of time by half a swing, which "
            "is no error that a power describes; above that the default's lag of second "
            "order is the larger part of its error. Explicit Euler is held by the speed "
            "limit."},
    {.name = "underdamped",
     .number = 5,
     .title = "Damping of a tenth of critical",
     .answer = "Swings of 1 Hz that die away; the largest distance in 5 s.",
     .shows = "Damping forgives: what an integrator got wrong fades with the motion itself. "
              "The order is that of the undamped spring.",
     .choose = "The default; Runge-Kutta 4 where it has to be exact.",
     .order = 1.0},
    {.name = "critical",
     .number = 5,
     .title = "Critical damping",
     .answer = "Comes back as fast as it can without passing through; the largest distance in 5 "
               "s.",
     .shows = "The usual setting of cameras and doors. All integrators are stable here, and "
              "the error of the default halves with each doubling.",
     .choose = "The default.",
     .order = 1.0},
    {.name = "overdamped",
     .number = 5,
     .title = "Damping of three times critical",
     .answer = "Creeps back; the largest distance in 5 s.",
     .shows = "A stiff damper and a slow way back. No scheme gains energy; the default is off "
              "by 4 mm of a metre.",
     .choose = "The default.",
     .order = 1.0},
    {.name = "resonance",
     .number = 6,
     .title = "Driven at resonance",
     .answer = "It swings to F / (2ζk) once it has settled, after 40 s.",
     .shows = "How far a driven spring swings is right to hundredths of a percent, but with "
              "explicit Euler, which feeds it: 35 % too far at four substeps. The force is the "
              "one of each step's middle and holds for the step; the 0.05 % by which that is "
              "weaker than a smooth one is part of the exact answer.",
     .choose = "Anything; apply the force of the step's middle.",
     .order = 1.0,
     .why = "The first-order part of the error shifts when the swing turns and not how far "
            "it goes, so the width falls faster than that and soon meets rounding."},
    {.name = "pendulum",
     .number = 7,
     .title = "Pendulum, let go level",
     .answer = "It comes back to the same height for 10 s; the part of it that was lost.",
     .shows = "With joint trees the arm is solved exactly in each substep: the default loses "
              "0.004 % of its height. One by one, joints lose 0.9 %, and engines with whole "
              "steps lose half of the height.",
     .choose = "Leave direct joints on; quality 1 is enough.",
     .order = 2.0,
     .why = "The energy falls by 8 with each doubling, one order better than the scheme's "
            "second, until the rounding of single precision at 0.001 %."},
    {.name = "pendulum90",
     .number = 8,
     .title = "Pendulum at 90 degrees",
     .answer = "Its period is 4 K(sin θ/2) √(L/g).",
     .shows = "Clocks are easy: the default's period is right to 0.002 %.",
     .choose = "Leave direct joints on; any quality.",
     .order = 2.0,
     .why = "From 4 substeps on errors are below a thousandth of a percent, where rounding "
            "and the reading of the clock between two steps take part."},
    {.name = "pendulum170",
     .number = 8,
     .title = "Pendulum at 170 degrees",
     .answer = "Its period is 4 K(sin θ/2) √(L/g).",
     .shows = "It nearly stands still upside down, so what it lost on the way shows in its "
              "period: 4.6 % with one substep, 0.04 % with four. Engines that lose energy fall "
              "short by half.",
     .choose = "Quality 2 with direct joints.",
     .order = 2.0,
     .why = "As with the height of the pendulum let go level it falls by 8 to 10 with each "
            "doubling, one order better than the scheme's second."},
    {.name = "doublependulum",
     .number = 9,
     .title = "Double pendulum",
     .answer = "Where a solution with a step of 20 µs is after 2 s.",
     .shows = "Two discs on arms, let go level. The default is 0.2 mm off after 2 s and keeps "
              "its energy to a thousandth of a percent.",
     .choose = "Leave direct joints on; quality 2.",
     .order = 2.0,
     .why = "Second order down to 0.04 mm; from 8 substeps on rounding is larger, and chaos "
            "makes it grow."},
    {.name = "orbit",
     .number = 10,
     .title = "Two bodies around each other",
     .answer = "After 100 turns they are where they began.",
     .shows = "The default keeps the energy within a percent but is out of place by 0.8 m "
              "after 100 turns. Runge-Kutta 4 comes to 17 mm with two substeps, Verlet to 19 "
              "mm with 16. Explicit Euler flies apart.",
     .choose = "Runge-Kutta 4 with two substeps.",
     .order = 1.0,
     .why = "An orbit is only 3 m wide, so errors of that size cannot grow; below 0.1 m it "
            "is the rounding of 200 s, which is why 64 substeps are no better than 16."},
    {.name = "incline",
     .number = 11,
     .title = "Sliding down a slope",
     .answer = "s = ½ g (sin θ - µ cos θ) t² for 3 s.",
     .shows = "Friction is exact to a hundred-thousandth: the way is summed as in free fall.",
     .choose = "Anything.",
     .why = "Below 0.001 % it is rounding at all qualities."},
    {.name = "threshold",
     .number = 12,
     .title = "To slide or to stick",
     .answer = "A box sticks if and only if tan θ ≤ µ; the furthest slope from that limit that "
               "does the wrong thing.",
     .shows = "Twelve slopes within 5 % of the limit, the nearest by 0.1 %: every box does the "
              "right thing at every quality.",
     .choose = "Anything.",
     .why = "Nothing is wrong at any quality, so nothing falls."},
    {.name = "rolling",
     .number = 13,
     .title = "A disc that slides and then rolls",
     .answer = "It rolls with v = ⅔ v₀ from t = v₀ / (3µg) on.",
     .shows = "The change from sliding to rolling is found within a step: speed and way are "
              "right to thousandths of a percent.",
     .choose = "Anything.",
     .why = "At rounding with one substep already."},
    {.name = "bounces",
     .number = 14,
     .title = "Ten bounces without loss",
     .answer = "A ball comes back to the same height, always; it must never gain.",
     .shows = "It comes back to thousandths of a percent of its height at every quality; what it "
              "gains with many substeps is rounding. An engine without care for the time of the "
              "blow gains 3 % in ten bounces.",
     .choose = "Anything.",
     .why = "At rounding with one substep already; each substep more rounds once more."},
    {.name = "bounces09",
     .number = 14,
     .title = "Ten bounces that keep 0.9 of the speed",
     .answer = "The nth height is 0.9²ⁿ of the first.",
     .shows = "The last bounces are a quarter of a metre high and take few steps. Where in a step "
              "the blow falls, and how deep the ball is found, makes no difference: heights are "
              "right to thousandths of a percent.",
     .choose = "Anything.",
     .why = "At rounding with one substep already; each substep more rounds once more."},
    {.name = "bounces05",
     .number = 14,
     .title = "Three bounces that keep half of the speed",
     .answer = "The nth height is 0.25ⁿ of the first.",
     .shows = "The third bounce is 31 mm high and lasts 9 steps, and is right to thousandths of a "
              "percent.",
     .choose = "Anything.",
     .why = "At rounding with one substep already; each substep more rounds once more."},
    {.name = "collisions",
     .number = 15,
     .title = "Head-on collisions",
     .answer = "Momentum and energy give both speeds, for mass ratios from 1 to 100.",
     .shows = "Speeds are right to a millionth of a percent. Momentum drifts by rounding "
              "alone, a few parts in ten million; with 16 substeps and more that is above the "
              "mark of a millionth.",
     .choose = "The default.",
     .why = "The method makes no error; what moves freely is rounded once in each substep, "
            "so more of them are a little worse."},
    {.name = "cradle",
     .number = 16,
     .title = "Newton's cradle of five",
     .answer = "One ball comes, one ball leaves.",
     .shows = "The blow runs on through balls that touch: the last one leaves with all of the "
              "speed, at any quality. Engines that solve all contacts at once share it among "
              "them.",
     .choose = "The default.",
     .why = "At rounding with one substep."},
    {.name = "oblique",
     .number = 17,
     .title = "Oblique blow of two discs",
     .answer = "Speed along the line of centres changes hands, speed across it stays.",
     .shows = "The direction at the moment of the blow counts, not that at the end of the "
              "step: speeds are right to a millionth where engines without it are out by 4 %.",
     .choose = "The default.",
     .why = "At rounding with one substep."},
    {.name = "stack20",
     .number = 18,
     .title = "Stack of 20 crates",
     .answer = "The top stays at 19.5 m for 10 s; each level carries what is above it.",
     .shows = "A contact is a stiff spring, so what stands on it sinks in: 65 mm over 20 "
              "crates at the default. Each doubling of the substeps makes it four times "
              "stiffer, a straight line down. The forces are right to a hundredth of a percent "
              "from two substeps on.",
     .choose = "Quality 4 for high stacks, or automatic quality, which finds them.",
     .order = 2.0},
    {.name = "heavy100",
     .number = 19,
     .title = "A crate of 100 kg on two of 1 kg",
     .answer = "It stays at 2.5 m for 10 s.",
     .shows = "The heavy one presses the light ones flat by what their springs give: 56 mm at "
              "the default, a quarter with each doubling. One substep cannot hold it.",
     .choose = "Automatic quality, or quality 5 for these bodies.",
     .order = 2.0},
    {.name = "heavy1000",
     .number = 19,
     .title = "A crate of 1000 kg on two of 1 kg",
     .answer = "It stays at 2.5 m for 10 s.",
     .shows = "At the default the light ones are pushed out and the heavy one falls. From 16 "
              "substeps on it stands, and sinks in by 34 mm, then a quarter with each "
              "doubling.",
     .choose = "Automatic quality, or quality 5 for these bodies. Better: no such masses on "
               "each other.",
     .order = 2.0},
    {.name = "chain100",
     .number = 20,
     .title = "Chain of 20 with a ball of 100 links",
     .answer = "The ball hangs 10.5 m below the pin for 10 s.",
     .shows = "Joints that make up a tree are solved all at once, so the chain is rigid at any "
              "quality: micrometres. One by one, joints are off by decimetres.",
     .choose = "Leave direct joints on; any quality.",
     .order = 2.0,
     .why = "Second order down to 0.0003 mm, the rounding of places within a link."},
    {.name = "chain1000",
     .number = 20,
     .title = "Chain of 20 with a ball of 1000 links",
     .answer = "The ball hangs 10.5 m below the pin for 10 s.",
     .shows = "Ten times the load stretches it ten times as far: 0.004 mm at the default. "
              "Without trees, and in other engines, the chain tears or stretches by the metre.",
     .choose = "Leave direct joints on; any quality.",
     .order = 2.0,
     .why = "Second order down to 0.0003 mm, which is rounding."},
    {.name = "catenary",
     .number = 21,
     .title = "Chain between two posts",
     .answer = "Equal rods hang where their forces balance, close to y = a cosh(x/a).",
     .shows = "Let go as a V and slowed by the air, it comes to rest within hundredths of a "
              "millimetre of the exact polygon. That this is 0.05 % of the sag away from the "
              "smooth curve is what 40 rods are.",
     .choose = "Leave direct joints on; any quality.",
     .order = 2.0,
     .why = "A quarter from one substep to two; from there on it is below a hundredth of a "
            "millimetre, where rounding stops it from creeping further."},
    {.name = "ladder",
     .number = 22,
     .title = "Leaning ladder",
     .answer = "It slips if cot α > 2µ + thickness / length; the furthest from that limit that "
               "does the wrong thing.",
     .shows = "Twelve ladders within 10 % of the limit, the nearest by 0.2 %: all that should "
              "slip do, and no other, at every quality.",
     .choose = "Anything.",
     .why = "Nothing is wrong at any quality, so nothing falls."},
    {.name = "stonearch",
     .number = 23,
     .title = "Semicircular arch of stones",
     .answer = "It stands if and only if thickness / radius > 0.1075; the furthest from that "
               "limit that does the wrong thing.",
     .shows = "The hardest scene of all: at the limit the line of thrust touches the stones' "
              "edges in five places, and soft contacts give way there. With 32 substeps arches "
              "2 % above stand and 2 % below fall; with fewer, some that are 10 or 20 % "
              "thicker than they need to be come down.",
     .choose = "Quality 5 for arches near the limit; thicker stones otherwise.",
     .why = "It is a yes or a no for eight arches, so it comes in jumps."},
    {.name = "bullet",
     .number = 24,
     .title = "Bullets at a thin wall",
     .answer = "10 to 1000 m/s at a wall of 1 cm: none passes; when each hit, from where it is "
               "later.",
     .shows = "No bullet passes, whatever its speed, and each leaves the wall as after a bounce at the exact "
              "moment: it goes on for the rest of the step in which it hits.",
     .choose = "Any quality stops bullets, at the right moment.",
     .why = "Sweeps are made once a step, so substeps change nothing."},
});

}  // namespace

std::span<const SceneText> exactTexts() { return kExact; }

}  // namespace plumb::accuracy
