#include "app/recording/replay_choice.hpp"

#include <random>
#include <vector>

#include "core/crash_report.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "input/replay_link.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"

namespace plumb {

bool isReplayed(const PlayerOptions& options) { return !options.replay.empty() || !options.link.empty(); }

std::string nameOfReplay(const PlayerOptions& options) {
    return options.link.empty() ? options.replay : "link";
}

Result<Replay> replayOf(const PlayerOptions& options) {
    return options.link.empty() ? loadReplay(options.replay) : replayOfLink(options.link);
}

bool isPlayedLive(const PlayerOptions& options) {
    return !options.headless && !options.effects && options.frames < 0 && options.screenshot.empty() &&
           options.capture.empty();
}

Result<PlayerOptions> begun(PlayerOptions options, std::string_view projectName) {
    if (!isReplayed(options)) {
        if (!options.seed && isPlayedLive(options)) options.seed = std::random_device{}();
        return options;
    }
    const Result<Replay> replay = replayOf(options);
    if (!replay) return replay.error();
    if (!replay->project.empty() && replay->project != projectName) {
        const bool isFile = options.link.empty();
        return Error{
            nameOfReplay(options),
            format("it was recorded by the project \"{}\", and this is \"{}\"", replay->project, projectName),
            isFile ? "play it with that project; if this one was renamed, change the second line of the file"
                   : "play it with that project"};
    }
    options.seed = replay->seed;
    options.scene = replay->scene;
    return options;
}

Result<Done> useReplayedKeys(Input& input, const Replay& replay, const std::string& where) {
    if (replay.keys.empty()) return Done{};
    std::vector<Error> problems;
    const Result<Json> keys = parseJson(replay.keys, where + ": keys");
    if (!keys) return keys.error();
    input.setMap(reboundFromJson(input.map(), *keys, where + ": keys", problems));
    for (const Error& problem : problems) logWarning("Input", problem);
    return Done{};
}

void noteEndOfCrash(const Replay& replay, std::int64_t ticks) {
    const RecordedCrash& crash = replay.crash;
    if (crash.what.empty()) return;
    const std::string build = buildId();
    logNote(
        "Input",
        "The replay ends at tick {}, where the game crashed: {}. It has not crashed again{}: the cause is "
        "not in the simulation, or it depends on the machine.",
        ticks, crash.what,
        crash.build == build ? std::string{} : format(", in build {} instead of {}", build, crash.build));
}

}  // namespace plumb
