#pragma once

#include <span>
#include <string_view>

#include "core/random.hpp"
#include "tests/accuracy/families/blueprint.hpp"

namespace plumb::families {

/// A kind of random scenes (members) with parameters drawn from a seed. A family covers typical scenes, not
/// only those known to work; physically impossible scenes are excluded.
struct Family {
    std::string_view name;
    std::string_view what;                        ///< parameters with their ranges, and the goal
    Blueprint (*make)(Random& random) = nullptr;  ///< creates a member
    /// Maximum distance between the final positions of a body in two simulations of a member with different
    /// settings, m. 0: motion is chaotic, so only the numbers of members that reach their goals are compared.
    double tolerance = 0.0;
};

/// All families, in alphabetical order of their files.
std::span<const Family> allFamilies();
const Family* findFamily(std::string_view name);
/// Creates a member of a family. The same seed gives the same scene on every machine.
Blueprint memberOf(const Family& family, std::uint64_t seed);

// One function per family, in families/kinds/<name>.cpp.
Blueprint makeBullets(Random& random);
Blueprint makeCardHouse(Random& random);
Blueprint makeChurn(Random& random);
Blueprint makeClosingBox(Random& random);
Blueprint makeDominoRun(Random& random);
Blueprint makeDrivenChain(Random& random);
Blueprint makeDrivenLinkage(Random& random);
Blueprint makeFreeLinkage(Random& random);
Blueprint makeMasonryArch(Random& random);
Blueprint makeMixedPile(Random& random);
Blueprint makeRagdollStairs(Random& random);
Blueprint makeRopeBridge(Random& random);
Blueprint makeVehicleTerrain(Random& random);
Blueprint makeElasticGas(Random& random);
Blueprint makeFields(Random& random);
Blueprint makeKinematicTraffic(Random& random);
Blueprint makeOneWayBelt(Random& random);
Blueprint makePyramid(Random& random);
Blueprint makeRatioStack(Random& random);
Blueprint makeSeamSlide(Random& random);
Blueprint makeSoftAmongRigid(Random& random);
Blueprint makeTumbler(Random& random);

}  // namespace plumb::families
