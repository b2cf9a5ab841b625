#include "tests/accuracy/families/family.hpp"

#include <algorithm>
#include <array>

#include "core/hash.hpp"

namespace plumb::families {

namespace {

constexpr auto kFamilies = std::to_array<Family>({
    {"bullets",
     "1 to 3 rooms with walls of 5 to 50 cm in which bullets of 10 to 300 m/s are fired at walls, turning "
     "plates and crates: all stays in its room",
     makeBullets},
    {"card-house",
     "2 to 6 levels of cards that lean at each other, friction 0.4 to 0.9, lean 0.2 to 0.35 rad, feet 0 to "
     "12 cm apart, cards 2 to 6 cm thick, only those that statics lets stand: it stands for 30 s",
     makeCardHouse, 0.02},
    {"churn",
     "a closed pit in which up to 40 bodies come, go, jump elsewhere, change their mass and are pushed, with "
     "pauses to sleep: nothing leaves it",
     makeChurn},
    {"closing-box",
     "50 to 150 balls and boxes that fell asleep in a box whose kinematic walls then close at 0.02 to 5 m/s, "
     "until the crowd fills three quarters of it: nothing gets out",
     makeClosingBox},
    {"domino-run",
     "8 to 30 dominoes of 0.2 to 2 m, a 17th to a 5th as thick, so far apart that one that leans tips the "
     "next, friction 0.1 to 0.4 on each other, the first pushed with 2 to 4 times the speed it takes: all "
     "fall, in their order",
     makeDominoRun},
    {"driven-chain",
     "arms of 2 to 6 rods with a motor of 3 to 30 times what statics asks for and limits at each hinge, "
     "perhaps a boom that slides out, fingers, and a load of 1 to 50 times a rod, held or on a rope: each "
     "joint ends at the limit that it is driven to",
     makeDrivenChain},
    {"driven-linkage",
     "four-bars, parallelograms, slider-cranks and scissors of random lengths and masses, driven at 0.5 to 8 "
     "rad/s: the crank turns as driven, to 1 %",
     makeDrivenLinkage, 0.05},
    {"free-linkage",
     "four-bars, parallelograms, Jansen's legs, pendulums of 2 to 5 rods, pantographs and scissors that "
     "swing under gravity, rods of densities that differ by up to 10: joints keep, and without limits a "
     "tenth of the energy is lost at most in 8 s",
     makeFreeLinkage},
    {"masonry-arch",
     "7 to 25 stones in an arc of a circle or a catenary that spans 6 to 24 m, 1.15 to 2 times as thick as "
     "it has to be, with up to 0.3 of its weight on the keystone, friction 0.5 to 1: it stands for 10 s",
     makeMasonryArch, 0.05},
    {"mixed-pile",
     "15 to 36 balls, boxes and polygons of sizes that differ by up to 20, as thin as a 20th, densities that "
     "differ by up to 10, friction 0.2 to 0.9, in a pit: they stay in it, rest after 12 s, and overlap by 1 "
     "cm at most",
     makeMixedPile},
    {"ragdoll-stairs",
     "1 to 3 figures of 1 to 2.4 m that fall on 5 to 12 steps of 0.2 to 0.7 m with up to 10 rad/s, friction "
     "0.3 to 0.9, hinges with friction and limits: they keep their joints, stay above the stairs, and rest "
     "after 12 s",
     makeRagdollStairs},
    {"rope-bridge",
     "8 to 24 links or a net of 2 to 4 rows hung with slack between two banks, under loads of 1 to 100 times "
     "a link that drop, hang or drive over: joints keep, nothing falls through, carts cross, what drag slows "
     "rests",
     makeRopeBridge},
    {"vehicle-terrain",
     "a sprung car of 5 to 500 kg, wheels of 0.3 to 0.6 m and 3 to 20 % of its mass, driven over lines of "
     "0.5 to 2 m with slopes up to 0.3, as a chain or as segments: it gets along at 0.6 of its wheels' "
     "speed, stays on the ground and upright",
     makeVehicleTerrain},
    {"elastic-gas",
     "4 to 49 discs and boxes of random sizes and 4 to 40 m/s that bounce without loss in no gravity, in a "
     "box or free: energy, and free momentum too, stay",
     makeElasticGas},
    {"fields",
     "planets with landers and moons, water with boxes of 0.1 to 8 times its density, linear pulls: all is "
     "where the formula says",
     makeFields},
    {"kinematic-traffic",
     "lifts with crates, sweepers, rotors and pistons of 0.01 to 20 m/s that meet bodies asleep and awake: "
     "what is carried stays on, what is swept is pushed",
     makeKinematicTraffic},
    {"one-way-belt",
     "goods on belts of 0.2 to 10 m/s, and jumps through platforms that hold from above: speeds by the "
     "formula of friction, and all on its side",
     makeOneWayBelt},
    {"ratio-stack",
     "stacks of 3 to 20 boxes with mass ratios to 1:200, unlike sizes and offsets that statics lets stand: "
     "it stands and sleeps",
     makeRatioStack, 0.1},
    {"seam-slide",
     "a box, ball, pentagon or capsule of 0.04 to 2 m that slides or rolls at 0.5 to 20 m/s over separate "
     "boxes laid flush: the speed of a single floor, and no hop",
     makeSeamSlide},
    {"soft-among-rigid",
     "jellies, ropes and cloths of 1/100 to 100 times the mass of the crates and balls that fall on them: "
     "all rests, nothing is passed through, no energy is gained",
     makeSoftAmongRigid},
    {"tumbler",
     "drums of 4 to 12 sides that turn at 0.2 to 6 rad/s, kinematic or by a motor, up to 45 % full: nothing "
     "gets out",
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
