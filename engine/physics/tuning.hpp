#pragma once

// Every chosen constant of the physics, its unit and its source. docs/tuning.md says what breaks at half and
// at double: ./plumb accuracy --tuning, whose build defines the macro so that it can change them.
#ifndef PLUMB_TUNING
#define PLUMB_TUNING(name, value, unit, derivation) inline constexpr auto name = value
#endif

namespace plumb::physics {

// clang-format off

// Rounding: a float has 24 bits.
PLUMB_TUNING(kRounding, 5.0e-7f, "ratio", "relative error of coordinates after a few operations: four times the last bit of the largest");
PLUMB_TUNING(kBlur, 1.0e-5f, "ratio", "of corners in each other's frames, to coordinates or size: closer points define no direction");
PLUMB_TUNING(kSimplexPrecision, 1.0e-6f, "ratio", "to the size of a simplex: closer cores touch; eight times the last bit");
PLUMB_TUNING(kTouchDistance, 1.0e-5f, "m", "closer shapes touch: for casts, overlaps that are removed at once and, doubled, sweeps. Below it "
             "coordinates of 100 m are not exact; a tenth of the smallest shape");
PLUMB_TUNING(kAlong, 1.0e-3f, "ratio", "a displacement that approaches a surface by less than this part of its length is parallel to it");
PLUMB_TUNING(kMaxRounds, 64, "rounds", "safeguard: conservative advancement takes fewer except for grazing rotations, and propagating an "
             "impact takes n along a row of n bodies");
PLUMB_TUNING(kSlowDrag, 0.1f, "ratio", "drag * h below which series are accurate to the last bit, and differences are not");

// Contact points.
PLUMB_TUNING(kFaceTie, 0.001f, "ratio to the half size", "advantage that another reference face needs; otherwise normals flicker between "
             "parallel faces");
PLUMB_TUNING(kMaxFaceTie, 0.0005f, "m", "upper limit of kFaceTie times the half size: a tenth of the default slop");
PLUMB_TUNING(kParallel, 0.01f, "rad", "edges at a smaller angle are parallel: a corner that extends so little beyond the end of a face stays "
             "with it (boxes of equal size keep both points, at its square, 0.01 %, of the distance), chains have no corner there, and "
             "outlines no sector between their borders");
PLUMB_TUNING(kSameNormal, 1.0e-6f, "1 - cosine", "1.4e-3 rad, which lifts a body at a seam by 0.04 mm at 20 m/s");
PLUMB_TUNING(kFlush, 0.2f, "ratio to Settings::slop", "shapes with smaller gaps and steps are flush: 1 mm, below any overlap");
PLUMB_TUNING(kMaxTurn, 0.03f, "rad", "maximum rotation with reused points; with 0.1 outdated normals feed energy to boxes that rock on balls, "
             "and they never rest");
PLUMB_TUNING(kMaxOfSize, 0.1f, "ratio to the half size", "upper limit of Settings::recycleDistance for small bodies");
PLUMB_TUNING(kOnePointPart, 0.05f, "ratio", "of the recycle distance where one point of two touches: a second one may be about to");
PLUMB_TUNING(kMinCosine, 0.95f, "cosine", "18 degrees: a round shape whose normal turns by more in half a step touches elsewhere");
PLUMB_TUNING(kFadeRate, 4.74f, "1/s", "rate at which the square root of a hidden initial overlap falls, in slops: a deceleration of 0.22 m/s2 "
             "at a slop of 5 mm, gentle beside gravity; an overlap of 0.25 m opens within 1.5 s, at up to 0.34 m/s");

// Impacts.
PLUMB_TUNING(kSweptGap, 5.0e-5f, "m", "gap left between bodies at a hit: 5 us at 10 m/s; coordinates of 100 m are exact to a tenth of it");
PLUMB_TUNING(kSweptCore, 0.5f, "ratio to the outline", "that may not pass a surface: a sliding body dips into the floor and its next piece");
PLUMB_TUNING(kLeastCore, 0.02f, "ratio to the outline", "a core that touches at the start of the step is halved, down to this");
PLUMB_TUNING(kMaxImpacts, 5, "hits", "of a body in a step before it stops: it leaves a corner of angle a after at most 1 + pi / a "
             "elastic ones, 45 degrees after 5");
PLUMB_TUNING(kWide, 1.0f, "rad", "the chord of a larger rotation is much shorter than its arc");
PLUMB_TUNING(kTwoPointTurns, 8, "iterations", "over two points of a contact, each of which converges by ((r - 1) / (r + 1))^2, "
             "r = (m / I) a^2, as 1/4 for a long rod: 4^-8 is 1.5e-5 of the impact speed");
PLUMB_TUNING(kLively, 0.5f, "bounciness", "crowds with less bounce would absorb impacts that are propagated, and sink");
PLUMB_TUNING(kMaxLoad, 0.1f, "ratio to the impulse", "a contact with a larger load before the impact propagates no impact");
PLUMB_TUNING(kNoApproach, 1.0e-3f, "m/s", "slower approaches are not propagated");
PLUMB_TUNING(kRounded, 1.001f, "ratio", "a free body gains all that its acceleration gives, and this factor by rounding");
PLUMB_TUNING(kLivelyPart, 0.25f, "ratio to Settings::bounceSpeed", "bodies that bounced leave faster; slower ones are pressed");

// Joints.
PLUMB_TUNING(kJointPushing, 10.0f, "ratio to Settings::pushSpeed", "maximum speed at which joint errors close: without it a joint that a "
             "sweep tore open hurls its bodies together; below 6 a cloth of 10,000 joints comes apart under its weight");
PLUMB_TUNING(kDefaultHertz, 5.0f, "1/s", "critically damped, for mouse and motor joints without a frequency: settles in 0.1 s");
PLUMB_TUNING(kMousePull, 1000.0f, "m/s2", "maximum of a mouse joint: 100 times the weight, so it also drags loads as heavy; contacts of "
             "quality 2 give way by 1.4 cm to it, and contacts of every quality hold it");
PLUMB_TUNING(kSteering, 1.0e-3f, "1/s", "rate at which the error of a velocity motor closes: the displacement of a step then changes it by "
             "less than 2e-5 of itself");
PLUMB_TUNING(kTreeSoftness, 1.0e-6, "ratio to what the bodies yield", "joints that cannot all be satisfied share the load");
PLUMB_TUNING(kCalm, 0.5, "ratio", "minimum inertia of a light body under tension, to straining * h^2: twice the 1/4 below which its "
             "oscillation grows (Stoermer-Verlet)");
PLUMB_TUNING(kSoftRate, 0.28, "ratio", "of a gap that no smooth motion causes, closed in a substep");
PLUMB_TUNING(kClosed, 1.0e-3, "ratio to the arms", "gap left by the SIMD solver that counts as closed");
PLUMB_TUNING(kClosedWhereHeld, 2.5e-6, "ratio to the arms", "the same for a tree held at both ends: on a taut bridge slightly less length "
             "means much less sag, which throws what lies on it");
PLUMB_TUNING(kTreeGain, 2.0e-3, "ratio to the energy", "that joints of a tree may seem to add in a substep: a hundred times that of "
             "regular motion; without it 2 of 1,600 ropes and linkages gain 4 to 6 %");

// Energy.
PLUMB_TUNING(kMemory, 2.0f, "s", "time within which energy that joints or an impact took may come back; the recent maximum, to which rounding "
             "is compared, decays in twice the time. A taut bridge takes 0.25 s to throw");
PLUMB_TUNING(kIslandGain, 0.005f, "ratio", "to the recent maximum: total energy that joints may add");
PLUMB_TUNING(kContactGain, 1.0e-3f, "ratio to the energy", "that contacts may seem to add in a step");
PLUMB_TUNING(kCreeping, 0.006f, "ratio to Settings::pushSpeed", "slower motion keeps its energy: otherwise bodies that sag in their joints "
             "could not be lifted; with more, the weight of a card house throws it");
PLUMB_TUNING(kWhipped, 0.5f, "ratio to the speed", "if velocities are scaled below this ratio, displacements are scaled too, and so are "
             "displacements above 1 / this times those that the energy explains");
PLUMB_TUNING(kWild, 100.0f, "ratio to the energy", "of the recent maximum plus that of joints that close ten times as fast as allowed: an "
             "island with more is frozen for a step");

// Islands.
PLUMB_TUNING(kRebuildPart, 0.5f, "ratio to Settings::sleepTime", "between rebuilds, which visit every contact: an island that fell apart "
             "sleeps late by at most this");
PLUMB_TUNING(kHeavyRatio, 10.0f, "ratio of masses", "requires one more quality level: fitted to keep hard cases within mm");
PLUMB_TUNING(kHighStack, 7.0f, "layers", "the same");
PLUMB_TUNING(kHigherStack, 2.0f, "ratio", "each further factor of this requires one more level");
PLUMB_TUNING(kManyJoints, 8.0f, "joints", "the same for joints that form no tree");
PLUMB_TUNING(kManyMore, 4.0f, "ratio", "the same");
PLUMB_TUNING(kMinGain, 3.0f, "ratio", "by which a quality level reduces errors of stacked bodies");
PLUMB_TUNING(kMaxGain, 4.5f, "ratio", "by which it reduces compliance, 4, and a little more");
PLUMB_TUNING(kRoom, 0.8f, "ratio to Settings::tolerance", "error that a quality should reach");
PLUMB_TUNING(kBlow, 0.05f, "s", "time in which the overlap of an impact decays by itself");
PLUMB_TUNING(kClimb, 8.0f / 60.0f, "s", "per level of a rise: if a stack of 16 boxes that are 2 cm deep in each other is released at once, it "
             "hops by 1.7 m, with half of this time by 0.2 m");
PLUMB_TUNING(kSettling, 1.0f / 3.0f, "s", "time for overlapping bodies to separate");
PLUMB_TUNING(kWatch, 0.5f, "s", "of calm after which a lower quality is tried");
PLUMB_TUNING(kResignation, 4.0f, "s", "after which a rise that did not help is tried again");
PLUMB_TUNING(kMaxPatience, 5, "doublings", "of both times after failures: a quarter of a minute, and two minutes");
PLUMB_TUNING(kStillFalls, 0.9f, "ratio to an earlier error", "the error still decreases: no higher quality needed yet");
PLUMB_TUNING(kHelped, 0.6f, "ratio to the error before", "a rise of the quality helped: each level makes the error 3 to 4.5 times smaller");
PLUMB_TUNING(kGrew, 1.5f, "ratio to the error before", "the load has grown");
PLUMB_TUNING(kVanished, 0.02f, "ratio to the error before", "most of the load is gone");

// Fields, one-way shapes, soft bodies.
PLUMB_TUNING(kOnTop, 4.0f, "ratio to Settings::slop", "overlap with which a body still lies on a platform: more than at rest");
PLUMB_TUNING(kSolidSide, 0.7f, "cosine", "45 degrees: a side further from the open direction is not solid, nor is one a ceiling");
PLUMB_TUNING(kRousing, 0.5f, "m/s", "a particle that hits a sleeping body faster wakes it");
PLUMB_TUNING(kSoftSlack, 0.01f, "m", "by which particles may move further in a step than their initial velocity predicts");
PLUMB_TUNING(kGivenWay, 1.0f / 16.0f, "ratio to a link", "by which a load may move particles in a substep: links carry it when they are "
             "shorter by about as much");
PLUMB_TUNING(kBearing, 0.25f, "ratio", "of particles that carry a load: about one side");

// Characters.
PLUMB_TUNING(kTakeOff, 1.0e-3f, "m/s", "a larger upward speed leaves the ground");
PLUMB_TUNING(kSlopeSlack, 5.0e-4f, "cosine", "0.04 degrees at 50 degrees: the steepest slope still counts as ground");
PLUMB_TUNING(kAxisAligned, 0.1f, "cosine", "less steep is a slope, not a wall");
PLUMB_TUNING(kRoundCorner, 0.5f, "cosine", "60 degrees: a round outline stands on corners with normals up to this angle");
PLUMB_TUNING(kRoundReach, 0.14f, "ratio to the radius", "by which it has to overlap them: 1 - the cosine of 30 degrees");
PLUMB_TUNING(kFastestSeen, 60.0f, "m/s", "kinematic bodies up to this speed are found where the next step takes them");
PLUMB_TUNING(kMoverTurns, 6, "turns", "of a displacement in a tick: a corner of three surfaces takes 3");
PLUMB_TUNING(kCornerTries, 16, "tries", "to pass a corner");
PLUMB_TUNING(kMaxPieces, 8.0f, "pieces", "of a displacement on the ground in a tick");

// clang-format on

}  // namespace plumb::physics
