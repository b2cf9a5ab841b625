#include "app/options/options_menu.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/text.hpp"

namespace plumb {
namespace {

constexpr float kWidth = 420.0f;  // px, of the panel
constexpr float kGap = 8.0f;      // px, above a group of rows
constexpr float kEdge = 12.0f;    // px, least distance of the panel from the screen's border
constexpr float kPushed = 0.6f;   // ratio from which on a stick counts as pushed
constexpr float kVolumeStep = 0.1f;
constexpr std::array kCaps{0, 30, 60, 90, 120, 144, 165, 240};

// Rows of the first page.
enum MainRow : std::size_t { Fullscreen, Size, Vsync, Cap, Master, Music, Sounds, Controls, Back, Quit };

std::string onOff(bool on) { return on ? "On" : "Off"; }

/// Names of bindings, e.g. "Space, Pad A"; as many as fit.
std::string namesOf(const std::vector<Binding>& bindings) {
    constexpr std::size_t kMost = 34;
    std::string names;
    for (const Binding binding : bindings) {
        const std::string name = toText(binding);
        if (!names.empty() && names.size() + name.size() + 2 > kMost) return names + " ...";
        names += names.empty() ? name : ", " + name;
    }
    return names.empty() ? "none" : names;
}

/// Labels of the two directions of an axis.
std::pair<std::string, std::string> directionsOf(const std::string& axis) {
    if (axis == "Horizontal") return {"Left", "Right"};
    if (axis == "Vertical") return {"Up", "Down"};
    return {axis + " -", axis + " +"};
}

bool isPad(const Binding& binding) {
    return binding.kind != BindingKind::Key && binding.kind != BindingKind::MouseButton;
}

/// What an event binds; nothing for one that is not a key or a button.
std::optional<Binding> bindingOf(const Event& event) {
    switch (event.kind) {
        case EventKind::KeyDown: return Binding{BindingKind::Key, static_cast<std::uint8_t>(event.key)};
        case EventKind::MouseDown:
            return Binding{BindingKind::MouseButton, static_cast<std::uint8_t>(event.mouseButton)};
        case EventKind::PadDown:
            return Binding{BindingKind::PadButton, static_cast<std::uint8_t>(event.padButton)};
        case EventKind::PadAxisMoved:
            if (std::abs(event.value) < kPushed) return std::nullopt;
            return Binding{event.value > 0.0f ? BindingKind::PadAxisPlus : BindingKind::PadAxisMinus,
                           static_cast<std::uint8_t>(event.padAxis)};
        default: return std::nullopt;
    }
}

/// The key that a button of a pad stands for in the menu; None for others.
Key keyOf(PadButton button) {
    switch (button) {
        case PadButton::A: return Key::Enter;
        case PadButton::B:
        case PadButton::Back:
        case PadButton::Start: return Key::Escape;
        case PadButton::Up: return Key::Up;
        case PadButton::Down: return Key::Down;
        case PadButton::Left: return Key::Left;
        case PadButton::Right: return Key::Right;
        default: return Key::None;
    }
}

/// True for what opens and leaves the menu itself: a game that had these keys could not be configured any
/// more.
bool isOfMenu(const Event& event) {
    const auto isKey = [&](Key key) { return event.kind == EventKind::KeyDown && event.key == key; };
    return isKey(Key::Escape) || isKey(Key::F10) || isKey(Key::F11) ||
           (event.kind == EventKind::PadDown && event.padButton == PadButton::Back);
}

/// True for the left stick of a pad.
bool isOfStick(const Event& event) {
    return event.kind == EventKind::PadAxisMoved &&
           (event.padAxis == PadAxis::LeftX || event.padAxis == PadAxis::LeftY);
}

bool isArrow(Key key) { return key == Key::Up || key == Key::Down || key == Key::Left || key == Key::Right; }

OptionsMenu::Row choice(std::string label, std::string value) {
    return {OptionsMenu::Kind::Choice, std::move(label), std::move(value)};
}

OptionsMenu::Row volume(std::string label, float ratio) {
    return {OptionsMenu::Kind::Volume, std::move(label),
            format("{} %", static_cast<int>(std::lround(ratio * 100.0f))), ratio};
}

}  // namespace

OptionsMenu::OptionsMenu(PlayerSettings settings, PlayerSettings project)
    : settings_{std::move(settings)}, project_{std::move(project)} {
    rebuild();
}

void OptionsMenu::open() {
    isOpen_ = true;
    stick_.reset();
    show(Page::Main);
}

void OptionsMenu::setFullscreen(bool on) {
    settings_.fullscreen = on;
    rebuild();
}

std::string_view OptionsMenu::title() const { return page_ == Page::Main ? "Options" : "Controls"; }

std::string OptionsMenu::hint() const {
    if (captures_) return "Press a key or a button. Escape: keep the present ones";
    if (std::string other = conflict(); !other.empty()) return other;
    switch (rows_[selected_].kind) {
        case Kind::Choice:
        case Kind::Volume: return "Left and Right change it";
        case Kind::Binding:
            return keysAllowed_ ? "Enter: another key or button"
                                : "Keys cannot be changed in a recording or a replay";
        case Kind::Command: return page_ == Page::Main ? "Escape: back to the game" : "Escape: back";
    }
    return {};
}

/// Names an action that has a key of the selected one, too, unless both have it in the game's own bindings.
std::string OptionsMenu::conflict() const {
    if (page_ != Page::Keys || rows_[selected_].kind != Kind::Binding) return {};
    PlayerSettings now = settings_, own = project_;
    const std::vector<Bound> all = boundsOf(now.keys), intended = boundsOf(own.keys);
    const auto has = [](const Bound& bound, const Binding& binding) {
        return std::find(bound.bindings->begin(), bound.bindings->end(), binding) != bound.bindings->end();
    };
    for (const Binding& binding : *all[selected_].bindings) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            const bool isIntended = has(intended[i], binding) && has(intended[selected_], binding);
            if (i != selected_ && has(all[i], binding) && !isIntended)
                return format("{} is also {}", toText(binding), all[i].label);
        }
    }
    return {};
}

