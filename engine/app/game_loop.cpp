#include "app/game_loop.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <thread>

#include "core/clock.hpp"
#include "core/crash_report.hpp"
#include "core/log.hpp"
#include "platform/display.hpp"
#include "platform/gl_profile.hpp"
#include "platform/image_file.hpp"
#include "platform/main_loop.hpp"
#include "platform/paths.hpp"

namespace plumb {
namespace {

constexpr std::int64_t kDemoTicks = 600;      ///< default number of ticks without a display: 10 s
constexpr double kPausedWait = 0.1;           ///< s for which a paused game waits for events
constexpr std::int64_t kCheckTicks = 600;     ///< ticks between two hashes of a recording
constexpr std::int64_t kHeadlessTicks = 600;  ///< default number of ticks of a headless run
constexpr double kLongestTick = 5.0;          ///< s: a tick that takes longer is reported as a hang
constexpr const char* kEngineVersion = "0.1.0";

void sleepSeconds(double seconds) {
    if (seconds > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>{seconds});
}

bool isFullscreenKey(const Event& event) {
    return event.kind == EventKind::KeyDown && !event.repeated &&
           (event.key == Key::F11 || (event.key == Key::Enter && event.modifiers.alt));
}

}  // namespace

Result<Done> saveScreenshot(Screen& screen, const Path& path) {
    const Result<std::string> png = encodePng(screen.picture());
    return png ? writeFile(path, *png) : png.error();
}

Result<PlayerOptions> begunAsRecorded(PlayerOptions options, std::string_view projectName) {
    if (options.replay.empty()) return options;
    const Result<Replay> replay = loadReplay(options.replay);
    if (!replay) return replay.error();
    if (!replay->project.empty() && replay->project != projectName) {
        return Error{
            options.replay,
            format("it was recorded by the project \"{}\", and this is \"{}\"", replay->project, projectName),
            "play it with that project; if this one was renamed, change the second line of the file"};
    }
    options.seed = replay->seed;
    options.scene = replay->scene;
    return options;
}

GameLoop::GameLoop(Game& game, Screen* screen, const PlayerOptions& options, std::string projectName)
    : game_{game}, screen_{screen}, options_{options}, projectName_{std::move(projectName)} {
    if (screen_ != nullptr) sounds_.emplace(game_.assets);
    if (!options_.allEffects) return;
    for (const EffectRow& row : game_.effects.table().rows()) game_.effects.setProgramPin(row.name, Pin::On);
}

int GameLoop::run() {
    if (!prepare()) return 1;
    logNote("Engine", "Starting game loop...");
    if (screen_ == nullptr) {
        runHeadless();
    } else {
        runScreen();
    }
    return failed_ ? 1 : 0;
}

bool GameLoop::prepare() {
    if (!options_.replay.empty()) {
        Result<Replay> replay = loadReplay(options_.replay);
        if (!replay) {
            logError("Input", replay.error());
            return false;
        }
        replay_ = std::move(*replay);
        replayPlayer_.emplace(*replay_);
    }
    game_.threads.setThreads(options_.threads);
    recorder_.replay.project = projectName_;
    recorder_.replay.engine = kEngineVersion;
    recorder_.replay.scene = options_.scene;
    recorder_.replay.seed = seedOf(options_);
    if (!options_.record.empty()) {
        Result<RecordingFile> file = RecordingFile::create(options_.record, recorder_.replay);
        if (!file) {
            logError("Input", file.error());
            return false;
        }
        recording_ = std::move(*file);
    }
    if (screen_ != nullptr && !screen_->window().hasDisplay() && options_.frames < 0 &&
        options_.replay.empty()) {
        logNote("Engine", "No display: running 10 s offscreen and saving a screenshot");
        options_.frames = kDemoTicks;
        if (options_.screenshot.empty()) options_.screenshot = "plumb-screenshot.png";
    }
    if (screen_ == nullptr && options_.frames < 0 && !replay_) options_.frames = kHeadlessTicks;
    return prepareCrashFile();
}

/// Without an option, a game that is played in a window leaves a file in its data folder.
bool GameLoop::prepareCrashFile() {
    if (!canReportCrashes()) return true;
    const bool isAsked = !options_.crashReports.empty();
    const bool isPlayed =
        screen_ != nullptr && screen_->window().hasDisplay() && !replay_ && !options_.allEffects;
    Path folder = isAsked ? Path{options_.crashReports} : isPlayed ? dataFolder(projectName_) : Path{};
    std::error_code failed;
    if (isAsked) std::filesystem::create_directories(folder, failed);
    if (failed) {
        logError("Engine",
                 Error{folder.generic_string(), "the folder for reports of crashes cannot be created",
                       "choose another one with --crash-reports"});
        return false;
    }
    if (folder.empty() && !replay_) return true;
    const std::string threads =
        options_.threads > 0 ? format("{} threads", options_.threads) : std::string{"automatic threads"};
    crashFile_.emplace(
        recorder_.replay, folder,
        format("{}, {} of the physics", screen_ == nullptr ? "headless" : "in a window", threads),
        replay_ ? &*replay_ : nullptr);
    watchdog_.emplace(kLongestTick, &reportHang);
    return true;
}

void GameLoop::runHeadless() {
    while (running_ && ticks_ != options_.frames) {
        tick();
    }
    finish();
}

void GameLoop::runScreen() {
    // One tick per frame, independent of the clock, so that saved images belong to known ticks.
    const bool lockstep = !screen_->window().hasDisplay() || !options_.capture.empty();
    pacer_ = FramePacer{refreshRate()};
    before_ = wallSeconds();
    rateStart_ = before_;
    runFrames([this, lockstep] {
        if (running_ && ticks_ != options_.frames) runFrame(lockstep);
        const bool goesOn = running_ && ticks_ != options_.frames;
        if (!goesOn) finish();
        return goesOn;
    });
}

/// @param lockstep  one tick, whatever time has passed
void GameLoop::runFrame(bool lockstep) {
    openDevices();
    handleEvents();
    if (!lockstep) reloadEdited();
    const double now = wallSeconds();
    const StepClock::Frame frame = lockstep ? StepClock::Frame{1, 1.0f} : pacer_.next(now - before_);
    before_ = now;
    for (int i = 0; i < frame.ticks && running_ && ticks_ != options_.frames; ++i) {
        tick();
    }
    sounds_->play();
    drawFrame(ticks_ == 0 ? 1.0f : frame.alpha);
    if (!lockstep && canWait()) sleepSeconds(pacer_.rest(wallSeconds() - before_));
    reportRate();
}

/// Opens the gamepads when the effect "pads" runs; they stay open. The audio device is opened by SoundOutput.
void GameLoop::openDevices() {
    if (padsOpen_ || !game_.effects.runs(game_.world, "pads")) return;
    padsOpen_ = true;
    screen_->window().openPads();
    game_.effects.count("pads");
}

void GameLoop::handleEvents() {
    pending_.clear();
    if (pacer_.paused() && canWait()) {
        screen_->window().waitEvents(pending_, kPausedWait);  // paused: use no CPU time
    } else {
        screen_->window().pollEvents(pending_);
    }
    for (const Event& event : pending_) {
        if (event.kind == EventKind::Quit) quit();
        if (options_.physicsView.handle(event) && options_.physicsView.on)
            logNote("Engine",
                    "Physics view on: Ctrl+digit and Ctrl+Shift+digit toggle layers, F3 turns it off");
        if (isFullscreenKey(event)) screen_->window().setFullscreen(!screen_->window().fullscreen());
        if (event.kind == EventKind::FocusLost) {
            pacer_.pause();
            sounds_->setPaused(true);
            devices_.releaseAll();
        }
        if (event.kind == EventKind::FocusGained) {
            pacer_.resume();
            sounds_->setPaused(false);
        }
        devices_.handle(event);
    }
}

/// Reloads files that were edited while the game runs, but not while it is recorded or replayed.
void GameLoop::reloadEdited() {
    if (replayPlayer_ || recording_) return;
    const std::vector<AssetChange> changes = game_.assets.pollChanges();
    if (changes.empty()) return;
    if (crashFile_) crashFile_->changed();
    game_.followChanges(changes);
}

bool GameLoop::nextInput(InputFrame& frame) {
    if (replayPlayer_) {
        const InputFrame* recorded = replayPlayer_->next();
        if (recorded == nullptr) return false;
        frame = *recorded;
    } else {
        frame = devices_.take();
        if (screen_ != nullptr) screen_->placeMouse(frame);
    }
    if (recording_) {
        // Before the tick, so that the file contains the tick in which the game crashes.
        recorder_.record(frame);
        updateRecording();
    }
    return true;
}

/// Writes what the recorder has to the file. Ends the recording, but not the game, if that is impossible.
void GameLoop::updateRecording() {
    const Result<Done> written = recording_->update(recorder_);
    if (written) return;
    logError("Input", written.error());
    recording_.reset();
    failed_ = true;
}

void GameLoop::tick() {
    InputFrame frame;
    if (!nextInput(frame)) {
        noteEndOfCrash();
        quit();
        return;
    }
    simulate(frame);
    ++ticks_;
    if (game_.quitRequested()) quit();
    if (screen_ != nullptr) events_.write(game_.world);
    if (sounds_) sounds_->listen(game_.world);
    checkReplay();
    if (options_.hashEvery > 0 && ticks_ % options_.hashEvery == 0) {
        std::printf("hash %lld: %s\n", static_cast<long long>(ticks_), hexText(game_.world.hash()).c_str());
    }
    if (recording_ && ticks_ % kCheckTicks == 0) recorder_.check(game_.world.hash());
    if (crashFile_ && ticks_ % CrashFile::kCheckTicks == 0) crashFile_->check(game_.world.hash());
}

void GameLoop::simulate(const InputFrame& frame) {
    if (!crashFile_) return tickGame(game_, frame);
    crashFile_->tickBegins(frame);
    watchdog_->begin();
    tickGame(game_, frame);
    watchdog_->end();
    crashFile_->tickEnds();
}

/// Ends the game if its state differs from the recorded one.
void GameLoop::checkReplay() {
    const HashCheck* expected = replayPlayer_ ? replayPlayer_->checkpoint() : nullptr;
    if (expected == nullptr || expected->hash == game_.world.hash()) return;
    logError("Input",
             Error{options_.replay,
                   format("the simulation differs from the recorded one at tick {}: the scenes or the "
                          "code of \"{}\" have changed since, or the engine, then {}, now {}",
                          ticks_, projectName_, replay_->engine, kEngineVersion),
                   "play it with the version that recorded it; record again if the game was changed "
                   "on purpose"});
    failed_ = true;
    quit();
}

/// Says that the report of a crash has been replayed to its end without that crash.
void GameLoop::noteEndOfCrash() {
    const RecordedCrash& crash = replay_->crash;
    if (crash.what.empty()) return;
    const std::string build = buildId();
    logNote(
        "Input",
        "The replay ends at tick {}, where the game crashed: {}. It has not crashed again{}: the cause is "
        "not in the simulation, or it depends on the machine.",
        ticks_, crash.what,
        crash.build == build ? std::string{} : format(", in build {} instead of {}", build, crash.build));
}

PhysicsShown GameLoop::shownPhysics() {
    PhysicsShown shown = options_.physicsView.shown();
    shown.times = &physicsTimes_;
    physicsTimes_.watch(game_.world, (shown.any() & kPhysicsTimes) != 0);
    return shown;
}

void GameLoop::drawFrame(float alpha) {
    screen_->draw(game_.world, game_.assets, alpha, shownPhysics());
    if (!options_.capture.empty()) {
        std::string number = format("{}", framesDrawn_);
        number.insert(0, number.size() < 6 ? 6 - number.size() : 0, '0');
        const Path path = Path{options_.capture} / (number + ".png");
        if (const auto saved = saveScreenshot(*screen_, path); !saved) logError("Engine", saved.error());
    }
    if (!options_.screenshot.empty() && (ticks_ == options_.frames || !running_)) {
        const auto saved = saveScreenshot(*screen_, options_.screenshot);
        if (saved) {
            logNote("Engine", "Saved {}", options_.screenshot);
        } else {
            logError("Engine", saved.error());
            failed_ = true;
        }
    }
    screen_->swap();
    ++framesDrawn_;
    if (isContextLost()) {
        setCrashReason("the graphics device was lost");
        std::abort();
    }
}

void GameLoop::reportRate() {
    ++rateFrames_;
    const double now = wallSeconds();
    if (now - rateStart_ < 1.0) return;
    logNote("Engine", "FPS: {} | Entities: {} | Draw calls: {}",
            fixedText(static_cast<double>(rateFrames_) / (now - rateStart_), 1), game_.world.entityCount(),
            screen_->drawCalls());
    rateStart_ = now;
    rateFrames_ = 0;
}

void GameLoop::finish() {
    if (recording_) {
        recorder_.check(game_.world.hash());
        updateRecording();
    }
    if (options_.hash) std::printf("hash: %s\n", hexText(game_.world.hash()).c_str());
}

}  // namespace plumb
