#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/hash.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/document/bounds.hpp"
#include "tests/editor/support/hands.hpp"

namespace plumb::editor::ui {

/// Performs random actions in the editor: any action of the action table, any visible widget, any tool in the
/// viewport, keys, text, clipboard, playing and rewinding. Deterministic for a seed. New actions and widgets
/// are included automatically, because both are enumerated at run time.
class Monkey {
public:
    Monkey(Workspace& workspace, EditorWindow& window, std::uint64_t seed)
        : workspace_{workspace}, window_{window}, seed_{seed}, random_{Random::seeded(seed)} {}

    /// Performs action number `number`. The result depends only on the number, the seed and the state of the
    /// editor, so that a run can be repeated with some numbers omitted.
    /// @return description of the action, for the report of a failure
    std::string act(std::uint64_t number) {
        leaveWelcome();
        random_ = Random::seeded(mixBits(seed_) + number);
        if (workspace_.play.running() && below(8) == 0) return stop();
        const std::uint32_t chance = below(100);
        if (chance < 42) return anyAction();
        if (chance < 60) return anySelection();
        if (chance < 74) return anyStroke();
        if (chance < 86) return anyWidget();
        if (chance < 92) return anyKey();
        if (chance < 95) return anyClipboard();
        return anyTime();
    }

    /// Releases all buttons and keys, closes all menus and dialogs and stops the game.
    void calm() {
        frame({{.kind = EventKind::MouseUp, .mouseButton = MouseButton::Left, .position = at_},
               {.kind = EventKind::MouseUp, .mouseButton = MouseButton::Right, .position = at_},
               {.kind = EventKind::MouseUp, .mouseButton = MouseButton::Middle, .position = at_}});
        for (const Key key : {Key::LeftControl, Key::LeftShift, Key::LeftAlt, Key::Space})
            frame({{.kind = EventKind::KeyUp, .key = key}});
        for (int i = 0; i < 4; ++i) press(Key::Escape);
        workspace_.stopPlaying();
        workspace_.offeredChanges.clear();
        workspace_.tool().cancel(workspace_.tools());
        workspace_.undo.endGesture();
        frame({}), frame({});
    }

private:
    std::uint32_t below(std::size_t count) { return random_.below(static_cast<std::uint32_t>(count)); }
    template <class List>
    auto& any(List& list) {
        return list[below(list.size())];
    }
    void frame(const std::vector<Event>& events) { window_.frame({events}); }
    void press(Key key, Modifiers modifiers = {}) {
        frame({{.kind = EventKind::KeyDown, .key = key, .modifiers = modifiers}});
        frame({{.kind = EventKind::KeyUp, .key = key}});
    }

    /// True for actions that are never performed: they end the program, open files outside the project or
    /// take time without testing anything new.
    static bool excluded(std::string_view id) {
        return id.empty() || id == "file.quit" || id == "file.import" || id == "file.welcome";
    }
    /// Closes the welcome screen, which keys may have opened: its buttons would create projects.
    void leaveWelcome() {
        for (int i = 0; i < 4 && window_.widgets().find("Welcome/Create") != nullptr; ++i) press(Key::Escape);
    }

    std::string anyAction() {
        const std::span<const Action> table = actionTable();
        const Action& action = table[below(table.size())];
        if (excluded(action.id)) return "nothing";
        // Run actions are performed less often: otherwise nearly all time would be spent in games.
        if (startsWith(action.id, "run.") && below(4) != 0) return "nothing";
        // Select all and undo are performed less often: otherwise the scene would be empty most of the time.
        if ((action.id == "edit.selectAll" || action.id == "edit.undo") && below(3) != 0) return "nothing";
        runAction(workspace_, action.id);
        if (below(2) == 0) workspace_.undo.endGesture();
        return std::string{action.id};
    }

    std::string anySelection() {
        const std::vector<ObjectId>& all = workspace_.document.objects();
        if (all.empty()) return "nothing to select";
        std::vector<ObjectId> selected;
        for (std::uint32_t i = below(4) + 1; i > 0; --i) selected.push_back(all[below(all.size())]);
        workspace_.document.selection.clear();
        for (const ObjectId id : selected) workspace_.document.selection.add(id);
        return "select";
    }

    /// Drags the current tool over a random position in the scene.
    std::string anyStroke() {
        if (!workspace_.canEdit() || workspace_.document.scenePath.empty()) return "nothing";
        Pointer pointer;
        pointer.grid = workspace_.grid.size;
        pointer.snap = below(2) == 0;
        pointer.modifiers = {below(4) == 0, below(6) == 0, below(6) == 0};
        pointer.secondary = below(8) == 0 && workspace_.paintsTiles();
        pointer.position = place();
        const ToolContext context = workspace_.tools();
        workspace_.tool().press(context, pointer);
        for (std::uint32_t i = below(6); i > 0; --i) {
            pointer.position =
                pointer.position + Vec2{random_.between(-40.0f, 40.0f), random_.between(-40.0f, 40.0f)};
            workspace_.tool().drag(context, pointer);
        }
        if (below(12) == 0) {
            workspace_.tool().cancel(context);
        } else {
            workspace_.tool().release(context, pointer);
        }
        workspace_.undo.endGesture();
        return std::string{"stroke of "} + std::string{toolTable()[workspace_.toolIndex()].action};
    }

