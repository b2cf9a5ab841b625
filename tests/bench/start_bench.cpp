// Waiting times in the editor: until it has started, until a game runs, and until a file changed by another
// program is reloaded.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "assets/asset_store.hpp"
#include "core/clock.hpp"
#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "platform/paths.hpp"
#include "tests/bench/open_editor.hpp"

namespace plumb::bench {
namespace {

constexpr const char* kScene = "scenes/level1.scene.json";
constexpr double kPatience = 5.0;  // s: maximum time to wait for a reload

struct Kind {
    const char* name;
    AssetKind kind;
    const char* path;
};
constexpr Kind kKinds[] = {
    {"texture", AssetKind::Texture, "assets/bob.png"},
    {"sound", AssetKind::Sound, "assets/coin.wav"},
    {"tileset", AssetKind::Tileset, "assets/cave.tileset.json"},
    {"animation", AssetKind::Animation, "assets/bob.anim.json"},
    {"prefab", AssetKind::Prefab, "prefabs/coin.prefab.json"},
    {"scene", AssetKind::Scene, kScene},
};

/// Returns the start time that the editor prints when it is started with a project, s; negative if it prints
/// none.
double startOf([[maybe_unused]] const Path& project) {
#if defined(_WIN32)
    return -1.0;
#else
    const std::string command = format(
        "SDL_VIDEODRIVER=${SDL_VIDEODRIVER:-offscreen} SDL_AUDIODRIVER=${SDL_AUDIODRIVER:-dummy} '{}' '{}' "
        "--scene level1 --screenshot '{}' 2>&1",
        (executableFolder() / "plumb-editor").string(), project.string(), (project / "start.png").string());
    std::FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return -1.0;
    std::string said;
    for (int letter = std::fgetc(pipe); letter != EOF; letter = std::fgetc(pipe))
        said += static_cast<char>(letter);
    pclose(pipe);
    constexpr std::string_view kReady = "Ready after ";
    const std::size_t at = said.find(kReady);
    return at == std::string::npos ? -1.0 : std::strtod(said.c_str() + at + kReady.size(), nullptr);
#endif
}

/// Returns the scene file with a changed position, because the editor ignores files equal to the open scene.
std::string changed(const std::string& text, int round) {
    constexpr std::string_view kPosition = "\"position\": [";
    const std::size_t found = text.find(kPosition);
    if (found == std::string::npos) return text;
    const std::size_t at = found + kPosition.size();
    return format("{}{}{}", text.substr(0, at), round % 9 + 1, text.substr(at));
}

/// Measures the time from writing a file, as another program would, until the frame after its reload.
Times reloadOf(OpenEditor& editor, const Path& project, const Kind& kind, int rounds) {
    editor::Workspace& workspace = editor.workspace();
    const Result<std::string> bytes = readFile(project / kind.path);
    if (!bytes) return {};
    editor.assets().load(kind.kind, kind.path);
    const auto frame = [&](int) { editor.frame(); };
    pacedTimesOf(1, 130, frame);  // the editor searches for new files only from time to time
    Times times;
    std::vector<double> seconds;
    for (int round = 0; round < rounds; ++round) {
        pacedTimesOf(1, 7 + round % 5, frame);
        workspace.notice.clear();
        const double start = wallSeconds();
        static_cast<void>(
            writeFile(project / kind.path, kind.kind == AssetKind::Scene ? changed(*bytes, round) : *bytes)
                .ok());
        while (!startsWith(workspace.notice, "Reloaded") && wallSeconds() - start < kPatience)
            pacedTimesOf(1, 1, frame);
        seconds.push_back(wallSeconds() - start);
    }
    return {medianOf(seconds), *std::max_element(seconds.begin(), seconds.end())};
}

}  // namespace

std::vector<Row> runStarts(const Options& options) {
    const Path game = engineAssets().parent_path() / "projects" / "platformer";
    std::error_code failed;
    if (!std::filesystem::is_directory(game, failed)) {
        std::printf("(%s was not found: start times are not measured)\n", game.string().c_str());
        return {};
    }
    const TemporaryProject project{"start_bench"};
    std::filesystem::copy(
        game, project.root(),
        std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing, failed);
    TimeTable table{"waiting times"};
    const int rounds = options.quick ? 1 : 9;
    std::vector<double> starts;
    for (int round = 0; round < rounds; ++round) starts.push_back(startOf(project.root()));
    if (medianOf(starts) > 0.0)
        table.add("from program start to the first frame", 1, {medianOf(starts), 0.0}, 0.5);
    OpenEditor editor{project.root(), kScene};
    std::vector<double> plays;
    for (int round = 0; round < rounds; ++round) {
        const double start = wallSeconds();
        runAction(editor.workspace(), "run.play");
        for (int i = 0; i < 100 && editor.workspace().play.ticks() == 0; ++i) editor.frame();
        plays.push_back(wallSeconds() - start);
        editor.workspace().stopPlaying();
        editor.frames(2);
    }
    table.add("Play pressed to first tick", 1, {medianOf(plays), 0.0}, 0.1);
    for (const Kind& kind : kKinds)
        table.add(format("reload of a {}", kind.name), 1, reloadOf(editor, project.root(), kind, rounds),
                  0.1);
    return table.rows();
}

}  // namespace plumb::bench
