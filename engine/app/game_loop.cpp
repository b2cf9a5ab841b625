#include "app/game_loop.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <thread>
#include <utility>

#include "app/touch_controls.hpp"
#include "core/clock.hpp"
#include "core/crash_report.hpp"
#include "core/log.hpp"
#include "gameplay/game_requests.hpp"
#include "platform/display.hpp"
#include "platform/gl_profile.hpp"
#include "platform/image_file.hpp"
#include "platform/main_loop.hpp"
#include "platform/page.hpp"
#include "platform/paths.hpp"

namespace plumb {
namespace {

constexpr std::int64_t kDemoTicks = 600;      ///< default number of ticks without a display: 10 s
constexpr double kPausedWait = 0.1;           ///< s for which a paused game waits for events
constexpr std::int64_t kControlTicks = 30;    ///< ticks between two looks at what the game asks for
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

bool isReplayed(const PlayerOptions& options) { return !options.replay.empty() || !options.link.empty(); }

std::string nameOfReplay(const PlayerOptions& options) {
    return options.link.empty() ? options.replay : "link";
}

Result<Replay> replayOf(const PlayerOptions& options) {
    return options.link.empty() ? loadReplay(options.replay) : replayOfLink(options.link);
}

/// True for what ends a replay in favour of the player.
bool isPress(const Event& event) {
    return (event.kind == EventKind::KeyDown && !event.repeated && !isFullscreenKey(event)) ||
           event.kind == EventKind::MouseDown || event.kind == EventKind::PadDown;
}

}  // namespace

Result<Done> saveScreenshot(Screen& screen, const Path& path) {
    const Result<std::string> png = encodePng(screen.picture());
    return png ? writeFile(path, *png) : png.error();
}

Result<PlayerOptions> begunAsRecorded(PlayerOptions options, std::string_view projectName) {
    if (!isReplayed(options)) return options;
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
    if (isReplayed(options_) && !beginReplay()) return false;
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
    if (options_.printLink || (screen_ != nullptr && hasPage())) link_.emplace(recorder_.replay);
    if (screen_ != nullptr && !screen_->window().hasDisplay() && options_.frames < 0 && !replay_) {
        logNote("Engine", "No display: running 10 s offscreen and saving a screenshot");
        options_.frames = kDemoTicks;
        if (options_.screenshot.empty()) options_.screenshot = "plumb-screenshot.png";
    }
    if (screen_ == nullptr && options_.frames < 0 && !replay_) options_.frames = kHeadlessTicks;
    // A replay reads and writes no files, and a run without a window none of the player.
    const bool saves = !replay_ && (screen_ != nullptr || !options_.saves.empty());
    if (saves)
        slots_.emplace(options_.saves.empty() ? dataFolder(projectName_) : Path{options_.saves},
                       projectName_);
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

bool GameLoop::beginReplay() {
    Result<Replay> replay = replayOf(options_);
    if (!replay) {
        logError("Input", replay.error());
        return false;
    }
    replay_ = std::move(*replay);
    replayPlayer_.emplace(*replay_);
    goesOnLive_ = !options_.link.empty() && screen_ != nullptr && !isLockstep();
    if (!goesOnLive_) return true;
    if (replay_->ticks() == 0) replayPlayer_.reset();  // live from the beginning
    logNote("Input", "Replaying {} ticks: press any key to take over", replay_->ticks());
    screen_->window().setTitle(projectName_ + " (replay: any key takes over)");
    tellPage("replay", format("{}", replay_->ticks()));
    return true;
}

/// True for one tick per frame, independent of the clock, so that saved images belong to known ticks.
bool GameLoop::isLockstep() const { return !screen_->window().hasDisplay() || !options_.capture.empty(); }

void GameLoop::runHeadless() {
    while (running_ && ticks_ != options_.frames) {
        tick();
    }
    finish();
}

void GameLoop::runScreen() {
    const bool lockstep = isLockstep();
    beginPage();
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

/// @param lockstep  see isLockstep()
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
        const bool isOfView = options_.physicsView.handle(event);
        if (isOfView && options_.physicsView.on)
            logNote("Engine",
                    "Physics view on: Ctrl+digit and Ctrl+Shift+digit toggle layers, F3 turns it off");
        if (!isOfView && isPress(event)) takeOver();
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
    if (replayPlayer_ || recording_ || link_) return;
    const std::vector<AssetChange> changes = game_.assets.pollChanges();
    if (changes.empty()) return;
    if (crashFile_) crashFile_->changed();
    game_.followChanges(changes);
}

bool GameLoop::nextInput(InputFrame& frame) {
    const InputFrame live = devices_.take();  // during a replay too: nothing is kept for later
    if (replayPlayer_) {
        const InputFrame* recorded = replayPlayer_->next();
        if (recorded == nullptr) return false;
        frame = *recorded;
    } else {
        frame = live;
        if (screen_ != nullptr) screen_->placeMouse(frame);
        if (slots_) frame.saves = slots_->filled();
    }
    record(frame);
    return true;
}

/// Records the input before the tick, so that a recording contains the tick in which the game crashes.
void GameLoop::record(const InputFrame& frame) {
    if (link_) link_->record(frame);
    if (!recording_) return;
    recorder_.record(frame);
    updateRecording();
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
    performRequests();
    if (screen_ != nullptr) events_.write(game_.world);
    if (sounds_) sounds_->listen(game_.world);
    if (replayPlayer_) checkReplay();
    if (options_.hashEvery > 0 && ticks_ % options_.hashEvery == 0) {
        std::printf("hash %lld: %s\n", static_cast<long long>(ticks_), hexText(game_.world.hash()).c_str());
    }
    if (screen_ != nullptr) updatePage();
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

/// Compares the state with the recorded one, and lets a replay that has ended go on live.
void GameLoop::checkReplay() {
    const HashCheck* expected = replayPlayer_->checkpoint();
    const bool differs = expected != nullptr && expected->hash != game_.world.hash();
    if (differs) {
        logError("Input",
                 Error{nameOfReplay(options_),
                       format("the simulation differs from the recorded one at tick {}: the scenes or the "
                              "code of \"{}\" have changed since, or the engine, then {}, now {}",
                              ticks_, projectName_, replay_->engine, kEngineVersion),
                       "play it with the version that recorded it; record again if the game was changed "
                       "on purpose"});
        if (!goesOnLive_) {
            failed_ = true;
            quit();
        }
    }
    if (!goesOnLive_ || replayPlayer_->tick() != replay_->ticks()) return;
    const std::string_view result = differs               ? "the state differs from the recorded one"
                                    : expected != nullptr ? "the state is the recorded one"
                                                          : "the recording contains no hash";
    goOnLive(format("The replay has ended: {} (hash {})", result, hexText(game_.world.hash())));
}

/// Ends a replay because the player has pressed a key or button, which the game receives too.
void GameLoop::takeOver() {
    if (replayPlayer_ && goesOnLive_) goOnLive(format("You play from tick {} on", ticks_));
}

/// Ends the replay; the devices give the input of the next tick.
void GameLoop::goOnLive(const std::string& why) {
    replayPlayer_.reset();
    logNote("Input", "{}", why);
    screen_->window().setTitle(projectName_);
    tellPage("live", why);
}

Result<std::string> GameLoop::link(bool withHash) const {
    return link_->link(withHash ? std::optional{game_.world.hash()} : std::nullopt);
}

/// Offers the page a link of the run. Does nothing without a page.
void GameLoop::beginPage() {
    if (!hasPage()) return;
    offerLink([this](bool afterFailure) {
        const Result<std::string> made = link(!afterFailure);
        return made ? *made : std::string{};
    });
}

/// Tells the page which buttons a touch screen needs now: those that the game asks for.
void GameLoop::updatePage() {
    if (!hasPage() || ticks_ % kControlTicks != 0) return;
    const Input::Asked asked = game_.input.takeAsked();
    if (asked == shownControls_) return;
    shownControls_ = asked;
    tellPage("controls", touchControls(game_.input.map(), asked));
}

/// Saves or loads what the tick requested.
void GameLoop::performRequests() {
    auto* requests = game_.world.findResource<GameRequests>();
    if (requests == nullptr) return;
    const GameRequests wanted = std::exchange(*requests, {});
    if (!slots_) {
        if (wanted.save != 0 || wanted.load != 0)
            logNote(
                "Game", "Not {}: {}", wanted.load != 0 ? "loaded" : "saved",
                replay_ ? "a replay uses no saved games" : "without a window, --saves names their folder");
        return;
    }
    if (wanted.save != 0) {
        const Result<Done> saved = slots_->save(game_.world, wanted.save);
        saved ? logNote("Game", "Saved in slot {}", wanted.save) : logError("Game", saved.error());
    }
    if (wanted.load != 0) loadSaved(wanted.load);
}

void GameLoop::loadSaved(int slot) {
    const std::uint64_t before = recording_ ? game_.world.hash() : 0;
    const Result<Done> loaded = slots_->load(game_.world, slot);
    if (!loaded) return logError("Game", loaded.error());
    game_.onLoaded();
    logNote("Game", "Loaded slot {}", slot);
    if (!recording_) return;
    // A replay begins with a scene, and must not depend on files of the player.
    recorder_.check(before);
    updateRecording();
    recording_.reset();
    logWarning("Input", Error{options_.record,
                              format("the recording ends with tick {}: a saved game was loaded", ticks_),
                              "record without loading to get a longer one"});
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
    if (isContextLost() && !canContextReturn()) {
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
    if (options_.printLink) {
        if (const Result<std::string> made = link(true); made) {
            std::printf("link: %s\n", made->c_str());
        } else {
            logError("Input", made.error());
            failed_ = true;
        }
    }
    tellPage("ended", "");
    if (options_.hash) std::printf("hash: %s\n", hexText(game_.world.hash()).c_str());
}

}  // namespace plumb
