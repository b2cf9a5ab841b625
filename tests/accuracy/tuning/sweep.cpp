#include "tests/accuracy/tuning/sweep.hpp"

#include <algorithm>
#include <cmath>

#include "core/hash.hpp"
#include "physics/tuning.hpp"
#include "tests/accuracy/command/threads.hpp"
#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/outcome.hpp"
#include "tests/accuracy/stability/play.hpp"

namespace plumb::tuning {

namespace {

constexpr double kLargeShift = 0.02;
/// Difference of two success rates, in standard deviations, that chance exceeds in one of 20 cases.
constexpr double kSigmas = 2.0;

/// Compared results of one member (random scene) of a family.
struct End {
    std::uint64_t bits = 0;
    bool reached = false;
};

using Ends = std::vector<std::vector<End>>;  // indexed by family and member

/// Simulates further members of the chosen families (indices), until each has `upTo` results.
void playMembers(Ends& ends, const std::vector<std::size_t>& chosen, int upTo, int threads) {
    struct Member {
        std::size_t family, member;
    };
    std::vector<Member> members;
    for (const std::size_t family : chosen) {
        for (std::size_t m = ends[family].size(); m < static_cast<std::size_t>(upTo); ++m)
            members.push_back({family, m});
        ends[family].resize(static_cast<std::size_t>(upTo));
    }
    accuracy::onThreads(threads, members.size(), [&](std::size_t i) {
        const auto [family, member] = members[i];
        const families::Outcome outcome =
            families::play(families::memberOf(families::allFamilies()[family], member + 1));
        ends[family][member] = {outcome.bits, outcome.reached};
    });
}

std::vector<stability::PlayedMap> playMaps(const SweepOptions& options) {
    if (!options.maps) return {};
    return stability::play({.quick = true, .map = {}, .threads = options.threads});
}

bool differs(const std::vector<End>& ends, const std::vector<End>& base) {
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (ends[i].bits != base[i].bits) return true;
    return false;
}

Move moveOf(std::string_view family, const std::vector<End>& ends, const std::vector<End>& base) {
    Move move{.scene = std::string{family}};
    move.differs = differs(ends, base);
    for (std::size_t i = 0; i < ends.size(); ++i) {
        ++move.members;
        move.base += base[i].reached ? 1 : 0;
        move.reached += ends[i].reached ? 1 : 0;
        move.worse += base[i].reached && !ends[i].reached ? 1 : 0;
        move.better += !base[i].reached && ends[i].reached ? 1 : 0;
    }
    return move;
}

Move moveOf(const stability::PlayedMap& map, const stability::PlayedMap& base) {
    Move move{.scene = std::string{map.map->name}, .isMap = true};
    for (std::size_t i = 0; i < map.cells.size(); ++i) {
        const stability::Score before = scoreOf(base.cells[i]), after = scoreOf(map.cells[i]);
        ++move.members;
        move.base += before >= stability::Score::Soft ? 1 : 0;
        move.reached += after >= stability::Score::Soft ? 1 : 0;
        move.worse += after < before ? 1 : 0;
        move.better += after > before ? 1 : 0;
        move.differs = move.differs || !(map.cells[i] == base.cells[i]);
    }
    return move;
}

/// Sets a constant to its value times a factor, and restores it in the destructor.
class Changed {
public:
    Changed(const Constant& constant, double factor) : constant_{constant} {
        constant.set(constant.value * factor);
    }
    ~Changed() { constant_.set(constant_.value); }
    Changed(const Changed&) = delete;
    Changed& operator=(const Changed&) = delete;

private:
    const Constant& constant_;
};

}  // namespace

struct Sweep::Base {
    Ends ends;
    std::vector<stability::PlayedMap> maps;
};

std::vector<const Constant*> allConstants() {
    std::vector<const Constant*> all;
    for (const Constant* constant = constants; constant != nullptr; constant = constant->next)
        all.push_back(constant);
    std::sort(all.begin(), all.end(), [](const Constant* a, const Constant* b) { return a->line < b->line; });
    return all;
}

bool Move::isLarge() const { return std::fabs(shift()) > kLargeShift || (isMap && reached != base); }

bool Move::isChance() const {
    return !isMap && std::abs(worse - better) <= kSigmas * std::sqrt(static_cast<double>(worse + better));
}

bool Trial::differs() const {
    return std::any_of(moves.begin(), moves.end(), [](const Move& move) { return move.differs; });
}

Sweep::Sweep(const SweepOptions& options) : options_{options}, base_{new Base} {
    const std::size_t families = families::allFamilies().size();
    std::vector<std::size_t> all(families);
    for (std::size_t i = 0; i < families; ++i) all[i] = i;
    base_->ends.resize(families);
    playMembers(base_->ends, all, options_.members, options_.threads);
    base_->maps = playMaps(options_);
}

Sweep::~Sweep() { delete base_; }

std::uint64_t Sweep::signature() const {
    Hasher hasher;
    for (const auto& family : base_->ends)
        for (const End& end : family) hasher.add(end.bits);
    return hasher.value();
}

Trial Sweep::trial(const Constant& constant, double factor) const {
    const Changed changed{constant, factor};
    Trial trial{&constant, factor, {}};
    const auto families = families::allFamilies();
    Ends ends(families.size());
    std::vector<std::size_t> all, moved;
    for (std::size_t i = 0; i < families.size(); ++i) all.push_back(i);
    playMembers(ends, all, std::min(kFirst, options_.members), options_.threads);
    for (const std::size_t i : all)
        if (differs(ends[i], base_->ends[i])) moved.push_back(i);
    if (!options_.quick) playMembers(ends, moved, options_.members, options_.threads);
    for (const std::size_t i : all) trial.moves.push_back(moveOf(families[i].name, ends[i], base_->ends[i]));
    const std::vector<stability::PlayedMap> maps = playMaps(options_);
    for (std::size_t i = 0; i < maps.size(); ++i) trial.moves.push_back(moveOf(maps[i], base_->maps[i]));
    return trial;
}

}  // namespace plumb::tuning