std::vector<OptionsMenu::Bound> OptionsMenu::boundsOf(ActionMap& keys) {
    std::vector<Bound> all;
    for (ActionBindings& action : keys.actions) all.push_back({action.name, &action.bindings});
    for (AxisBindings& axis : keys.axes) {
        const auto [negative, positive] = directionsOf(axis.name);
        all.push_back({negative, &axis.negative});
        all.push_back({positive, &axis.positive});
    }
    return all;
}

void OptionsMenu::rebuild() {
    rows_.clear();
    if (page_ == Page::Main) {
        const PlayerSettings& s = settings_;
        rows_.push_back(choice("Fullscreen", onOff(s.fullscreen)));
        rows_.push_back(choice("Window size", s.scale == 0 ? "Standard" : format("{} x", s.scale)));
        rows_.push_back(choice("Wait for the display", onOff(s.vsync)));
        rows_.push_back(choice("Frame limit", s.frameCap == 0 ? "Automatic" : format("{} Hz", s.frameCap)));
        rows_.push_back(volume("Volume", s.master));
        rows_.back().begins = true;
        rows_.push_back(volume("Music", s.music));
        rows_.push_back(volume("Sounds", s.sounds));
        for (const char* label : {"Controls", "Back to the game", "Quit the game"})
            rows_.push_back({Kind::Command, label, {}});
        rows_[Controls].begins = true;
    } else {
        for (const Bound& bound : boundsOf(settings_.keys))
            rows_.push_back({Kind::Binding, bound.label, namesOf(*bound.bindings)});
        for (const char* label : {"Standard keys", "Back"}) rows_.push_back({Kind::Command, label, {}});
        rows_[rows_.size() - 2].begins = true;
        if (captures_) rows_[selected_].value = "...";
    }
    selected_ = std::min(selected_, rows_.size() - 1);
    layOut(screen_);
}

