#pragma once

#include "editor/model/play/game_session.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {

/// An editor window with helpers for tests of the inspector.
class Inspector : public EditorFixture {
protected:
    Inspector() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        workspace.makeSession = [this](const std::string& path, const std::string& text) {
            Project project;
            project.root = workspace.project.root;
            return makeGameSession(project, path, text);
        };
    }
    void select(std::initializer_list<const char*> names) {
        std::vector<ObjectId> ids;
        for (const char* name : names) ids.push_back(named(name));
        workspace.document.selection.set(ids);
        hands.rest(2);
    }
    template <class T>
    [[nodiscard]] const T& of(std::string_view name) const {
        return workspace.document.world.get<T>(workspace.document.find(named(name)));
    }
    template <class T>
    void give(std::string_view name, const T& component) {
        World& world = workspace.document.world;
        const EntityId entity = workspace.document.find(named(name));
        if (!world.has<T>(entity)) world.add<T>(entity);
        world.get<T>(entity) = component;
        ++workspace.document.sceneRevision;
    }
    [[nodiscard]] const WidgetMap::Widget* widget(std::string_view path) const {
        return window.widgets().find(path);
    }
    [[nodiscard]] std::string valueOf(std::string_view path) const {
        EXPECT_NE(widget(path), nullptr) << path << " is not on the screen";
        return widget(path) == nullptr ? std::string{} : widget(path)->value;
    }
    void menu(std::string_view path, std::string_view entry) {
        hands.clickAt(hands.middleOf(path), MouseButton::Right);
        hands.click(entry);
        hands.rest();
    }
    void doubleClick(std::string_view path) {
        hands.rest(30);  // so that the first click is not counted as a third click
        hands.moveTo(hands.middleOf(path));
        hands.press(), hands.release(), hands.press(), hands.release();
        hands.rest(3);
    }
    void dragBy(std::string_view path, float pixels) {
        hands.rest(30);  // so that the press is not counted as a double click with an earlier one
        const Vec2 at = hands.middleOf(path);
        hands.drag(at, at + Vec2{pixels, 0.0f});
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

inline constexpr std::string_view kX = "Inspector/Transform/position.x";
inline constexpr std::string_view kY = "Inspector/Transform/position.y";

}  // namespace plumb::editor::ui
