#include "app/game_loop.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <thread>
#include <utility>

#include "app/recording/replay_choice.hpp"
#include "core/clock.hpp"
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
constexpr std::int64_t kHeadlessTicks = 600;  ///< default number of ticks of a headless run
constexpr const char* kEngineVersion = "0.1.0";

void sleepSeconds(double seconds) {
    if (seconds > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>{seconds});
}

bool isFullscreenKey(const Event& event) {
    return event.kind == EventKind::KeyDown && !event.repeated &&
           (event.key == Key::F11 || (event.key == Key::Enter && event.modifiers.alt));
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

GameLoop::GameLoop(Game& game, Screen* screen, const PlayerOptions& options, std::string projectName,
                   GameContent* edited)
    : game_{game},
      screen_{screen},
      options_{options},
      projectName_{std::move(projectName)},
      edited_{game, edited} {
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
    return failed_ || records_.failed() ? 1 : 0;
}

bool GameLoop::prepare() {
    if (isReplayed(options_) && !beginReplay()) return false;
    game_.threads.setThreads(options_.threads);
    const bool hasDisplay = screen_ != nullptr && screen_->window().hasDisplay();
    if (screen_ != nullptr && !hasDisplay && options_.frames < 0 && !replay_) {
        logNote("Engine", "No display: running 10 s offscreen and saving a screenshot");
        options_.frames = kDemoTicks;
        if (options_.screenshot.empty()) options_.screenshot = "plumb-screenshot.png";
    }
    if (screen_ == nullptr && options_.frames < 0 && !replay_) options_.frames = kHeadlessTicks;
    if (screen_ != nullptr) player_.emplace(options_, projectName_, *screen_, *sounds_, pacer_, game_.input);
    if (!chooseKeys() || !beginWithState()) return false;
    if (const Result<Path> folder = playerFolder(options_, projectName_); !folder) {
        noSlots_ = folder.error();
        logWarning("Game", *noSlots_);
    } else if (!folder->empty()) {
        slots_.emplace(*folder, projectName_);
    }
    const bool isPlayed = hasDisplay && !replay_ && !options_.allEffects;
    const Result<Path> crashes = isPlayed ? dataFolder(projectName_) : Path{};
    return records_.begin(options_, start(),
                          {screen_ != nullptr, isPlayed, screen_ != nullptr && hasPage(),
                           crashes ? *crashes : Path{}, replay_ ? &*replay_ : nullptr});
}

/// What a record of this run begins with.
Replay GameLoop::start() const {
    Replay start;
    start.project = projectName_;
    start.engine = kEngineVersion;
    start.scene = options_.scene;
    start.seed = seedOf(options_);
    if (replay_) start.state = replay_->state;
    start.keys = replayPlayer_ ? replay_->keys : player_ ? player_->keyChanges() : std::string{};
    return start;
}

bool GameLoop::beginReplay() {
    Result<Replay> replay = replayOf(options_);
    if (!replay) {
        logError("Input", replay.error());
        return false;
    }
    goesOnLive_ = !options_.link.empty() && screen_ != nullptr && !isLockstep();
    if (goesOnLive_ && replay->ticks() == 0) return true;  // live from the beginning
    replay_ = std::move(*replay);
    replayPlayer_.emplace(*replay_);
    if (!goesOnLive_) return true;
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
    pacer_.setRefreshRate(refreshRate());
    before_ = wallSeconds();
    rateStart_ = before_;
    runFrames([this, lockstep] {
        runFrame(lockstep);  // once also for --frames 0, whose picture is that of the start
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
        // An exported game shows its physics only if its command line asks for it.
        const bool isOfView = options_.exportedAs.empty() && options_.physicsView.handle(event);
        if (isOfView && options_.physicsView.on)
            logNote("Engine",
                    "Physics view on: Ctrl+digit and Ctrl+Shift+digit toggle layers, F3 turns it off");
        if (isFullscreenKey(event)) {
            screen_->window().setFullscreen(!screen_->window().fullscreen());
            player_->setFullscreen(screen_->window().fullscreen());
            continue;  // Enter of Alt+Enter confirms nothing
        }
        if (event.kind == EventKind::FocusLost || event.kind == EventKind::FocusGained) {
            focusLost_ = event.kind == EventKind::FocusLost;
            sounds_->setPaused(focusLost_);
        }
        if (player_->handle(event)) {
            devices_.releaseAll();
        } else {
            if (!isOfView && isPress(event)) takeOver();
            devices_.handle(event);
        }
    }
    if (player_->takeKeysChanged()) records_.changed("keys were changed", game_.world.hash());
    if (player_->quits()) quit();
    followPause();
}

/// The game rests while another window has the focus or the player changes the options.
void GameLoop::followPause() { focusLost_ || player_->isOpen() ? pacer_.pause() : pacer_.resume(); }

/// Input means what its keys say: those of the player. Replayed input means what it meant when it was
/// recorded.
bool GameLoop::chooseKeys() {
    if (player_) player_->allowKeys(!replayPlayer_ && options_.record.empty());
    if (!replayPlayer_) {
        if (player_) player_->useKeys();
        return true;
    }
    if (const Result<Done> used = useReplayedKeys(game_.input, *replay_, nameOfReplay(options_)); !used) {
        logError("Input", used.error());
        return false;
    }
    return true;
}

/// Begins a replay with the saved game that was loaded before it.
bool GameLoop::beginWithState() {
    if (!replay_ || replay_->state.empty()) return true;
    const std::string where = nameOfReplay(options_) + ": state";
    std::vector<Error> problems;
    const Result<Snapshot> state = readSavedGame(replay_->state, game_.world, projectName_, where, problems);
    if (!state) {
        logError("Input", state.error());
        return false;
    }
    for (const Error& problem : problems) logWarning("Input", problem);
    if (const Result<Done> loaded = game_.load(*state); !loaded) {
        logError("Input", loaded.error());
        return false;
    }
    return true;
}

/// Reloads files that were edited while the game runs, but not while it is recorded or replayed.
void GameLoop::reloadEdited() {
    if (replayPlayer_ || records_.exact() || !edited_.look(wallSeconds())) return;
    records_.changed("files of the project were changed", game_.world.hash());
    edited_.take();
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
    return true;
}

void GameLoop::tick() {
    InputFrame frame;
    if (!nextInput(frame)) {
        noteEndOfCrash(*replay_, ticks_);
        quit();
        return;
    }
    records_.tickBegins(frame);
    tickGame(game_, frame);
    records_.tickEnds(game_.world);
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
}

/// Compares the state with the recorded one, and lets a replay that has ended go on live.
void GameLoop::checkReplay() {
    const HashCheck* expected = replayPlayer_->checkpoint();
    const bool differs = expected != nullptr && expected->hash != game_.world.hash();
    if (differs) {
        const std::string engine =
            replay_->engine == kEngineVersion
                ? std::string{}
                : format(", or the engine, then {}, now {}", replay_->engine, kEngineVersion);
        logError("Input",
                 Error{nameOfReplay(options_),
                       format("the simulation differs from the recorded one at tick {}: the scenes or the "
                              "code of \"{}\" have changed since{}",
                              ticks_, projectName_, engine),
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
    if (player_->keyChanges() != replay_->keys) {
        player_->useKeys();
        records_.changed("other keys than those of the replay were used", game_.world.hash());
    }
    player_->allowKeys(options_.record.empty());
    screen_->window().setTitle(projectName_);
    tellPage("live", why);
}

/// Offers the page a link of the run. Does nothing without a page.
void GameLoop::beginPage() {
    if (!hasPage()) return;
    offerLink([this](bool afterFailure) {
        const Result<std::string> made =
            records_.link(afterFailure ? std::nullopt : std::optional{game_.world.hash()});
        return made ? *made : std::string{};
    });
}

/// Tells the page which buttons a touch screen needs now: those that the game asks for.
void GameLoop::updatePage() {
    if (!hasPage() || ticks_ % kControlTicks != 0) return;
    if (shownControls_.look(game_.input)) tellPage("controls", shownControls_.text());
}

/// Saves or loads what the tick requested.
void GameLoop::performRequests() {
    auto* requests = game_.world.findResource<GameRequests>();
    if (requests == nullptr) return;
    const GameRequests wanted = std::exchange(*requests, {});
    if (wanted.options && player_ && !replayPlayer_ && !isLockstep()) {
        player_->open();
        followPause();
    }
    if (noSlots_ && !replayPlayer_) {
        if (wanted.save != 0 || wanted.load != 0)
            fail(wanted.load != 0 ? "Not loaded" : "Not saved", *noSlots_);
        return;
    }
    if (!slots_ || replayPlayer_) {
        if (wanted.save != 0 || wanted.load != 0)
            logNote("Game", "Not {}: {}", wanted.load != 0 ? "loaded" : "saved",
                    replayPlayer_ ? "a replay uses no saved games"
                                  : "without a player, --saves names the folder of saved games");
        return;
    }
    if (wanted.save != 0) {
        const Result<Done> saved = slots_->save(game_.world, wanted.save);
        if (saved) {
            logNote("Game", "Saved in slot {}", wanted.save);
            tellPage("saved", "");
        } else {
            fail("Not saved", saved.error());
        }
    }
    if (wanted.load != 0) loadSaved(wanted.load);
}

/// Says that saving or loading has failed.
void GameLoop::fail(std::string_view what, const Error& error) {
    logError("Game", error);
    if (player_) player_->notify(what, error);
}

void GameLoop::loadSaved(int slot) {
    const std::uint64_t before = game_.world.hash();
    Result<SaveSlots::Saved> saved = slots_->read(game_.world, slot);
    if (!saved) return fail("Not loaded", saved.error());
    if (const Result<Done> loaded = game_.load(saved->state); !loaded)
        return fail("Not loaded", loaded.error());
    devices_.releaseAll();  // the key that loads the game is not pressed again in it
    if (sounds_) sounds_->restart();
    logNote("Game", "Loaded slot {}", slot);
    records_.loaded(std::move(saved->file), player_ ? player_->keyChanges() : std::string{}, before);
}

PhysicsShown GameLoop::shownPhysics() {
    PhysicsShown shown = options_.physicsView.shown();
    shown.times = &physicsTimes_;
    physicsTimes_.watch(game_.world, (shown.any() & kPhysicsTimes) != 0);
    return shown;
}

void GameLoop::drawFrame(float alpha) {
    screen_->draw(game_.world, game_.assets, alpha, shownPhysics());
    player_->draw(game_.assets);
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
    if (player_) player_->write();
    records_.end(game_.world);
    if (options_.printLink) {
        if (const Result<std::string> made = records_.link(game_.world.hash()); made) {
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