void OptionsMenu::show(Page page) {
    page_ = page;
    selected_ = first_ = 0;
    captures_ = drags_ = false;
    rebuild();
}

// ---- places

AABB OptionsMenu::valueBox(const Row& row) {
    const float right = row.box.max.x - 8.0f;
    const float wide = row.kind == Kind::Volume   ? kSlider + 58.0f
                       : row.kind == Kind::Choice ? 150.0f
                                                  : 260.0f;
    return {{right - wide, row.box.min.y}, {right, row.box.max.y}};
}

void OptionsMenu::layOut(Vec2 screen) {
    screen_ = screen;
    const float most = screen.y - 2.0f * kEdge - kHead - kFoot;
    const auto heightOf = [&](std::size_t i) {
        return kRow + (rows_[i].begins && i != first_ ? kGap : 0.0f);
    };
    float height = 0.0f;
    for (shown_ = 0; first_ + shown_ < rows_.size() && height + heightOf(first_ + shown_) <= most; ++shown_)
        height += heightOf(first_ + shown_);
    const Vec2 size{std::min(kWidth, screen.x - 2.0f * kEdge), kHead + height + kFoot};
    const Vec2 corner{std::floor((screen.x - size.x) * 0.5f), std::floor((screen.y - size.y) * 0.5f)};
    panel_ = {corner, corner + size};
    float y = corner.y + kHead;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (i < first_ || i >= first_ + shown_) {
            rows_[i].box = {};
            continue;
        }
        y += heightOf(i);
        rows_[i].box = {{corner.x + kMargin, y - kRow}, {corner.x + size.x - kMargin, y}};
    }
}

/// Shows the selected row.
void OptionsMenu::scroll() {
    if (selected_ < first_) first_ = selected_;
    layOut(screen_);
    while (selected_ >= first_ + shown_ && first_ + 1 < rows_.size()) {
        ++first_;
        layOut(screen_);
    }
}

// ---- input

OptionsMenu::Request OptionsMenu::handle(const Event& event, Vec2 mouse) {
    if (isOfStick(event) && !beginsPush(event)) return Request::None;
    if (captures_) return capture(event), Request::None;
    switch (event.kind) {
        case EventKind::KeyDown:
            if (event.repeated && !isArrow(event.key)) break;
            return press(event.key);
        case EventKind::PadDown: return press(keyOf(event.padButton));
        case EventKind::PadAxisMoved:
            if (!isOfStick(event)) break;
            if (event.padAxis == PadAxis::LeftX) return press(event.value > 0.0f ? Key::Right : Key::Left);
            return press(event.value > 0.0f ? Key::Down : Key::Up);
        case EventKind::MouseWheel:
            if (event.motion.y != 0.0f) select(event.motion.y > 0.0f ? -1 : 1);
            break;
        case EventKind::MouseUp: drags_ = false; break;
        case EventKind::MouseMoved:
        case EventKind::MouseDown: {
            const bool isPressed =
                event.kind == EventKind::MouseDown && event.mouseButton == MouseButton::Left;
            for (std::size_t i = first_; i < first_ + shown_ && !drags_; ++i) {
                if (!contains(rows_[i].box, mouse)) continue;
                selected_ = i;
                if (!isPressed) break;
                const Row& row = rows_[i];
                const AABB value = valueBox(row);
                if (row.kind == Kind::Volume) {
                    drags_ = mouse.x >= value.min.x - 8.0f;
                } else if (row.kind == Kind::Choice) {
                    change(mouse.x < (value.min.x + value.max.x) * 0.5f && mouse.x >= value.min.x ? -1 : 1);
                } else {
                    return activate();
                }
                break;
            }
            if (drags_) {
                const float from = valueBox(rows_[selected_]).min.x;
                const float ratio = std::clamp((mouse.x - from) / kSlider, 0.0f, 1.0f);
                float* const volumes[] = {&settings_.master, &settings_.music, &settings_.sounds};
                *volumes[selected_ - Master] = std::round(ratio * 20.0f) / 20.0f;
                rebuild();
            }
            break;
        }
        default: break;
    }
    return Request::None;
}

