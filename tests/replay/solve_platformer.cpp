// Plays projects/platformer automatically from the title to the end screen and writes the replay that the
// test PlatformerReplay plays. Run it after changes of the levels or of the player's motion:
//
//   ninja -C build/release solve_platformer && build/release/bin/solve_platformer
//   tests/replay/platformer.replay
//
// Method: best-first search over short bursts of input, each tried from a snapshot of the world. States with
// a short path to the goal along free tiles are tried first. Due to the snapshots no tick is played twice.

#include <cstdio>
#include <deque>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <tuple>
#include <vector>

#include "app/scene_game.hpp"
#include "core/log.hpp"
#include "gameplay/components.hpp"
#include "gameplay/game_progress.hpp"
#include "input/recorder.hpp"
#include "scene/components.hpp"
#include "scene/scene_requests.hpp"
#include "tests/support/places.hpp"

namespace plumb {
namespace {

/// A burst of input: direction, duration, and number of ticks in which jump is held.
struct Burst {
    int direction = 0;
    int ticks = 0;
    int jumpTicks = 0;
};

constexpr Burst kBursts[] = {{1, 10, 0},   {1, 10, 10}, {1, 22, 14}, {1, 6, 3},  {-1, 10, 0}, {-1, 10, 10},
                             {-1, 22, 14}, {0, 10, 0},  {0, 24, 14}, {0, 30, 0}, {1, 34, 14}};

InputFrame frameOf(const Burst& burst, int tick) {
    InputFrame frame;
    frame.set(Key::Right, burst.direction > 0);
    frame.set(Key::Left, burst.direction < 0);
    frame.set(Key::Space, tick < burst.jumpTicks);
    return frame;
}

/// Stores the number of tiles from every free tile to the goal along free tiles, including diagonals.
class Distances {
public:
    explicit Distances(World& world) {
        for (auto [entity, layer, collider, transform] :
             world.query<const TileLayer, const TileCollider, const Transform>()) {
            grid_ = world.tiles().find(layer.cells);
            origin_ = transform.position;
            if (const auto* assets = world.service<AssetStore>()) tileset_ = &assets->tileset(layer.tileset);
        }
        if (grid_ == nullptr) return;
        steps_.assign(grid_->cells().size(), kFar);
        for (auto [entity, goal, transform] : world.query<const Goal, const Transform>()) {
            spread(transform.position + Vec2{8.0f, 8.0f});
        }
    }

    [[nodiscard]] int of(Vec2 place) const {
        const auto [x, y] = cellOf(place);
        return grid_ != nullptr && grid_->has(x, y) ? steps_[slot(x, y)] : kFar;
    }

    static constexpr int kFar = 100'000;

private:
    [[nodiscard]] std::pair<int, int> cellOf(Vec2 place) const {
        return {static_cast<int>((place.x - origin_.x) / 16.0f),
                static_cast<int>((place.y - origin_.y) / 16.0f)};
    }
    [[nodiscard]] std::size_t slot(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_->width()) +
               static_cast<std::size_t>(x);
    }
    [[nodiscard]] bool isFree(int x, int y) const {
        if (!grid_->has(x, y)) return false;
        const int tile = tileOf(grid_->at(x, y));
        if (tile < 0) return true;
        const Tile* special = tileset_->find(tile);
        return special == nullptr || special->shape != TileShape::Full || special->oneWay;
    }
    void spread(Vec2 goal) {
        const auto [goalX, goalY] = cellOf(goal);
        std::deque<std::pair<int, int>> open;
        for (int dy = -2; dy <= 2; ++dy) {
            if (isFree(goalX, goalY + dy)) {
                steps_[slot(goalX, goalY + dy)] = 0;
                open.emplace_back(goalX, goalY + dy);
            }
        }
        while (!open.empty()) {
            const auto [x, y] = open.front();
            open.pop_front();
            for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                if (!isFree(x + dx, y + dy) || steps_[slot(x + dx, y + dy)] != kFar) continue;
                steps_[slot(x + dx, y + dy)] = steps_[slot(x, y)] + 1;
                open.emplace_back(x + dx, y + dy);
            }
        }
    }

    const TileGrid* grid_ = nullptr;
    const Tileset* tileset_ = nullptr;
    Vec2 origin_;
    std::vector<int> steps_;
};

struct Node {
    Snapshot snapshot;
    int parent = -1;
    Burst burst;
};

Entity playerOf(World& world) { return world.first<const PlayerController>(); }

