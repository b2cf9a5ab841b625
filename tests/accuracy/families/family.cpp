#include "tests/accuracy/families/family.hpp"

#include <algorithm>
#include <array>

#include "core/hash.hpp"

namespace plumb::families {

namespace {

constexpr auto kFamilies = std::to_array<Family>({
    {"bullets",
     "1 to 3 rooms with walls of 5 to 50 cm; bullets of 10 to 300 m/s hit walls, rotating plates and "
     "crates: everything stays in its room",
     makeBullets},
    {"card-house",
     "2 to 6 levels of cards that lean on each other, friction 0.4 to 0.9, lean 0.2 to 0.35 rad, "
     "feet 0 to 12 cm apart, cards 2 to 6 cm thick, statically stable: it stands for 30 s",
     makeCardHouse, 0.02},
    {"churn",
     "a closed pit in which up to 40 bodies are created, destroyed, teleported, pushed and change "
     "their mass, with pauses to sleep: nothing leaves it",
     makeChurn},
    {"closing-box",
     "50 to 150 balls and boxes asleep in a box whose kinematic walls then close at 0.02 to 5 m/s, "
     "until the bodies fill three quarters of it: nothing gets out",
     makeClosingBox},
    {"domino-run",
     "8 to 30 dominoes of 0.2 to 2 m, 1/17 to 1/5 as thick, close enough that each tips the next, "
     "friction 0.1 to 0.4 with each other, the first one pushed with 2 to 4 times the necessary "
     "speed: all fall, in order",
     makeDominoRun},
    {"driven-chain",
     "arms of 2 to 6 rods; each hinge has limits and a motor of 3 to 30 times the static torque; "
     "some have a telescopic boom, fingers, and a load of 1 to 50 rods, held or on a rope: each "
     "joint ends at the limit that its motor drives it to",
     makeDrivenChain},
    {"driven-linkage",
     "four-bar linkages, parallelograms, slider-cranks and scissors of random lengths and masses, "
     "driven at 0.5 to 8 rad/s: the crank follows its motor to 1 %",
     makeDrivenLinkage, 0.05},
    {"free-linkage",
     "four-bar linkages, parallelograms, Jansen legs, pendulums of 2 to 5 rods, pantographs and "
     "scissors that swing under gravity, densities that differ by up to 10: joints hold, and without "
     "limits at most a tenth of the energy is lost in 8 s",
     makeFreeLinkage},
    {"masonry-arch",
     "7 to 25 stones in a circular or catenary arch that spans 6 to 24 m, 1.15 to 2 times the "
     "minimum thickness, with up to 0.3 of its weight on the keystone, friction 0.5 to 1: it stands "
     "for 10 s",
     makeMasonryArch, 0.05},
    {"mixed-pile",
     "15 to 36 balls, boxes and polygons in a pit, sizes that differ by up to 20, as thin as 1/20, "
     "densities that differ by up to 10, friction 0.2 to 0.9: they stay in it, rest after 12 s, and "
     "overlap by at most 1 cm",
     makeMixedPile},
    {"ragdoll-stairs",
     "1 to 3 ragdolls of 1 to 2.4 m that fall on 5 to 12 steps of 0.2 to 0.7 m with up to 10 rad/s, "
     "friction 0.3 to 0.9, hinges with friction and limits: their joints hold, they stay above the "
     "stairs, and rest after 12 s",
     makeRagdollStairs},
    {"rope-bridge",
     "8 to 24 links or a net of 2 to 4 rows with slack between two banks, under loads of 1 to 100 "
     "links that drop, hang or drive over it: joints hold, nothing falls through, carts cross, and "
     "bodies with drag come to rest",
     makeRopeBridge},
    {"vehicle-terrain",
     "a car of 5 to 500 kg on springs, wheels of 0.3 to 0.6 m with 3 to 20 % of its mass, on terrain "
     "of lines of 0.5 to 2 m with slopes up to 0.3, as a chain or as segments: it moves at 0.6 of "
     "its wheels' speed or more, stays on the ground and upright",
     makeVehicleTerrain},
    {"elastic-gas",
     "4 to 49 discs and boxes of random sizes and 4 to 40 m/s that bounce without loss and without "
     "gravity, in a box or free: energy is conserved, and momentum too if free",
     makeElasticGas},
    {"fields",
     "planets with landers and moons, water with boxes of 0.1 to 8 times its density, linear "
     "attractors: all positions follow the formulas",
     makeFields},
    {"kinematic-traffic",
     "lifts with crates, sweepers, rotors and pistons of 0.01 to 20 m/s that hit sleeping and awake "
     "bodies: carried bodies stay on, swept ones are pushed",
     makeKinematicTraffic},
    {"one-way-belt",
     "crates on belts of 0.2 to 10 m/s, and jumps through one-way platforms: speeds follow the "
     "friction formula, and every body is on the correct side",
     makeOneWayBelt},
    {"pyramid",
     "pyramids of 4 to 20 rows of bricks with gaps of up to 30 % of their width, densities that differ by up "
     "to 2: it stands and falls asleep",
     makePyramid},
    {"ratio-stack",
     "stacks of 3 to 20 boxes with mass ratios up to 1:200, different sizes and offsets, statically "
     "stable: it stands and falls asleep",
     makeRatioStack, 0.1},
    {"seam-slide",
     "a box, ball, pentagon or capsule of 0.04 to 2 m that slides or rolls at 0.5 to 20 m/s over "
     "adjacent boxes: the same speed as on a single floor, and no hops",
     makeSeamSlide},
    {"soft-among-rigid",
     "jellies, ropes and cloths of 1/100 to 100 times the mass of the crates and balls that fall on "
     "them: everything comes to rest, nothing passes through, no energy is gained",
     makeSoftAmongRigid},
    {"tumbler",
     "drums of 4 to 12 sides that rotate at 0.2 to 6 rad/s, kinematic or by a motor, up to 45 % "
     "full: nothing gets out",
     makeTumbler},
});

}  // namespace

std::span<const Family> allFamilies() { return kFamilies; }

const Family* findFamily(std::string_view name) {
    const auto found = std::find_if(kFamilies.begin(), kFamilies.end(),
                                    [name](const Family& family) { return family.name == name; });
    return found == kFamilies.end() ? nullptr : &*found;
}

Blueprint memberOf(const Family& family, std::uint64_t seed) {
    Hasher mixed;
    mixed.add(family.name);
    mixed.add(seed);
    Random random = Random::seeded(mixed.value());
    return family.make(random);
}

}  // namespace plumb::families
