#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/model/workspace.hpp"
#include "input/action_map.hpp"
#include "platform/events.hpp"
#include "reflect/json.hpp"

namespace plumb::editor {

/// The actions and axes of a project with their keys, buttons and sticks: the "input" part of project.json.
/// Every change is one step of undo and is in the file at once; the rest of the file stays as it is. A game
/// that plays has it from its next new tick on.
class InputMapEdit {
public:
    enum class Kind : unsigned char { Action, Axis };
    /// One list of keys: of an action all of them, of an axis one side or its sticks.
    struct Part {
        std::string key;  ///< "negative", "positive", "analog"; empty for an action
        std::vector<Binding> bindings;
    };
    struct Row {
        Kind kind = Kind::Action;
        std::string name;
        bool ofProject = false;  ///< else it is what every game has that says nothing else
        std::vector<Part> parts;
    };
    /// One list in the map.
    struct Place {
        Kind kind = Kind::Action;
        std::string name;
        std::string part;  ///< as Part::key
    };

    explicit InputMapEdit(Workspace& workspace) : workspace_{workspace} {}

    /// Reads the file again when it is another one. @return what is wrong with it; empty for nothing
    const std::string& refresh();
    /// Actions first, then axes.
    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
    /// What else a key means: "Jump", "Vertical, negative".
    [[nodiscard]] std::vector<std::string> othersOf(Binding binding, const Place& but) const;
    /// How many keys mean more than one thing.
    [[nodiscard]] std::size_t shared() const;

    // Changes. @error says why not, for the person

    Result<Done> add(Kind kind, std::string_view name);
    /// Scenes and prefabs that name it follow, all or none; the notice says in how many places.
    Result<Done> rename(Kind kind, const std::string& from, std::string_view to);
    /// One that every game has gets its usual keys back.
    Result<Done> remove(Kind kind, const std::string& name);
    Result<Done> bind(const Place& place, Binding binding);
    Result<Done> unbind(const Place& place, std::size_t index);

private:
    /// Whether the map can be changed now, as the file is now.
    Result<Done> ready();
    Result<Done> write(std::string label, Json project);
    /// The file with a list of the project's own at this place.
    [[nodiscard]] Json withList(const Place& place, const std::vector<Binding>& bindings) const;
    [[nodiscard]] const Part* find(const Place& place) const;
    [[nodiscard]] const Row* find(Kind kind, std::string_view name) const;
    Result<Done> checkName(Kind kind, std::string_view name) const;

    Workspace& workspace_;
    std::optional<std::string> text_;  // of the file, as it was read last
    Json project_ = Json::object();
    std::vector<Row> rows_;
    std::string problem_;
    bool readable_ = false;
};

/// The key, button or stick that an event is about, when it was pressed or pushed; what belongs to no device,
/// and modifiers that are let go, are nothing.
std::optional<Binding> bindingOf(const Event& event);

}  // namespace plumb::editor
