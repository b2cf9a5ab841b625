// Cost of recording a game in the editor, which keeps the last 30 s for rewinding.

#include <cstdio>
#include <utility>

#include "core/clock.hpp"
#include "core/file.hpp"
#include "editor/model/play/game_session.hpp"
#include "editor/model/play/play_mode.hpp"
#include "platform/paths.hpp"
#include "tests/bench/open_editor.hpp"
#include "tests/editor/support/played_input.hpp"

namespace plumb::bench {
namespace {

constexpr double kFrame = 1.0 / 60.0;                                 // s
constexpr double kMax = 0.1;                                          // maximum cost, ratio of a frame's time
constexpr std::int64_t kWarmUp = editor::PlayRecording::kTicks + 60;  // until old worlds are discarded

struct Game {
    const char* name;
    const char* project;
    const char* scene;
    int boxes = 0;  // if not 0: a heap of this number of boxes replaces the scene
};
constexpr Game kGames[] = {{"platformer", "platformer", "scenes/level2.scene.json"},
                           {"500 at rest", "physics-playground", "scenes/pyramid.scene.json", 500},
                           {"tumbler", "physics-playground", "scenes/tumbler.scene.json"}};

std::unique_ptr<editor::PlaySession> sessionOf(const Game& game) {
    const Result<Project> project = loadProject(engineAssets().parent_path() / "projects" / game.project);
    if (!project) return nullptr;
    const Result<std::string> text = readFile(project->root / game.scene);
    if (!text) return nullptr;
    return editor::makeGameSession(*project, game.scene,
                                   game.boxes > 0 ? editor::heapScene(game.boxes) : *text);
}

/// Time of the same ticks with and without recording, in s.
struct Cost {
    double plain = 0.0;
    double recorded = 0.0;
    double longestPlain = 0.0;  ///< longest tick without recording
    double longestRecorded = 0.0;
    std::size_t bytes = 0;
};

Cost costOf(const Game& game, std::int64_t ticks) {
    const std::unique_ptr<editor::PlaySession> straight = sessionOf(game);
    editor::PlayMode play;
    play.start(sessionOf(game));
    Cost cost;
    for (std::int64_t tick = 0; tick < kWarmUp + ticks; ++tick) {
        const InputFrame hands = editor::runAndJump(tick);
        double plain = 0.0;
        double recorded = 0.0;
        // Alternate the order, because the second run finds less of its world in the CPU caches.
        for (const bool records : {tick % 2 == 0, tick % 2 != 0}) {
            const double start = threadSeconds();
            records ? play.step(hands) : straight->tick(hands);
            (records ? recorded : plain) = threadSeconds() - start;
        }
        if (tick < kWarmUp) continue;
        cost.plain += plain;
        cost.recorded += recorded;
        cost.longestPlain = std::max(cost.longestPlain, plain);
        cost.longestRecorded = std::max(cost.longestRecorded, recorded);
    }
    cost.bytes = play.recording().bytes();
    return cost;
}

}  // namespace

int runRewind(const Options& options) {
    const std::int64_t ticks = options.quick ? 60 : 3600;
    std::printf("%-12s %9s %9s %11s %11s %14s %14s %7s\n", "recording", "tick us", "recorded", "of a tick",
                "of a frame", "longest us", "recorded", "MB");
    std::vector<Row> rows;
    for (const Game& game : kGames) {
        if (sessionOf(game) == nullptr) {
            std::printf("%-12s (the project was not found)\n", game.name);
            continue;
        }
        const Cost cost = costOf(game, ticks);
        const auto count = static_cast<double>(ticks);
        const double more = (cost.recorded - cost.plain) / count;  // s
        rows.push_back({game.name, 1, more * 1e9, more * 1e9, 0.0, kMax * kFrame * 1e9});
        std::printf("%-12s %9.1f %9.1f %9.1f %% %9.2f %% %14.1f %14.1f %7.1f  %s\n", game.name,
                    cost.plain / count * 1e6, cost.recorded / count * 1e6,
                    100.0 * (cost.recorded / cost.plain - 1.0), 100.0 * more / kFrame,
                    cost.longestPlain * 1e6, cost.longestRecorded * 1e6,
                    static_cast<double>(cost.bytes) * 1e-6, rows.back().met() ? "met" : "MISSED");
    }
    return options.jsonPath.empty() || writeRows(options.jsonPath, rows) ? 0 : 1;
}

}  // namespace plumb::bench
