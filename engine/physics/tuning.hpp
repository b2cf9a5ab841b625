#pragma once

// Every chosen constant of the physics, its unit and its source. docs/tuning.md says what breaks at half and
// at double: ./plumb accuracy --tuning, whose build defines the macro so that it can change them.
#ifndef PLUMB_TUNING
#define PLUMB_TUNING(name, value, unit, derivation) inline constexpr auto name = value
#endif

namespace plumb::physics {

// clang-format off

// Rounding: a float has 24 bits.
PLUMB_TUNING(kRounding, 5.0e-7f, "ratio", "relative error of coordinates after a few operations: about four times the rounding error of one");
PLUMB_TUNING(kBlur, 1.0e-5f, "ratio", "relative error of corners transformed to another frame: closer points define no direction");
PLUMB_TUNING(kSimplexPrecision, 1.0e-6f, "ratio", "relative distance of a simplex from the origin, to its size, below which cores touch: "
             "about eight times the rounding error of one operation");
PLUMB_TUNING(kTouchDistance, 1.0e-5f, "m", "distance below which shapes touch: in casts, overlaps that are removed at once and, doubled, in "
             "sweeps. Not exact for coordinates above 100 m; a tenth of the minimum shape size");
PLUMB_TUNING(kAlong, 1.0e-3f, "ratio", "a displacement that approaches a surface by less than this part of its length counts as parallel to it");
PLUMB_TUNING(kMaxRounds, 64, "rounds", "maximum number of iterations, a safeguard: conservative advancement takes fewer except for grazing "
             "rotations, and propagating an impact takes n along a row of n bodies");
PLUMB_TUNING(kSlowDrag, 0.1f, "ratio", "drag * h below which formulas like 1 - exp(-x) lose digits, so their power series are used");

// Contact points.
PLUMB_TUNING(kFaceTie, 0.001f, "ratio to the half size", "advantage in separation that another reference face must have; otherwise normals "
             "alternate");
PLUMB_TUNING(kMaxFaceTie, 0.0005f, "m", "upper limit of kFaceTie times the half size: a tenth of the default slop");
PLUMB_TUNING(kParallel, 0.01f, "rad", "angle below which edges are parallel: a corner that extends so little beyond the end of a face stays "
             "with it (boxes of equal size keep both points, at its square, 0.01 %, of the distance), chains have no corner there, and "
             "outlines no sector between their borders");
PLUMB_TUNING(kSameNormal, 1.0e-6f, "1 - cosine", "difference below which normals are equal: 1.4e-3 rad, which lifts a body by 0.04 mm at 20 "
             "m/s");
PLUMB_TUNING(kFlush, 0.2f, "ratio to Settings::slop", "maximum size of gaps and steps between shapes that count as flush: 1 mm, less than resting bodies overlap");
PLUMB_TUNING(kMaxTurn, 0.03f, "rad", "maximum relative rotation at which contact points are reused; with 0.1 boxes that rock on balls gain energy and never "
             "rest");
PLUMB_TUNING(kMaxOfSize, 0.1f, "ratio to the half size", "upper limit of Settings::recycleDistance for small bodies");
PLUMB_TUNING(kOnePointPart, 0.05f, "ratio", "factor on the recycle distance if one point of two touches: a second one may be about to touch");
PLUMB_TUNING(kMinCosine, 0.95f, "cosine", "18 degrees: maximum rotation of a round shape's normal in half a step");
PLUMB_TUNING(kFadeRate, 4.74f, "1/s", "initial overlaps are hidden from the solver and shrink: decrease of the square root of one, in slops: a deceleration of 0.22 m/s2 at a "
             "slop of 5 mm, small compared to gravity; an overlap of 0.25 m opens within 1.5 s, at up to 0.34 m/s");

// Impacts.
PLUMB_TUNING(kSweptGap, 5.0e-5f, "m", "gap left between bodies at a hit: 5 us at 10 m/s; coordinates of 100 m are exact to a tenth of it");
PLUMB_TUNING(kSweptCore, 0.5f, "ratio to the outline", "size of the core that must not pass a surface; outlines may overlap it slightly");
PLUMB_TUNING(kLeastCore, 0.02f, "ratio to the outline", "minimum size of a core: if it touches at the start of a step, it is halved");
PLUMB_TUNING(kMaxImpacts, 5, "hits", "maximum number of hits of a body in a step before it stops: it leaves a corner of angle a after at "
             "most 1 + pi / a elastic hits, 45 degrees after 5");
PLUMB_TUNING(kWide, 1.0f, "rad", "rotation in a step above which the chord of a point's path is much shorter than its arc");
PLUMB_TUNING(kTwoPointTurns, 8, "iterations", "maximum number of iterations over two points of a contact, each of which converges by ((r - "
             "1) / (r + 1))^2, r = (m / I) a^2, as 1/4 for a long rod: 4^-8 is 1.5e-5 of the impact speed");
PLUMB_TUNING(kLively, 0.5f, "bounciness", "minimum bounciness for the propagation of impacts: crowds with less would sink");
PLUMB_TUNING(kMaxLoad, 0.1f, "ratio to the impulse", "maximum impulse before the impact with which a contact propagates the impact");
PLUMB_TUNING(kNoApproach, 1.0e-3f, "m/s", "minimum approach speed for the propagation of an impact");
PLUMB_TUNING(kRounded, 1.001f, "ratio", "rounding tolerance for the test that a body gained its velocity from its acceleration alone");
PLUMB_TUNING(kLivelyPart, 0.25f, "ratio to Settings::bounceSpeed", "speed above which bodies bounced; slower ones are pressed by a load");

// Joints.
PLUMB_TUNING(kJointPushing, 10.0f, "ratio to Settings::pushSpeed", "maximum speed at which joint errors close: without it a joint that a "
             "sweep tore open throws its bodies together; below 6 a cloth of 10,000 joints comes apart under its weight");
PLUMB_TUNING(kDefaultHertz, 5.0f, "1/s", "frequency of mouse and motor joints without one, critically damped: settles in 0.1 s");
PLUMB_TUNING(kMousePull, 1000.0f, "m/s2", "maximum acceleration by a mouse joint: 100 times the weight, so it also drags loads as heavy; "
             "contacts of quality 2 yield by 1.4 cm to it, and contacts of every quality hold it");
PLUMB_TUNING(kSteering, 1.0e-3f, "1/s", "rate at which the position error of a velocity motor closes: the displacement of a step then "
             "changes it by less than 2e-5 of itself");
PLUMB_TUNING(kTreeSoftness, 1.0e-6, "ratio to what the bodies yield", "compliance of joints in trees, so that redundant joints share the "
             "load");
PLUMB_TUNING(kDriveSoftness, 1.0e-9, "ratio to what the bodies yield", "compliance of motors and limits in trees: a motor has no position "
             "to which it returns, so with kTreeSoftness a brake creeps by 6 mrad/s under 1,000 kg on an arm of 10 m");
PLUMB_TUNING(kDriveTolerance, 1.0e-6, "m/s or rad/s", "velocity by which a motor or limit of a tree may miss its condition: above rounding, and "
             "0.1 mm in 100 s");
PLUMB_TUNING(kLimitSeam, 0.1f, "rad", "angle that limits of a hinge exclude at least: half of it is known to be beyond each limit, more than "
             "the SIMD solver lets motors overshoot (0.025 rad)");
PLUMB_TUNING(kCalm, 0.5, "ratio", "minimum inertia of a light body under tension, to its rotational stiffness * h^2: twice the 1/4 below "
             "which its oscillation grows (Stoermer-Verlet)");
PLUMB_TUNING(kTreeGain, 2.0e-3, "ratio to the energy", "maximum energy that joints of a tree may add in a substep: a hundred times that of "
             "regular motion; without it 2 of 1,600 ropes and linkages gain 4 to 6 %");

// Energy.
PLUMB_TUNING(kMemory, 2.0f, "s", "time within which energy that joints or an impact removed may be regained; the recent maximum, to which "
             "rounding is compared, decays in twice the time. A taut bridge throws within 0.25 s");
PLUMB_TUNING(kIslandGain, 0.005f, "ratio", "maximum total energy that the joints of an island may add, relative to the recent maximum of its energy");
PLUMB_TUNING(kContactGain, 1.0e-3f, "ratio to the energy", "maximum energy that contacts may add in a step");
PLUMB_TUNING(kCreeping, 0.006f, "ratio to Settings::pushSpeed", "speed below which motion keeps its energy: otherwise bodies that sag in "
             "their joints could not be lifted; with a larger value, a card house collapses under its weight");
PLUMB_TUNING(kWhipped, 0.5f, "ratio to the speed", "factor on velocities below which displacements are scaled too; they also are if they "
             "exceed 1 / this times those that the energy explains");
PLUMB_TUNING(kWild, 100.0f, "ratio to the energy", "energy above which an island is frozen for a step, relative to its recent maximum plus "
             "that of joints that close ten times as fast as allowed");

// Islands.
PLUMB_TUNING(kRebuildPart, 0.5f, "ratio to Settings::sleepTime", "time between rebuilds of islands, which visit every contact: the parts of "
             "a split island sleep late by at most this");
PLUMB_TUNING(kHeavyRatio, 10.0f, "ratio of masses", "mass ratio above which an island gets one more quality level: fitted for errors of mm");
PLUMB_TUNING(kHighStack, 7.0f, "layers", "height of a stack above which an island gets one more quality level");
PLUMB_TUNING(kHigherStack, 2.0f, "ratio", "further factor of mass ratio or height for each further quality level");
PLUMB_TUNING(kManyJoints, 8.0f, "joints", "number of joints outside of trees above which an island gets one more quality level");
PLUMB_TUNING(kManyMore, 4.0f, "ratio", "further factor of this number for each further quality level");
PLUMB_TUNING(kMinGain, 3.0f, "ratio", "factor by which a quality level reduces errors of stacked bodies");
PLUMB_TUNING(kMaxGain, 4.5f, "ratio", "factor by which a quality level reduces compliance, 4, and a little more");
PLUMB_TUNING(kRoom, 0.8f, "ratio to Settings::tolerance", "error that a quality should not exceed");
PLUMB_TUNING(kBlow, 0.05f, "s", "time in which the overlap of an impact decays without a higher quality");
PLUMB_TUNING(kClimb, 8.0f / 60.0f, "s", "time per level of an increase: if a stack of 16 boxes that overlap by 2 cm each is released at "
             "once, it hops by 1.7 m, with half of this time by 0.2 m");
PLUMB_TUNING(kSettling, 1.0f / 3.0f, "s", "time for overlapping bodies to separate");
PLUMB_TUNING(kWatch, 0.5f, "s", "time within the tolerance after which a lower quality is tried");
PLUMB_TUNING(kResignation, 4.0f, "s", "time after which a higher quality that did not help is tried again");
PLUMB_TUNING(kMaxPatience, 5, "doublings", "maximum doublings of kWatch and kResignation after failures: to 16 s and 128 s");
PLUMB_TUNING(kStillFalls, 0.9f, "ratio to an earlier error", "ratio below which the error still decreases: no higher quality is needed yet");
PLUMB_TUNING(kHelped, 0.6f, "ratio to the error before", "ratio below which a higher quality helped: each level divides the error by 3 to "
             "4.5");
PLUMB_TUNING(kGrew, 1.5f, "ratio to the error before", "ratio above which the load has grown");
PLUMB_TUNING(kVanished, 0.02f, "ratio to the error before", "ratio below which most of the load has been removed, so that earlier failures no longer count");

// Fields, one-way shapes, soft bodies.
PLUMB_TUNING(kOnTop, 4.0f, "ratio to Settings::slop", "overlap at which a body still lies on a platform: more than at rest");
PLUMB_TUNING(kSolidSide, 0.7f, "cosine", "45 degrees: maximum angle of a solid side to the open direction, and of a ceiling");
PLUMB_TUNING(kRousing, 0.5f, "m/s", "minimum speed at which a particle wakes a sleeping body that it hits");
PLUMB_TUNING(kSoftSlack, 0.01f, "m", "distance by which particles may move further in a step than their initial velocity predicts");
PLUMB_TUNING(kGivenWay, 1.0f / 16.0f, "ratio to a link", "maximum displacement of particles by a load in a substep, or of a body "
             "by a soft body on it: links carry the load when they are shorter by about as much");
PLUMB_TUNING(kBearing, 0.25f, "ratio", "fraction of the particles that carry a load: about one side");

// Characters.
PLUMB_TUNING(kTakeOff, 1.0e-3f, "m/s", "upward speed above which a character leaves the ground");
PLUMB_TUNING(kSlopeSlack, 5.0e-4f, "cosine", "tolerance of the maximum slope: 0.04 degrees at 50 degrees");
PLUMB_TUNING(kAxisAligned, 0.1f, "cosine", "maximum deviation of a wall from the vertical; others are slopes");
PLUMB_TUNING(kRoundCorner, 0.5f, "cosine", "60 degrees: maximum angle of a normal at a corner on which a round outline can stand");
PLUMB_TUNING(kRoundReach, 0.14f, "ratio to the radius", "overlap with a corner that is necessary to stand on it: 1 - the cosine of 30 "
             "degrees");
PLUMB_TUNING(kFastestSeen, 60.0f, "m/s", "maximum speed of kinematic bodies that are tested at their poses after the next step");
PLUMB_TUNING(kMoverTurns, 6, "turns", "maximum number of changes of direction in a tick: a corner of three surfaces takes 3");
PLUMB_TUNING(kCornerTries, 16, "tries", "number of positions that are tried to pass a corner");
PLUMB_TUNING(kMaxPieces, 8.0f, "pieces", "maximum number of pieces of a displacement on the ground in a tick");

// clang-format on

}  // namespace plumb::physics
