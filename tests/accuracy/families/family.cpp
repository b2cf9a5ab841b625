#include "tests/accuracy/families/family.hpp"

#include <algorithm>
#include <array>

#include "core/hash.hpp"

namespace plumb::families {

namespace {

constexpr auto kFamilies = std::to_array<Family>({
    {"bullets",
     "1 to 3 rooms with walls of 5 to 50 cm in which bullets of 10 to 300 m/s are fired at walls, turning "
     "plates "
     "and crates: all stays in its room",
     makeBullets},
    {"card-house",
     "2 to 6 levels of cards that lean at each other, friction 0.4 to 0.9, lean 0.2 to 0.35 rad, feet 0 to "
     "12 cm "
     "apart, cards 2 to 6 cm thick, only those that statics lets stand: it stands for 30 s",
     makeCardHouse, 0.02},
    {"churn",
     "a closed pit in which up to 40 bodies come, go, jump elsewhere, change their mass and are pushed, with "
     "pauses to sleep: nothing leaves it",
     makeChurn},
    {"closing-box",
     "50 to 150 balls and boxes that fell asleep in a box whose kinematic walls then close at 0.02 to 5 m/s, "
     "until the crowd fills three quarters of it: nothing gets out",
     makeClosingBox},
    {"driven-linkage",
     "four-bars, parallelograms, slider-cranks and scissors of random lengths and masses, driven at 0.5 to "
     "8 rad/s: the crank turns as driven, to 1 %",
     makeDrivenLinkage, 0.05},
    {"elastic-gas",
     "4 to 49 discs and boxes of random sizes and 4 to 40 m/s that bounce without loss in no gravity, in a "
     "box "
     "or free: energy, and free momentum too, stay",
     makeElasticGas},
    {"fields",
     "planets with landers and moons, water with boxes of 0.1 to 8 times its density, linear pulls: all is "
     "where "
     "the formula says",
     makeFields},
    {"kinematic-traffic",
     "lifts with crates, sweepers, rotors and pistons of 0.01 to 20 m/s that meet bodies asleep and awake: "
     "what is "
     "carried stays on, what is swept is pushed",
     makeKinematicTraffic},
    {"one-way-belt",
     "goods on belts of 0.2 to 10 m/s, and jumps through platforms that hold from above: speeds by the "
     "formula "
     "of friction, and all on its side",
     makeOneWayBelt},
    {"ratio-stack",
     "stacks of 3 to 20 boxes with mass ratios to 1:200, unlike sizes and offsets that statics lets stand: "
     "it "
     "stands and sleeps",
     makeRatioStack, 0.1},
    {"seam-slide",
     "a box, ball, pentagon or capsule of 0.04 to 2 m that slides or rolls at 0.5 to 20 m/s over separate "
     "boxes "
     "laid flush: the speed of a single floor, and no hop",
     makeSeamSlide},
    {"soft-among-rigid",
     "jellies, ropes and cloths of 1/100 to 100 times the mass of the crates and balls that fall on them: "
     "all "
     "rests, nothing is passed through, no energy is gained",
     makeSoftAmongRigid},
    {"tumbler",
     "drums of 4 to 12 sides that turn at 0.2 to 6 rad/s, kinematic or by a motor, up to 45 % full: "
     "nothing "
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