    Vec2 place() {
        const std::vector<ObjectId>& all = workspace_.document.objects();
        if (!all.empty() && below(2) == 0) {
            const EntityId entity = workspace_.document.find(all[below(all.size())]);
            if (hasTransform(workspace_.document.world, entity))
                return boundsOf(workspace_.document.world, entity).center();
        }
        return {random_.between(-100.0f, 900.0f), random_.between(-100.0f, 400.0f)};
    }

    std::string anyWidget() {
        std::vector<std::string> names;
        for (const auto& [name, widget] : window_.widgets().all()) {
            const bool leaves = name.find("Quit") != std::string::npos ||
                                name.find("Import") != std::string::npos ||
                                name.find("Projects...") != std::string::npos;
            if (!leaves) names.push_back(name);
        }
        if (names.empty()) return "no widget";
        const std::string name = any(names);
        const WidgetMap::Widget* widget = window_.widgets().find(name);
        at_ = widget->box.center();
        const MouseButton button = below(6) == 0 ? MouseButton::Right : MouseButton::Left;
        frame({{.kind = EventKind::MouseMoved, .position = at_}});
        frame({{.kind = EventKind::MouseDown, .mouseButton = button, .position = at_}});
        if (below(3) == 0) {
            for (int i = 0; i < 3; ++i) {
                at_ = at_ + Vec2{random_.between(-50.0f, 50.0f), random_.between(-30.0f, 30.0f)};
                frame({{.kind = EventKind::MouseMoved, .position = at_}});
            }
        }
        frame({{.kind = EventKind::MouseUp, .mouseButton = button, .position = at_}});
        return "widget " + name;
    }

    std::string anyKey() {
        const auto key = static_cast<Key>(1 + below(kKeyCount - 1));
        const Modifiers modifiers{below(4) == 0, below(4) == 0 && key != Key::Q, below(8) == 0};
        if (below(3) == 0) {
            constexpr std::array kTexts{"12",  "-3.5e9",   "*2", "+=10",   "nan",
                                        "a b", "\xc3\xa4", "0",  "level1", "("};
            frame({{.kind = EventKind::TextInput, .text = kTexts[below(kTexts.size())]}});
            press(Key::Enter);
            return "text";
        }
        press(key, modifiers);
        return "key " + std::string{nameOf(key)};
    }

    std::string anyClipboard() {
        switch (below(4)) {
            case 0: workspace_.clipboard = "no entities"; break;
            case 1: workspace_.clipboard.resize(workspace_.clipboard.size() / 2); break;
            case 2:
                if (!workspace_.clipboard.empty())
                    workspace_.clipboard[below(workspace_.clipboard.size())] =
                        static_cast<char>(32 + below(90));
                break;
            default: runAction(workspace_, "edit.copy"); break;
        }
        runAction(workspace_, "edit.paste");
        return "clipboard";
    }

    /// Undoes, redoes or moves in the history; in a game: plays, rewinds or changes a value.
    std::string anyTime() {
        PlayMode& play = workspace_.play;
        if (!play.running()) {
            if (below(6) == 0) {
                workspace_.undo.jumpTo(below(workspace_.undo.total() + 1));
                return "history";
            }
            if (below(3) != 0) {
                runAction(workspace_, below(2) == 0 ? "edit.undo" : "edit.redo");
                return "undo or redo";
            }
            runAction(workspace_, "run.play");
            return "play";
        }
        switch (below(5)) {
            case 0:
                play.seek(static_cast<std::int64_t>(below(static_cast<std::size_t>(play.newest()) + 2)) - 1);
                break;
            case 1:
                for (std::uint32_t i = below(20); i > 0; --i) play.step({});
                break;
            case 2: editRunning(); break;
            case 3: play.setPaused(!play.paused()); break;
            default: runAction(workspace_, "run.watch"); break;
        }
        return "time";
    }

    std::string stop() {
        workspace_.stopPlaying();
        for (KeepRow& row : workspace_.offeredChanges) row.keep = below(2) == 0;
        workspace_.keepTicked();
        return "stop";
    }

    void editRunning() {
        const std::vector<ObjectId>& all = workspace_.document.objects();
        if (all.empty()) return;
        const ObjectId id = all[below(all.size())];
        const TypeInfo* type = workspace_.document.types().find("Transform");
        const Vec2 to{random_.between(-100.0f, 900.0f), random_.between(-100.0f, 400.0f)};
        workspace_.play.edit(id, *type, *type->find("position"), FieldValue::of(to));
    }

    Workspace& workspace_;
    EditorWindow& window_;
    std::uint64_t seed_;
    Random random_;
    Vec2 at_;
};

}  // namespace plumb::editor::ui
