#include "tests/accuracy/stability/random_run.hpp"

#include <algorithm>
#include <mutex>

#include "core/text.hpp"
#include "tests/accuracy/stability/fair_scene.hpp"
#include "tests/physics/support/random_scene.hpp"

namespace plumb::stability {

namespace {

constexpr std::size_t kAtOnce = 256;  // number of scenes that a thread takes at once

void playWild(std::uint64_t seed, RandomFindings& found) {
    physics::RandomScene scene{seed};
    scene.run();
    ++found.wild;
    if (scene.isSound()) return;
    if (found.bad++ == 0) found.firstBad = seed;
}

void playFair(std::uint64_t seed, RandomFindings& found) {
    FairScene scene{seed};
    scene.run();
    FairFindings& kind = scene.hasJoints() ? found.jointed : found.loose;
    ++kind.count;
    if (!scene.isSound()) {
        if (kind.bad++ == 0) kind.seed = seed;
        return;
    }
    const double gain = scene.energyGain();
    if (gain > kMaxEnergyGain) ++kind.gained;
    if (gain > kind.mostGain) {
        kind.mostGain = gain;
        if (kind.bad == 0) kind.seed = seed;
    }
}

void add(FairFindings& sum, const FairFindings& more) {
    if (more.bad > 0 ? sum.bad == 0 : sum.bad == 0 && more.mostGain > sum.mostGain) sum.seed = more.seed;
    sum.count += more.count;
    sum.bad += more.bad;
    sum.gained += more.gained;
    sum.mostGain = std::max(sum.mostGain, more.mostGain);
}

void add(RandomFindings& sum, const RandomFindings& more) {
    if (sum.bad == 0) sum.firstBad = more.firstBad;
    sum.wild += more.wild;
    sum.bad += more.bad;
    add(sum.loose, more.loose);
    add(sum.jointed, more.jointed);
}

std::string textOf(std::string_view kind, const FairFindings& found) {
    return format(
        "{} fair scenes {}: {} with non-finite numbers; energy grew by more than 1 % in {}, at most to {} "
        "times "
        "(scene {})\n",
        found.count, kind, found.bad, found.gained, fixedText(1.0 + found.mostGain, 3), found.seed);
}

}  // namespace

RandomFindings playRandomScenes(std::size_t count, int threads, const accuracy::ShowDone& show) {
    RandomFindings sum;
    std::mutex adding;
    const auto playSome = [&](std::size_t part) {
        RandomFindings found;
        const std::size_t first = part * kAtOnce;
        for (std::size_t seed = first; seed < std::min(first + kAtOnce, count); ++seed) {
            playWild(seed, found);
            playFair(seed, found);
        }
        const std::lock_guard lock{adding};
        add(sum, found);
    };
    accuracy::onThreads(threads, (count + kAtOnce - 1) / kAtOnce, playSome, show);
    return sum;
}

std::string textOf(const RandomFindings& findings) {
    std::string text = format("{} extreme scenes: {} with non-finite numbers", findings.wild, findings.bad);
    if (findings.bad > 0) text += format(", first in scene {}", findings.firstBad);
    return text + "\n" + textOf("without joints", findings.loose) + textOf("with joints", findings.jointed);
}

}  // namespace plumb::stability
