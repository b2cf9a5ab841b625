#include "editor/model/play/replay_in_scene.hpp"

#include <algorithm>

#include "app/recording/replay_choice.hpp"
#include "core/text.hpp"
#include "editor/model/input/key_words.hpp"
#include "editor/model/workspace.hpp"
#include "input/recorder.hpp"
#include "scene/game_random.hpp"

namespace plumb::editor {
namespace {

constexpr std::int64_t kBeforeEnd = 120;  // ticks: 2 s

std::string noticeOf(const Workspace& workspace, const Replay& replay) {
    const std::string place = format("Tick {} of {}; {} plays the rest", workspace.play.ticks(),
                                     replay.ticks(), keysFor(workspace, "run.watch"));
    if (replay.crash.what.empty()) return place;
    return format(
        "{}, up to the tick before the crash: {}{}", place, replay.crash.what,
        replay.crash.running.empty() ? std::string{} : format(", running {}", replay.crash.running));
}

}  // namespace

Result<Done> checkReplay(const Workspace& workspace, const Replay& replay, std::string_view file) {
    if (!replay.project.empty() && replay.project != workspace.project.name)
        return Error{std::string{file},
                     format("it was recorded by the project \"{}\", and this is \"{}\"", replay.project,
                            workspace.project.name),
                     "open it with that project"};
    if (!replay.state.empty())
        return Error{std::string{file}, "it begins with a saved game, which the editor does not load",
                     "play it: ./plumb play PROJECT --replay FILE"};
    return Done{};
}

Result<Done> playReplayInScene(Workspace& workspace, const Replay& replay, std::string_view file) {
    if (Result<Done> checked = checkReplay(workspace, replay, file); !checked) return checked;
    PlayMode& play = workspace.play;
    workspace.startPlaying(true);
    if (!play.running()) return Error{std::string{file}, workspace.notice, "correct the scene"};
    play.world().resource<GameRandom>().random = Random::seeded(replay.seed);
    const Result<Done> keys = useReplayedKeys(play.world().resource<Input>(), replay, std::string{file});
    if (!keys) return keys.error();
    const std::int64_t ticks =
        static_cast<std::int64_t>(replay.ticks()) - (replay.crash.what.empty() ? 0 : 1);
    ReplayPlayer player{replay};
    while (play.ticks() < ticks) {
        play.step(*player.next());
        const HashCheck* check = player.checkpoint();
        if (check != nullptr && check->hash != play.world().hash())
            return Error{std::string{file},
                         format("the game differs from the recorded one at tick {}", play.ticks()),
                         "open it with the version of the project and of Plumb that recorded it"};
    }
    play.seek(std::max<std::int64_t>(ticks - kBeforeEnd, 0));
    workspace.notice = noticeOf(workspace, replay);
    return Done{};
}

}  // namespace plumb::editor
