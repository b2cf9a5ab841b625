#include "gameplay/game_progress.hpp"

#include <charconv>

#include "assets/asset_store.hpp"
#include "core/text.hpp"
#include "ecs/world.hpp"
#include "gameplay/components/actors/health.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "gameplay/key_names.hpp"
#include "gameplay/label_values.hpp"
#include "gameplay/physics_counts.hpp"

namespace plumb {

namespace {

constexpr std::string_view kKeyWord = "key:";

void appendNumber(std::string& out, std::int64_t value, int digits = 1) {
    char buffer[24];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    const auto length = static_cast<int>(end - buffer);
    out.append(static_cast<std::size_t>(length < digits ? digits - length : 0), '0');
    out.append(buffer, end);
}

void appendTime(std::string& out, std::uint64_t ticks) {
    const auto seconds = static_cast<std::int64_t>(ticks / 60);
    appendNumber(out, seconds / 60);
    out.push_back(':');
    appendNumber(out, seconds % 60, 2);
}

/// Returns the file name without extensions, e.g. "03_the_cave" for "scenes/03_the_cave.scene.json".
std::string_view stemOf(std::string_view path) {
    path = path.substr(path.find_last_of('/') + 1);
    return path.substr(0, path.find('.'));
}

std::string_view pathOfLevel(const World& world, TextId level) {
    if (const std::string_view path = world.texts().find(level); !path.empty()) return path;
    const auto* assets = world.service<AssetStore>();
    return assets != nullptr ? assets->pathOf(AssetKind::Scene, level) : std::string_view{};
}

int healthOfPlayer(const World& world) {
    for (auto [entity, player, health] : world.query<const PlayerController, const Health>(withPaused))
        return health.points;
    return 0;
}

/// @return false if the placeholder is unknown
bool appendValue(const World& world, const GameProgress& progress, std::string_view word, std::string& out) {
    const auto* own = world.findResource<LabelValues>();
    if (const std::string* text = own != nullptr ? own->find(word) : nullptr) return out.append(*text), true;
    if (word == "time") return appendTime(out, progress.ticks), true;
    if (word == "levelName") return out.append(stemOf(pathOfLevel(world, progress.level))), true;
    const std::pair<std::string_view, int> numbers[] = {
        {"coins", progress.coins},
        {"coinsTotal", progress.coinsTotal},
        {"levelCoins", progress.levelCoins},
        {"levelCoinsTotal", progress.levelCoinsTotal},
        {"keys", progress.keys},
        {"deaths", progress.deaths},
        {"level", static_cast<int>(progress.levelsReached.size())},
    };
    for (const auto& [name, value] : numbers) {
        if (name == word) return appendNumber(out, value), true;
    }
    if (word == "health") return appendNumber(out, healthOfPlayer(world)), true;
    if (const auto count = physicsCount(world, word)) return appendNumber(out, *count), true;
    return startsWith(word, kKeyWord) && appendKey(world, word.substr(kKeyWord.size()), out);
}

}  // namespace

void GameProgress::addTo(Hasher& hasher) const {
    for (const int value : {coins, coinsTotal, levelCoins, levelCoinsTotal, keys, deaths}) {
        hasher.add(static_cast<std::uint64_t>(value));
    }
    hasher.add(ticks);
    hasher.add(level.value);
    for (const TextId reached : levelsReached) hasher.add(reached.value);
    hasher.add(std::uint64_t{levelFinished} << 1 | std::uint64_t{gameFinished});
}

void fillPlaceholders(const World& world, std::string_view text, std::string& out) {
    out.clear();
    const GameProgress* known = world.findResource<GameProgress>();
    const GameProgress progress = known != nullptr ? *known : GameProgress{};
    while (!text.empty()) {
        const std::size_t open = text.find('{');
        const std::size_t close = open == std::string_view::npos ? open : text.find('}', open);
        if (close == std::string_view::npos) break;
        out.append(text.substr(0, open));
        const std::string_view word = text.substr(open + 1, close - open - 1);
        if (!appendValue(world, progress, word, out)) out.append(text.substr(open, close - open + 1));
        text.remove_prefix(close + 1);
    }
    out.append(text);
}

}  // namespace plumb