/// Returns the bursts that bring the player to the goal of the loaded level; empty if none were found.
std::vector<Burst> solveLevel(SceneGame& game) {
    World& world = game.world;
    const Distances distances{world};
    const int deaths = world.resource<GameProgress>().deaths;
    std::vector<Node> nodes(1);
    world.save(nodes[0].snapshot);
    using Ranked = std::tuple<int, int>;  // score, node
    std::priority_queue<Ranked, std::vector<Ranked>, std::greater<>> open;
    open.emplace(0, 0);
    std::set<std::tuple<int, int, int, int, std::uint64_t>> seen;
    int nearest = Distances::kFar;
    while (!open.empty() && nodes.size() < 30'000) {
        const int from = std::get<1>(open.top());
        open.pop();
        for (const Burst& burst : kBursts) {
            world.restore(nodes[static_cast<std::size_t>(from)].snapshot);
            bool finished = false;
            for (int tick = 0; tick < burst.ticks && !finished; ++tick) {
                tickGame(game, frameOf(burst, tick));
                finished = world.resource<GameProgress>().levelFinished;
                if (world.resource<GameProgress>().deaths > deaths) break;
            }
            if (world.resource<GameProgress>().deaths > deaths) continue;
            const Entity player = playerOf(world);
            if (!player) continue;
            const Respawn* respawn = player.find<Respawn>();
            if (respawn != nullptr && respawn->waiting > 0) continue;
            const Vec2 at = player.get<Transform>().position;
            const Vec2 speed = player.get<RigidBody>().velocity;
            const auto key = std::tuple{static_cast<int>(at.x / 6.0f), static_cast<int>(at.y / 6.0f),
                                        static_cast<int>(speed.x / 60.0f), static_cast<int>(speed.y / 100.0f),
                                        world.tick / 40 % 6};
            if (!finished && !seen.insert(key).second) continue;
            Node& node = nodes.emplace_back();
            node.parent = from;
            node.burst = burst;
            if (finished) {
                std::vector<Burst> path;
                for (int i = static_cast<int>(nodes.size()) - 1;
                     nodes[static_cast<std::size_t>(i)].parent >= 0;
                     i = nodes[static_cast<std::size_t>(i)].parent) {
                    path.insert(path.begin(), nodes[static_cast<std::size_t>(i)].burst);
                }
                std::printf("  solved with %zu bursts after %zu tries\n", path.size(), nodes.size());
                world.restore(nodes[0].snapshot);
                return path;
            }
            world.save(node.snapshot);
            const int distance = distances.of(at + Vec2{4.0f, 4.0f});
            if (distance < nearest) nearest = distance;
            open.emplace(distance * 4 + static_cast<int>(nodes.size() / 400),
                         static_cast<int>(nodes.size()) - 1);
        }
    }
    std::printf("  gave up after %zu tries, %d tiles from the goal\n", nodes.size(), nearest);
    return {};
}

/// Plays frames in the game and appends them to the replay.
class Player {
public:
    Player(SceneGame& game, Recorder& recorder) : game_{game}, recorder_{recorder} {}

    void play(const InputFrame& frame) {
        recorder_.record(frame);
        tickGame(game_, frame);
        if (recorder_.ticks() % 300 == 0) recorder_.check(game_.world.hash());
    }
    void wait(int ticks) {
        for (int i = 0; i < ticks; ++i) play({});
    }

private:
    SceneGame& game_;
    Recorder& recorder_;
};

int solve(const Path& root, const Path& file) {
    Result<Project> project = loadProject(root);
    if (!project) {
        logError("Engine", project.error());
        return 1;
    }
    SceneGame game{*project};
    game.assets.logging = false;
    game.onCreate();
    Recorder recorder;
    recorder.replay.project = project->name;
    recorder.replay.engine = "0.1.0";
    recorder.replay.scene = project->startScene;
    recorder.replay.seed = 1;
    Player player{game, recorder};
    player.wait(90);
    for (int i = 0; i < 6; ++i) {
        InputFrame frame;
        frame.set(Key::Space, true);
        player.play(frame);
    }
    player.wait(40);
    for (int level = 1; playerOf(game.world) && !game.world.resource<GameProgress>().gameFinished; ++level) {
        std::printf("level %d\n", level);
        std::fflush(stdout);
        const std::vector<Burst> path = solveLevel(game);
        if (path.empty()) return 1;
        const std::size_t reached = game.world.resource<GameProgress>().levelsReached.size();
        for (const Burst& burst : path) {
            for (int tick = 0; tick < burst.ticks && !game.world.resource<GameProgress>().levelFinished;
                 ++tick) {
                player.play(frameOf(burst, tick));
            }
        }
        for (int i = 0; i < 600; ++i) {
            player.wait(1);
            const GameProgress& progress = game.world.resource<GameProgress>();
            if (progress.levelsReached.size() > reached || progress.gameFinished) break;
        }
        player.wait(30);
    }
    player.wait(240);
    recorder.check(game.world.hash());
    const GameProgress& progress = game.world.resource<GameProgress>();
    std::printf("levels %zu, coins %d of %d, deaths %d, ticks %llu, hash %s\n", progress.levelsReached.size(),
                progress.coins, progress.coinsTotal, progress.deaths,
                static_cast<unsigned long long>(recorder.ticks()), hexText(game.world.hash()).c_str());
    const auto saved = writeFile(file, writeReplay(recorder.replay));
    if (!saved) logError("Input", saved.error());
    return saved ? 0 : 1;
}

}  // namespace
}  // namespace plumb

int main(int count, char** arguments) {
    if (count != 2) {
        std::fprintf(stderr, "usage: solve_platformer FILE.replay\n");
        return 2;
    }
    return plumb::solve(plumb::test::sourceFolder() / "projects/platformer", arguments[1]);
}
