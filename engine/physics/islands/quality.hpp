#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

struct StepContext;
struct SubstepEstimate;
struct Workspace;

/// Divides the awake bodies into groups of islands that are solved with equal parameters: Workspace::groups,
/// and solveOrder unless there is only one group. An island takes the highest quality of its members and the
/// world; with Settings::tolerance, the one that its errors call for. An island in which nothing can rotate
/// is solved by reduced kernels, which give the same bits.
void sortByQuality(StepContext& step);

constexpr int substepsOf(Quality quality) { return 1 << quality; }

/// Automatic quality estimate: additional levels for an island with high mass ratios, stacks or many joints.
[[nodiscard]] int extraQuality(const SubstepEstimate& island);

/// Computes Workspace::estimate of the awake islands, by root. @pre findRoots() was called in this step
void estimateSubsteps(World& world, Workspace& work);

/// Computes Workspace::roots, once per step. Bodies that are not dynamic or are asleep are their own root.
/// @param exact  false: islands that fell apart may still count as one, and the world does not change
void findRoots(const StepContext& step, bool exact = true);

/// Determines the quality of each awake body where there is a tolerance, equal within an island:
/// Workspace::bodyScratch, by body. Measures contacts and joints at the start of the step, i.e. as the last
/// step left them. @pre Settings::tolerance is above 0, islands are up to date
void holdTolerance(World& world, Workspace& work);

/// Quality that a body and its joints ask for; kQualityOfWorld if they do not.
[[nodiscard]] Quality wishOf(const World& world, std::uint32_t body);

}  // namespace plumb::physics
