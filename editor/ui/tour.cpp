#include "editor/ui/tour.hpp"

#include <array>

#include "core/text.hpp"
#include "editor/model/input/shortcut.hpp"

namespace plumb::editor::ui {
namespace {

constexpr int kDragSteps = 12;      // frames of a drag
constexpr int kMostFrames = 36000;  // maximum argument of "wait"

/// The state of a running script.
struct Player {
    const Tour::Stage& stage;
    Vec2 mouse;      // position of the mouse
    Modifiers with;  // modifier keys of the present step

    void rest(int frames = 1) const {
        for (int i = 0; i < frames; ++i) stage.frame({});
    }
    void send(Event event) const { stage.frame({std::move(event)}); }
    void sendMouse(EventKind kind, MouseButton button, int clicks = 1) const {
        send({.kind = kind,
              .modifiers = with,
              .mouseButton = button,
              .clicks = static_cast<std::uint8_t>(clicks),
              .position = mouse});
    }
    void moveTo(Vec2 at) {
        mouse = at;
        send({.kind = EventKind::MouseMoved, .modifiers = with, .position = at});
    }
    void click(Vec2 at, MouseButton button, int clicks) {
        moveTo(at);
        rest();
        for (int i = 1; i <= clicks; ++i) {
            sendMouse(EventKind::MouseDown, button, i);
            sendMouse(EventKind::MouseUp, button, i);
        }
        rest(2);
    }
};

/// Parses a point such as "160,64".
std::optional<Vec2> parsePlace(std::string_view text) {
    const std::vector<std::string_view> parts = split(text, ',');
    if (parts.size() != 2) return std::nullopt;
    const auto x = parseFloat(trimmed(parts[0])), y = parseFloat(trimmed(parts[1]));
    if (!x || !y) return std::nullopt;
    return Vec2{*x, *y};
}

/// Removes a percentage such as " 10%" from the end of a name. @return the ratio; nothing if there is none
std::optional<float> takePercent(std::string_view& name) {
    const std::size_t space = name.rfind(' ');
    if (!endsWith(name, "%") || space == name.npos) return std::nullopt;
    const auto percent = parseFloat(name.substr(space + 1, name.size() - space - 2));
    if (!percent) return std::nullopt;
    name = name.substr(0, space);
    return *percent / 100.0f;
}

/// A point of a widget, e.g. "Timeline/track 10%": a ratio of its width from the left, and optionally one of
/// its height from the top.
struct Part {
    std::string_view widget;
    Vec2 at{0.5f, 0.5f};  // ratio of the widget's size; default: its center
};
Part parsePart(std::string_view name) {
    const auto last = takePercent(name);
    const auto first = last ? takePercent(name) : std::nullopt;
    if (first) return {name, {*first, *last}};
    return {name, {last.value_or(0.5f), 0.5f}};
}

/// Returns a point in the window (px) for an argument of an action: a point of a widget, or "@x,y" in the
/// scene.
Result<Vec2> placeOf(const Player& player, std::string_view name, const std::string& where) {
    const WidgetMap& widgets = player.stage.window().widgets();
    if (!startsWith(name, "@")) {
        const Part part = parsePart(name);
        if (const WidgetMap::Widget* widget = widgets.find(part.widget))
            return widget->box.min + scaled(widget->box.size(), part.at);
        std::vector<std::string_view> names;
        for (const auto& [path, widget] : widgets.all()) names.push_back(path);
        const std::string_view near = closestName(name, names);
        return Error{where, format("\"{}\" is not on the screen", name),
                     near.empty() ? "first open the panel or menu that contains it"
                                  : format("did you mean {}?", near)};
    }
    const WidgetMap::Widget* view = widgets.find("Viewport");
    if (view == nullptr) return Error{where, "the scene view is not on the screen", "show it first"};
    return view->box.min + player.stage.workspace().view.toScreenPoint(*parsePlace(name.substr(1)));
}

/// Parses keys such as "Ctrl+Shift+Z".
std::optional<Shortcut> parseKeys(std::string_view text) {
    Shortcut keys;
    for (const std::string_view part : split(text, '+')) {
        if (part == "Ctrl") {
            keys.control = true;
        } else if (part == "Shift") {
            keys.shift = true;
        } else if (part == "Alt") {
            keys.alt = true;
        } else if (const auto key = keyFromName(part)) {
            keys.key = *key;
        } else {
            return std::nullopt;
        }
    }
    return keys.key == Key::None ? std::nullopt : std::optional{keys};
}

template <MouseButton kButton, int kClicks>
Result<Done> click(Player& player, const Tour::Step& step) {
    const Result<Vec2> at = placeOf(player, step.from, step.where);
    if (!at) return at.error();
    player.click(*at, kButton, kClicks);
    return Done{};
}

Result<Done> move(Player& player, const Tour::Step& step) {
    const Result<Vec2> at = placeOf(player, step.from, step.where);
    if (!at) return at.error();
    player.moveTo(*at);
    player.rest();
    return Done{};
}

template <MouseButton kButton>
Result<Done> drag(Player& player, const Tour::Step& step) {
    const Result<Vec2> from = placeOf(player, step.from, step.where);
    if (!from) return from.error();
    const Result<Vec2> to = placeOf(player, step.to, step.where);
    if (!to) return to.error();
    player.moveTo(*from);
    player.rest();
    player.sendMouse(EventKind::MouseDown, kButton);
    for (int i = 1; i <= kDragSteps; ++i)
        player.moveTo(lerp(*from, *to, static_cast<float>(i) / static_cast<float>(kDragSteps)));
    player.sendMouse(EventKind::MouseUp, kButton);
    player.rest(2);
    return Done{};
}

Result<Done> pressKeys(Player& player, const Tour::Step& step) {
    const Shortcut keys = *parseKeys(step.from);
    const Modifiers modifiers{keys.shift, keys.control, keys.alt};
    player.send({.kind = EventKind::KeyDown, .key = keys.key, .modifiers = modifiers});
    player.send({.kind = EventKind::KeyUp, .key = keys.key, .modifiers = {}});
    player.rest(2);
    return Done{};
}

template <EventKind kKind>
Result<Done> holdKey(Player& player, const Tour::Step& step) {
    player.send({.kind = kKind, .key = parseKeys(step.from)->key, .modifiers = {}});
    return Done{};
}

Result<Done> type(Player& player, const Tour::Step& step) {
    for (const char letter : step.from) player.send({.kind = EventKind::TextInput, .text = {letter}});
    player.rest();
    return Done{};
}

Result<Done> wait(Player& player, const Tour::Step& step) {
    player.rest(static_cast<int>(*parseInt(step.from)));
    return Done{};
}

Result<Done> takePicture(Player& player, const Tour::Step& step) { return player.stage.picture(step.from); }

bool isPlace(const Tour::Step& step) {
    const auto good = [](std::string_view name) {
        return !name.empty() && (name[0] != '@' || parsePlace(name.substr(1)));
    };
    return good(step.from) && (step.verb != "drag" && step.verb != "right-drag" ? true : good(step.to));
}
bool isKeys(const Tour::Step& step) { return parseKeys(step.from).has_value(); }
bool isText(const Tour::Step& step) { return !step.from.empty(); }
bool isCount(const Tour::Step& step) {
    const auto frames = parseInt(step.from);
    return frames && *frames > 0 && *frames <= kMostFrames;
}

struct Verb {
    std::string_view name;
    std::string_view example;
    bool (*isWhole)(const Tour::Step& step);
    Result<Done> (*play)(Player& player, const Tour::Step& step);
};

constexpr std::array kVerbs{
    Verb{"click", "click Toolbar/Play", isPlace, &click<MouseButton::Left, 1>},
    Verb{"double-click", "double-click @160,64", isPlace, &click<MouseButton::Left, 2>},
    Verb{"right-click", "right-click @160,64", isPlace, &click<MouseButton::Right, 1>},
    Verb{"move", "move @160,64", isPlace, &move},
    Verb{"drag", "drag @0,0 to @64,0", isPlace, &drag<MouseButton::Left>},
    Verb{"right-drag", "right-drag @0,0 to @64,0", isPlace, &drag<MouseButton::Right>},
    Verb{"key", "key Ctrl+Shift+Z", isKeys, &pressKeys},
    Verb{"press", "press Right", isKeys, &holdKey<EventKind::KeyDown>},
    Verb{"release", "release Right", isKeys, &holdKey<EventKind::KeyUp>},
    Verb{"type", "type some text", isText, &type},
    Verb{"wait", "wait 30", isCount, &wait},
    Verb{"picture", "picture images/first.png", isText, &takePicture},
};

const Verb* findVerb(std::string_view name) {
    for (const Verb& verb : kVerbs) {
        if (verb.name == name) return &verb;
    }
    return nullptr;
}

/// Parses and removes modifier keys at the end of a mouse action: "... with Ctrl+Shift".
/// @return false if the keys are invalid
bool takeModifiers(Tour::Step& step) {
    constexpr std::string_view kWith = " with ";
    const std::size_t at = step.from.rfind(kWith);
    if (step.verb == "type" || at == std::string::npos) return true;
    const auto keys = parseKeys(step.from.substr(at + kWith.size()) + "+A");
    step.from.resize(at);
    if (keys) step.with = {keys->shift, keys->control, keys->alt};
    return keys.has_value();
}

Result<Tour::Step> readStep(std::string_view line, std::string where) {
    const std::size_t end = line.find(' ');
    const std::string_view name = line.substr(0, end);
    const Verb* verb = findVerb(name);
    if (verb == nullptr) {
        std::string all;
        for (const Verb& known : kVerbs) all += (all.empty() ? "" : ", ") + std::string{known.name};
        return Error{std::move(where), format("unknown action \"{}\"", name), "the actions are: " + all};
    }
    Tour::Step step{verb->name, {}, {}, {}, std::move(where)};
    if (end != line.npos) step.from = trimmed(line.substr(end));
    if (!takeModifiers(step))
        return Error{step.where, "the keys after \"with\" are not modifier keys",
                     "write e.g. \"click @16,16 with Ctrl+Shift\""};
    constexpr std::string_view kTo = " to ";
    if (const std::size_t to = step.from.find(kTo); endsWith(verb->name, "drag") && to != step.from.npos) {
        step.to = trimmed(std::string_view{step.from}.substr(to + kTo.size()));
        step.from.resize(to);
    }
    if (verb->isWhole(step)) return step;
    return Error{step.where, format("\"{}\" is not a complete action", line),
                 format("write e.g. \"{}\"", verb->example)};
}

}  // namespace

Result<Tour> Tour::read(std::string_view text, std::string_view name) {
    Tour tour;
    int number = 0;
    for (const std::string_view raw : split(text, '\n')) {
        ++number;
        const std::string_view line = trimmed(raw);
        if (line.empty() || line[0] == '#') continue;
        Result<Step> step = readStep(line, format("{}:{}", name, number));
        if (!step) return step.error();
        tour.steps_.push_back(std::move(*step));
    }
    return tour;
}

Result<Done> Tour::play(const Stage& stage) const {
    Player player{stage, {}, {}};
    player.rest(3);  // frames until the layout of the panes is stable
    for (const Step& step : steps_) {
        player.with = step.with;
        if (Result<Done> done = findVerb(step.verb)->play(player, step); !done) return done.error();
    }
    return Done{};
}

}  // namespace plumb::editor::ui
