#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "app/effect_rows.hpp"
#include "app/project.hpp"
#include "app/scene_game.hpp"
#include "platform/paths.hpp"
#include "tests/bench/game_effects/game_effects_bench.hpp"

#if !defined(_WIN32)
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace plumb::bench {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

struct Sample {
    const char* project;
    const char* scene;  ///< null: the project has its own program
};
constexpr Sample kSamples[] = {
    {"platformer", "title"},        {"platformer", "level1"},          {"platformer", "level3"},
    {"physics-playground", "menu"}, {"physics-playground", "pyramid"}, {"physics-playground", "softbodies"},
    {"physics-lab", "bits"},        {"hello-code", nullptr},
};

struct Result {
    double megabytes = 0.0;  ///< maximum resident memory
    double start = 0.0;      ///< ms from start to exit of a run of one frame
    double tick = 0.0;       ///< µs per tick
};

#if !defined(_WIN32)
/// Runs a program. @param milliseconds  receives the run time @return maximum resident memory, MB; 0: failed
double run(const std::vector<std::string>& command, double& milliseconds) {
    const auto start = std::chrono::steady_clock::now();
    std::fflush(stdout);  // otherwise the child process would write buffered output again
    const pid_t child = fork();
    if (child == 0) {
        std::vector<char*> arguments;
        for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        if (std::freopen("/dev/null", "w", stdout) == nullptr) _exit(126);
        if (std::freopen("/dev/null", "w", stderr) == nullptr) _exit(126);
        execv(arguments[0], arguments.data());
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    if (child < 0 || wait4(child, &status, 0, &usage) != child || status != 0) return 0.0;
    milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}
#else
double run(const std::vector<std::string>&, double&) { return 0.0; }
#endif

void measureProcess(const Sample& sample, bool all, int rounds, Result& result) {
    const Path bin = executableFolder();
    std::vector<std::string> command;
    if (sample.scene == nullptr) {
        command = {(bin / sample.project).string()};
#if !defined(_WIN32)
        setenv("PLUMB_OPTIONS", all ? "--frames 1 --all-effects" : "--frames 1", 1);
#endif
    } else {
        command = {(bin / "plumb-player").string(),
                   (Path{PLUMB_SOURCE_DIR} / "projects" / sample.project).string(),
                   "--scene",
                   sample.scene,
                   "--frames",
                   "1"};
        if (all) command.emplace_back("--all-effects");
    }
    result.start = kNever;
    for (int i = 0; i < rounds; ++i) {
        double milliseconds = kNever;
        result.megabytes = std::max(result.megabytes, run(command, milliseconds));
        result.start = std::min(result.start, milliseconds);
    }
}

void measureTick(const Sample& sample, bool all, int rounds, Result& result) {
    plumb::Result<Project> project = loadProject(Path{PLUMB_SOURCE_DIR} / "projects" / sample.project);
    if (!project) return;
    SceneGame game{std::move(*project), sample.scene};
    game.assets.logging = false;
    game.onCreate();
    if (all) {
        for (const EffectRow& row : engineEffects().rows()) game.effects.setProgramPin(row.name, Pin::On);
    }
    constexpr int kTicks = 60;
    result.tick = kNever;
    for (int round = 0; round < rounds; ++round) {
        const auto start = std::chrono::steady_clock::now();
        for (int i = 0; i < kTicks; ++i) tickGame(game, InputFrame{});
        const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
        result.tick = std::min(result.tick, time.count() / kTicks);
    }
}

}  // namespace

int measureProjects(bool quick) {
#if !defined(_WIN32)
    setenv("SDL_VIDEODRIVER", "offscreen", 0);
    setenv("SDL_AUDIODRIVER", "dummy", 0);
#endif
    std::printf("each project with its required effects, then with all effects\n%-32s%10s%9s%12s%9s%12s%9s\n",
                "", "MB", "all on", "start ms", "all on", "tick us", "all on");
    for (const Sample& sample : kSamples) {
        Result results[2];
        for (const bool all : {false, true}) {
            measureProcess(sample, all, quick ? 1 : 9, results[all ? 1 : 0]);
            if (sample.scene != nullptr) measureTick(sample, all, quick ? 1 : 9, results[all ? 1 : 0]);
        }
        const std::string name =
            std::string{sample.project} + (sample.scene == nullptr ? "" : std::string{", "} + sample.scene);
        std::printf("%-32s%10.1f%9.1f%12.1f%9.1f", name.c_str(), results[0].megabytes, results[1].megabytes,
                    results[0].start, results[1].start);
        if (sample.scene != nullptr) std::printf("%12.1f%9.1f", results[0].tick, results[1].tick);
        std::printf("\n");
    }
    return 0;
}

}  // namespace plumb::bench
