#include "app/player.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "app/benchmark.hpp"
#include "app/effect_list.hpp"
#include "app/game_loop.hpp"
#include "app/options/game_options.hpp"
#include "app/project.hpp"
#include "app/recording/replay_choice.hpp"
#include "app/scene_game.hpp"
#include "app/screen.hpp"
#include "codec/pack.hpp"
#include "core/log.hpp"
#include "core/profile.hpp"
#include "core/text.hpp"
#include "platform/message_box.hpp"
#include "platform/page.hpp"
#include "platform/paths.hpp"

namespace plumb {
namespace {

ScreenSettings screenOf(const Project& project, const PlayerOptions& options) {
    ScreenSettings settings;
    settings.title = project.name;
    settings.windowWidth = project.windowWidth;
    settings.windowHeight = project.windowHeight;
    settings.fullscreen = project.fullscreen;
    settings.picture = {static_cast<float>(project.width), static_cast<float>(project.height)};
    settings.scaling = project.scaling;
    settings.smooth = project.smooth;
    settings = withPlayerSettings(std::move(settings), options, project.name);
    return withOptions(std::move(settings), options);
}

/// Prints the components of the scene, the effects they request, and their cost.
void listEffects(SceneGame& game, const PlayerOptions& options) {
    constexpr int kTicks = 120;
    Profile profile;
    std::printf("%-22sentities\n", "components");
    for (const TypeInfo& type : game.types.all()) {
        const std::size_t count = game.world.count(type);
        if (count > 0)
            std::printf("  %-20.*s%zu\n", static_cast<int>(type.name.size()), type.name.data(), count);
    }
    const EffectReport report = measureEffects(
        game, profile,
        options.frames > 0 ? static_cast<int>(std::min<std::int64_t>(options.frames, 6000)) : kTicks);
    std::printf("\n%s\n", effectText(report).c_str());
    std::printf(
        "A tick takes %s us (CPU time, best of 3 runs of %d ticks without input). \"shared\": part of a\n"
        "stage of the physics that other effects use too. \"saves us\": us/tick saved without the effect.\n",
        fixedText(report.microseconds, 1).c_str(), report.ticks);
}

int benchmark(const PlayerOptions& options) {
    constexpr Vec2 kPicture{640.0f, 360.0f};
    std::unique_ptr<Screen> screen;
    if (!options.headless) {
        const PixelSize window = options.window == PixelSize{} ? PixelSize{640, 360} : options.window;
        Result<std::unique_ptr<Screen>> opened = Screen::open(
            {"Plumb benchmark", window.width, window.height, options.fullscreen, kPicture, WindowScale::Fit});
        if (!opened) {
            logError("Engine", opened.error());
            return 1;
        }
        screen = std::move(*opened);
        screen->window().setVsync(false);
    }
    BenchmarkSettings settings;
    if (options.entities > 0) settings.entities = options.entities;
    if (options.frames > 0)
        settings.frames = static_cast<int>(std::min<std::int64_t>(options.frames, 1'000'000));
    std::fputs(benchmarkTable(runBenchmark(settings, screen.get())).c_str(), stdout);
    return 0;
}

/// Adds the files of an exported game, which are in one pack beside the program.
Result<Done> mountGame(Preferred preferred) {
    const Path file = executableFolder() / kPackName;
    if (!fileExists(file)) return Done{};
    Result<std::shared_ptr<const Pack>> pack = Pack::open(file);
    if (!pack) return pack.error();
    mountFiles(executableFolder(), std::move(*pack), preferred);
    return Done{};
}

Path projectOf(const PlayerOptions& options) {
    if (!options.project.empty()) return options.project;
    const Path beside = executableFolder() / kGameFolder;
    return folderExists(beside) ? beside : Path{"projects/platformer"};
}

bool lacksPack(const PlayerOptions& options) {
    return options.project.empty() && !options.exportedAs.empty() &&
           !fileExists(executableFolder() / kPackName) && !folderExists(executableFolder() / kGameFolder);
}

/// Opens the project that the options name. Files beside the pack of an exported game replace those in it if
/// the project allows it.
Result<Project> openProject(const PlayerOptions& options) {
    if (lacksPack(options))
        return Error{options.exportedAs,
                     format("{} is missing beside the program: unpack the whole archive", kPackName), ""};
    if (const Result<Done> mounted = mountGame(Preferred::Mounted); !mounted) return mounted.error();
    Result<Project> project = loadProject(projectOf(options));
    if (!project || !project->mods) return project;
    if (const Result<Done> mounted = mountGame(Preferred::OnDisk); !mounted) return mounted.error();
    return loadProject(projectOf(options));
}

/// True if the folder of the project contains code.
bool hasCode(const Project& project) { return folderExists(project.root / "code"); }

void warnOfMissingCode(const Project& project, const Module& code) {
    if (hasCode(project) && code.componentTypes().empty() && code.systems().empty())
        logWarning("Code",
                   Error{(project.root / "code").generic_string(), "this player was built without this code",
                         "use ./plumb play PROJECT, which builds a player with the code"});
}

/// Says why the game does not start, in a window too: a page shows what a program prints, a desktop does not.
int refuse(const Error& error, const PlayerOptions& options) {
    logError("Engine", error);
    const bool endsItself = options.headless || options.frames >= 0;
    if (!options.exportedAs.empty() && !endsItself && !hasPage())
        showMessage(options.exportedAs, error.text());
    return 1;
}

}  // namespace

std::string exportedName(std::string_view program, std::string_view built) {
    std::error_code ignored;
    const Path real = std::filesystem::canonical(program, ignored);  // it may be a link
    const Path name = (real.empty() ? Path{program} : real).filename();
    if (name.empty() || name == built || name == format("{}.exe", built)) return {};
    return name.extension() == ".exe" ? name.stem().string() : name.string();
}

int playProject(const PlayerOptions& asked, const Module& code) {
    if (asked.benchmark) return benchmark(asked);
    Result<Project> project = openProject(asked);
    if (!project) return refuse(project.error(), asked);
    const Result<PlayerOptions> started = begun(asked, project->name);
    if (!started) {
        logError("Input", started.error());
        return 1;
    }
    const PlayerOptions& options = *started;
    for (const Error& warning : project->warnings) {
        logWarning("Engine", warning);
    }
    std::vector<Error> problems;
    GameContent content{code, problems};
    content.readScripts(project->root, problems);
    if (!problems.empty()) {
        const int exitCode = refuse(problems.front(), options);
        for (std::size_t i = 1; i < problems.size(); ++i) logError("Code", problems[i]);
        return exitCode;
    }
    warnOfMissingCode(*project, code);
    std::unique_ptr<Screen> screen;
    if (!options.headless && !options.effects) {
        Result<std::unique_ptr<Screen>> opened = Screen::open(screenOf(*project, options));
        if (!opened) return refuse(opened.error(), options);
        screen = std::move(*opened);
    }
    SceneGame game{std::move(*project), options.scene, seedOf(options), content};
    game.input.logging = screen != nullptr;
    game.onCreate();
    if (const std::optional<Error>& failure = game.failure()) return refuse(*failure, options);
    if (options.effects) {
        listEffects(game, options);
        return 0;
    }
    GameContent* edited = options.exportedAs.empty() ? &content : nullptr;  // an export has no files to edit
    const int exitCode = GameLoop{game, screen.get(), options, game.project().name, edited}.run();
    screen.reset();  // before the assets that its textures refer to
    return exitCode;
}

}  // namespace plumb
