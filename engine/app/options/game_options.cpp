#include "app/options/game_options.hpp"

#include <algorithm>
#include <utility>

#include "app/options/options_view.hpp"
#include "core/clock.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "platform/page.hpp"
#include "platform/paths.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"

namespace plumb {
namespace {

constexpr double kNoticeSeconds = 5.0;
constexpr std::string_view kFile = "settings.json";

PlayerSettings projectSettings(const ScreenSettings& screen, const ActionMap& keys) {
    PlayerSettings settings;
    settings.fullscreen = screen.standardFullscreen;
    settings.keys = keys;
    return settings;
}

Result<Path> fileOf(const PlayerOptions& options, std::string_view project) {
    Result<Path> folder = playerFolder(options, project);
    if (folder && !folder->empty()) *folder /= kFile;
    return folder;
}

/// For one line in the window: the place in the file is part of what is wrong, the folder is not.
Error inFile(Error error, const Path& file) {
    const std::string folder = (file.parent_path() / "").generic_string();
    const std::string place =
        startsWith(error.where, folder) ? error.where.substr(folder.size()) : error.where;
    error.what = format("{}: {}", place, error.what);
    return error;
}

bool has(const std::vector<Binding>& bindings, BindingKind kind, std::uint8_t code) {
    return std::any_of(bindings.begin(), bindings.end(),
                       [&](const Binding& binding) { return binding.kind == kind && binding.code == code; });
}

/// True if an action or an axis of the game has the key or button.
bool isBound(const ActionMap& map, BindingKind kind, std::uint8_t code) {
    return std::any_of(map.actions.begin(), map.actions.end(),
                       [&](const ActionBindings& action) { return has(action.bindings, kind, code); }) ||
           std::any_of(map.axes.begin(), map.axes.end(), [&](const AxisBindings& axis) {
               return has(axis.negative, kind, code) || has(axis.positive, kind, code);
           });
}

}  // namespace

Result<Path> playerFolder(const PlayerOptions& options, std::string_view project) {
    if (!options.replay.empty()) return Path{};
    if (!options.saves.empty()) return Path{options.saves};
    const bool endsItself = options.frames >= 0 || !options.screenshot.empty() || !options.capture.empty();
    return options.headless || endsItself ? Path{} : dataFolder(project);
}

ScreenSettings withPlayerSettings(ScreenSettings settings, const PlayerOptions& options,
                                  std::string_view project) {
    settings.standardFullscreen = settings.fullscreen;
    const Result<Path> file = fileOf(options, project);
    if (!file || file->empty() || options.safe || !fileExists(*file)) return settings;
    // Problems are reported later, when the keys are read, too.
    std::vector<Error> ignored;
    const PlayerSettings player = readSettings(*file, projectSettings(settings, {}), ignored);
    settings.fullscreen = player.fullscreen;
    if (player.scale > 0) {
        settings.standardWidth = settings.windowWidth;
        settings.standardHeight = settings.windowHeight;
        settings.windowWidth = static_cast<int>(settings.picture.x) * player.scale;
        settings.windowHeight = static_cast<int>(settings.picture.y) * player.scale;
    }
    return settings;
}

GameOptions::GameOptions(const PlayerOptions& options, std::string_view project, Screen& screen,
                         SoundOutput& sounds, FramePacer& pacer, Input& input)
    : file_{fileOf(options, project)},
      project_{projectSettings(screen.settings(), input.map())},
      applied_{read(options.safe)},
      written_{applied_},
      windowScale_{applied_.scale},
      menu_{applied_, project_},
      screen_{screen},
      sounds_{sounds},
      pacer_{pacer},
      input_{input} {
    // The window is open already, in the mode of the settings or of the command line.
    applied_.fullscreen = screen.window().fullscreen();
    menu_.setFullscreen(applied_.fullscreen);
    screen_.window().setVsync(applied_.vsync);
    pacer_.setCap(applied_.frameCap);
    sounds_.setVolumes(applied_.master, applied_.music, applied_.sounds);
}

PlayerSettings GameOptions::read(bool safe) {
    std::vector<Error> warnings;
    if (!file_ || file_->empty() || safe) {
        keepsFormer_ = safe;
        return project_;
    }
    PlayerSettings settings = readSettings(*file_, project_, warnings);
    for (const Error& warning : warnings) logWarning("Settings", warning);
    keepsFormer_ = !warnings.empty();
    if (!warnings.empty()) notify("Some settings are those of the game", inFile(warnings.front(), *file_));
    return settings;
}

/// The largest multiple of the game's resolution that fits on the display.
int GameOptions::mostScale() const {
    const PixelSize room = screen_.window().largestSize();
    const Vec2 picture = screen_.settings().picture;
    const int most = static_cast<int>(
        std::min(static_cast<float>(room.width) / picture.x, static_cast<float>(room.height) / picture.y));
    return room == PixelSize{} ? PlayerSettings::kMostScale : std::clamp(most, 1, PlayerSettings::kMostScale);
}

void GameOptions::useKeys() { input_.setMap(applied_.keys); }

std::string GameOptions::keyChanges() const {
    return applied_.keys == project_.keys ? std::string{}
                                          : compactText(bindingChanges(project_.keys, applied_.keys));
}

/// Applies what the menu has changed.
void GameOptions::apply() {
    const PlayerSettings& now = menu_.settings();
    Window& window = screen_.window();
    if (now.fullscreen != applied_.fullscreen) {
        window.setFullscreen(now.fullscreen);
        choseFullscreen_ = true;
    }
    if (now.vsync != applied_.vsync) window.setVsync(now.vsync);
    pacer_.setCap(now.frameCap);
    sounds_.setVolumes(now.master, now.music, now.sounds);
    if (now.keys != applied_.keys) {
        input_.setMap(now.keys);
        keysChanged_ = true;
    }
    applied_ = now;
    fitWindow();
}

/// Gives the window the chosen size: after fullscreen, if it was chosen there.
void GameOptions::fitWindow() {
    if (applied_.fullscreen || applied_.scale == windowScale_) return;
    windowScale_ = applied_.scale;
    Window& window = screen_.window();
    const ScreenSettings& screen = screen_.settings();
    if (windowScale_ == 0) {
        const bool isOther = screen.standardWidth > 0;
        window.setSize(isOther ? screen.standardWidth : screen.windowWidth,
                       isOther ? screen.standardHeight : screen.windowHeight);
    } else {
        window.setSize(static_cast<int>(screen.picture.x) * windowScale_,
                       static_cast<int>(screen.picture.y) * windowScale_);
    }
}

void GameOptions::setFullscreen(bool on) {
    applied_.fullscreen = on;
    choseFullscreen_ = true;
    menu_.setFullscreen(on);
    fitWindow();
    write();
}

bool GameOptions::isOpener(const Event& event) const {
    const auto isFree = [&](BindingKind kind, auto code) {
        return !isBound(project_.keys, kind, static_cast<std::uint8_t>(code));
    };
    if (event.kind == EventKind::KeyDown)
        return event.key == Key::F10 && !event.repeated && isFree(BindingKind::Key, Key::F10);
    return event.kind == EventKind::PadDown && event.padButton == PadButton::Back &&
           isFree(BindingKind::PadButton, PadButton::Back);
}

Vec2 GameOptions::inMenu(Vec2 position) const {
    const PixelSize window = screen_.window().size();
    const Vec2 menu = optionsScreen(screen_.window().drawableSize());
    if (window.width <= 0 || window.height <= 0) return {};
    return {position.x * menu.x / static_cast<float>(window.width),
            position.y * menu.y / static_cast<float>(window.height)};
}

void GameOptions::open() {
    notice_.clear();
    menu_.setMostScale(mostScale());
    menu_.open();
}

bool GameOptions::handle(const Event& event) {
    if (!menu_.isOpen()) {
        if (!isOpener(event)) return false;
        open();
        return true;
    }
    menu_.layOut(optionsScreen(screen_.window().drawableSize()));
    const OptionsMenu::Request request = menu_.handle(event, inMenu(event.position));
    if (menu_.settings() != applied_) apply();
    if (request != OptionsMenu::Request::None) write();
    quits_ = quits_ || request == OptionsMenu::Request::Quit;
    return true;
}

void GameOptions::notify(std::string_view what, const Error& error) {
    notice_ = format("{}: {}; {}", what, error.what, error.remedy);
    noticeEnd_ = wallSeconds() + kNoticeSeconds;
}

void GameOptions::draw(AssetStore& assets) {
    if (!notice_.empty() && wallSeconds() > noticeEnd_) notice_.clear();
    if (!menu_.isOpen() && notice_.empty()) return;
    const Vec2 size = optionsScreen(screen_.window().drawableSize());
    menu_.layOut(size);
    screen_.drawOver(assets, size, [this](LabelDrawing& labels, DrawList& list) {
        if (menu_.isOpen()) {
            drawOptions(menu_, labels, list);
        } else {
            drawNotice(notice_, labels, list);
        }
    });
}

void GameOptions::write() {
    PlayerSettings now = applied_;
    if (!choseFullscreen_) now.fullscreen = written_.fullscreen;
    if ((file_ && file_->empty()) || now == written_) return;
    written_ = now;  // once, also if it fails
    const Result<Done> done = file_ ? writeSettings(*file_, settingsText(now, project_), keepsFormer_)
                                    : Result<Done>{file_.error()};
    keepsFormer_ = keepsFormer_ && !done;
    if (done) return tellPage("saved", "");
    logError("Settings", done.error());
    notify("The settings are not kept", done.error());
}

}  // namespace plumb
