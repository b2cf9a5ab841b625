#pragma once

#include "physics/world.hpp"

namespace plumb::physics {

struct StepContext;
struct SubstepEstimate;
struct Workspace;

/// Divides the awake bodies into groups of islands that are solved with equal parameters: Workspace::groups,
/// and solveOrder unless there is only one group. An island takes the highest quality of its bodies
/// and joints and the world; with Settings::tolerance, the quality that its errors require. An island in
/// which no body can rotate is solved by reduced kernels, which give the same bits.
void sortByQuality(StepContext& step);

constexpr int substepsOf(Quality quality) { return 1 << quality; }

/// Returns the additional quality levels for an island with high mass ratios, high stacks or many joints.
[[nodiscard]] int extraQuality(const SubstepEstimate& island);

/// Computes Workspace::estimate for the awake islands, by root. @pre findRoots() was called in this step
void estimateSubsteps(World& world, Workspace& work);

/// Computes Workspace::roots, once per step. A body that is asleep or not dynamic is its own root.
/// @param exact  false: does not change the world; parts of a split island may have the same root
void findRoots(const StepContext& step, bool exact = true);

/// Determines the quality of each awake body if there is a tolerance, equal within an island: stored in
/// Workspace::bodyScratch, by body. Measures the errors that the last step left in contacts and joints. @pre
/// Settings::tolerance is above 0, islands are up to date
void holdTolerance(World& world, Workspace& work);

/// Returns the maximum quality set for a body and its joints; kQualityOfWorld if none is set.
[[nodiscard]] Quality requestedQualityOf(const World& world, std::uint32_t body);

}  // namespace plumb::physics
