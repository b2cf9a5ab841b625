#include "tests/accuracy/stability/random_run.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <thread>

#include "core/text.hpp"
#include "tests/accuracy/stability/fair_scene.hpp"
#include "tests/physics/random_scene.hpp"

namespace plumb::stability {

namespace {

constexpr std::size_t kAtOnce = 256;  // scenes that a thread takes at a time

void playWild(std::uint64_t seed, RandomFindings& found) {
    physics::RandomScene scene{seed};
    scene.run();
    ++found.wild;
    if (scene.isSound()) return;
    if (found.bad + found.fairBad == 0) found.firstBad = seed;
    ++found.bad;
}

void playFair(std::uint64_t seed, RandomFindings& found) {
    const double gain = energyGainOfFairScene(seed);
    ++found.fair;
    if (gain > std::numeric_limits<double>::max()) {
        if (found.bad + found.fairBad == 0) found.firstBad = seed;
        ++found.fairBad;
        return;
    }
    if (gain > kMostGain) ++found.gained;
    if (gain > found.mostGain) found.mostGain = gain, found.mostGainSeed = seed;
}

void add(RandomFindings& sum, const RandomFindings& more) {
    if (sum.bad + sum.fairBad == 0) sum.firstBad = more.firstBad;
    if (more.mostGain > sum.mostGain) sum.mostGain = more.mostGain, sum.mostGainSeed = more.mostGainSeed;
    sum.wild += more.wild;
    sum.bad += more.bad;
    sum.fair += more.fair;
    sum.fairBad += more.fairBad;
    sum.gained += more.gained;
}

}  // namespace

double energyGainOfFairScene(std::uint64_t seed) {
    FairScene scene{seed};
    scene.run();
    return scene.isSound() ? scene.energyGain() : std::numeric_limits<double>::infinity();
}

RandomFindings playRandomScenes(std::size_t count, int threads, const Progress& progress) {
    RandomFindings sum;
    std::atomic<std::size_t> next{0};
    std::mutex adding;
    const auto work = [&] {
        for (std::size_t first = next.fetch_add(kAtOnce); first < count; first = next.fetch_add(kAtOnce)) {
            RandomFindings found;
            for (std::size_t seed = first; seed < std::min(first + kAtOnce, count); ++seed) {
                playWild(seed, found);
                playFair(seed, found);
            }
            const std::lock_guard lock{adding};
            add(sum, found);
            if (progress) progress(sum.wild, count);
        }
    };
    std::vector<std::thread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back(work);
    work();
    for (std::thread& other : others) other.join();
    return sum;
}

std::string textOf(const RandomFindings& findings) {
    std::string text = format("{} wild scenes: {} with bad numbers\n", findings.wild, findings.bad);
    text += format(
        "{} fair scenes: {} with bad numbers; energy grew by more than 1 % in {}, at most by {} % (scene "
        "{})\n",
        findings.fair, findings.fairBad, findings.gained, fixedText(100.0 * findings.mostGain, 2),
        findings.mostGainSeed);
    if (findings.bad + findings.fairBad > 0)
        text += format("bad numbers first in scene {}\n", findings.firstBad);
    return text;
}

}  // namespace plumb::stability