/// Follows the left stick. @return true for the first of the events of a push
bool OptionsMenu::beginsPush(const Event& event) {
    if (std::abs(event.value) >= kPushed) return !std::exchange(stick_, event.padAxis);
    if (stick_ == event.padAxis) stick_.reset();
    return false;
}

OptionsMenu::Request OptionsMenu::press(Key key) {
    drags_ = false;
    switch (key) {
        case Key::Up: select(-1); break;
        case Key::Down: select(1); break;
        case Key::Left: change(-1); break;
        case Key::Right: change(1); break;
        case Key::Enter:
        case Key::PadEnter:
        case Key::Space: return activate();
        case Key::Escape:
        case Key::Backspace: return back();
        case Key::F10: isOpen_ = false; return Request::Close;
        default: break;
    }
    return Request::None;
}

void OptionsMenu::select(int step) {
    drags_ = false;  // it is of the selected row
    const int count = static_cast<int>(rows_.size());
    selected_ = static_cast<std::size_t>((static_cast<int>(selected_) + step + count) % count);
    scroll();
}

OptionsMenu::Request OptionsMenu::back() {
    if (page_ == Page::Keys) {
        show(Page::Main);
        selected_ = Controls;
        scroll();
        return Request::None;
    }
    isOpen_ = false;
    return Request::Close;
}

OptionsMenu::Request OptionsMenu::activate() {
    const std::size_t row = selected_;
    if (rows_[row].kind == Kind::Choice || rows_[row].kind == Kind::Volume) {
        if (rows_[row].kind == Kind::Choice) change(1);
        return Request::None;
    }
    if (page_ == Page::Keys) {
        if (rows_[row].kind == Kind::Binding) {
            captures_ = keysAllowed_;
        } else if (row + 1 == rows_.size()) {
            return back();
        } else if (keysAllowed_) {
            settings_.keys = project_.keys;
        }
        rebuild();
        return Request::None;
    }
    if (row == Controls) return show(Page::Keys), Request::None;
    isOpen_ = false;
    return row == Quit ? Request::Quit : Request::Close;
}

void OptionsMenu::change(int direction) {
    if (page_ != Page::Main) return;
    PlayerSettings& s = settings_;
    const auto step = [direction](float& ratio) {
        ratio = std::clamp(std::round((ratio + kVolumeStep * static_cast<float>(direction)) * 20.0f) / 20.0f,
                           0.0f, 1.0f);
    };
    switch (selected_) {
        case Fullscreen: s.fullscreen = !s.fullscreen; break;
        case Size: {
            const int count = mostScale_ + 1;
            s.scale = (std::min(s.scale, mostScale_) + direction + count) % count;
            break;
        }
        case Vsync: s.vsync = !s.vsync; break;
        case Cap: {
            const auto at = std::lower_bound(kCaps.begin(), kCaps.end(), s.frameCap) - kCaps.begin();
            const auto count = static_cast<std::ptrdiff_t>(kCaps.size());
            s.frameCap = kCaps[static_cast<std::size_t>((at + direction + count) % count)];
            break;
        }
        case Master: step(s.master); break;
        case Music: step(s.music); break;
        case Sounds: step(s.sounds); break;
        default: return;
    }
    rebuild();
}

// ---- keys

/// Binds the key or button of an event. Other events change nothing, so that the same row stays selected.
void OptionsMenu::capture(const Event& event) {
    const std::optional<Binding> binding = bindingOf(event);
    if (!binding || event.repeated) return;
    captures_ = false;
    if (!isOfMenu(event)) bind(*binding);
    rebuild();
}

/// Replaces the bindings of the selected row for this kind of device: keyboard and mouse, or gamepad.
void OptionsMenu::bind(Binding binding) {
    std::vector<Binding>& bindings = *boundsOf(settings_.keys)[selected_].bindings;
    std::erase_if(bindings, [&](const Binding& other) { return isPad(other) == isPad(binding); });
    bindings.insert(isPad(binding) ? bindings.end() : bindings.begin(), binding);
}

}  // namespace plumb
