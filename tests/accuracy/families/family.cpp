#include "tests/accuracy/families/family.hpp"

#include <algorithm>
#include <array>

#include "core/hash.hpp"

namespace plumb::families {

namespace {

constexpr auto kFamilies = std::to_array<Family>({
    {"card-house",
     "2 to 6 levels of cards that lean at each other, friction 0.4 to 0.9, lean 0.2 to 0.35 rad, feet 0 to "
     "12 cm "
     "apart, cards 2 to 6 cm thick, only those that statics lets stand: it stands for 30 s",
     makeCardHouse, 0.02},
    {"closing-box",
     "50 to 150 balls and boxes that fell asleep in a box whose kinematic walls then close at 0.02 to 5 m/s, "
     "until the crowd fills three quarters of it: nothing gets out",
     makeClosingBox},
    {"driven-linkage",
     "four-bars, parallelograms, slider-cranks and scissors of random lengths and masses, driven at 0.5 to "
     "8 rad/s: the crank turns as driven, to 1 %",
     makeDrivenLinkage, 0.05},
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
